#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "bodies/self_contact.h"
#include "coupled/held_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Area inside a ring of points in the plane z = const.
double area_of(const Points& ring) {
  double area = 0;
  for (Eigen::Index i = 0; i < ring.rows(); ++i) {
    const auto a = ring.row(i), b = ring.row((i + 1) % ring.rows());
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

// A tube as thin as a ring, slightly oval, with the pressure q D / R^3 from outside. Its faces
// touch where the middle surfaces do.
struct Ring {
  static constexpr double radius = 10, thickness = 0.2;
  static constexpr int around = 64, along = 4;
  HeldTube tube{6, radius, thickness, around, along, 0};
  Ring() {
    tube.surface.points.col(0) *= 1.002;
    tube.surface.points.col(1) *= 0.998;
    tube.wall.rest = tube.surface;
  }
  double whole() const { return area_of(tube.surface.points.topRows(around)); }
  CoupledProblem under(double q) const {
    CoupledProblem problem = bent(tube, Vec6::Zero(), soft(tube.start()), soft(tube.end()));
    const double d = thickness * thickness * thickness / 12;
    problem.vessels[0]->pressure = LumenPressure{0, -q * d / (radius * radius * radius)};
    problem.surfaces.bodies[0].thickness = 1e-3;
    problem.surfaces.bodies[0].offset = 5e-4;
    problem.surfaces.contacts = self_contacts(problem.surfaces.bodies);
    return problem;
  }
  CoupledSolution at(double q) const {
    CoupledOptions options;
    options.times.clear();
    for (double before = 2.5; before < q; before += 0.5) options.times.push_back(before / q);
    options.times.push_back(1);
    return CoupledSolver(under(q), options).solve();
  }
};

// Flaherty, Keller and Rubinow 1972: areas over that of the circle. Opposite walls touch in a point
// from q = 5.247 on, along a line from 10.336 on.
TEST(SelfContact, ACollapsedRingIsInContactWithItselfAsPublished) {
  const Ring ring;
  struct Published {
    double q, share;
    bool touches;
  };
  for (const Published& published :
       {Published{4, 0.56639, false}, Published{5.24689, 0.27095, true},
        Published{10.3360, 0.20943, true}}) {
    const CoupledSolution solution = ring.at(published.q);
    EXPECT_EQ(solution.status, Status::buckled) << solution.brief_report();
    const Points middle = solution.surface.bodies[0].positions.middleRows(
        Ring::along / 2 * Ring::around, Ring::around);
    EXPECT_NEAR(area_of(middle) / ring.whole(), published.share, 0.03 * published.share)
        << published.q;
    const ContactSolution& contact = solution.surface.contacts.at(0);
    EXPECT_EQ(contact.within_reach, published.touches) << published.q;
    EXPECT_EQ(contact.area > 0, published.touches) << published.q;
    EXPECT_EQ(contact.force, Vec3::Zero());
    // What one wall feels the other gives: nothing is left over.
    EXPECT_LT(solution.surface.bodies[0].residual, 1e-6);
  }
}

// Without the pair the walls pass through each other.
TEST(SelfContact, WithoutItTheWallsPassThroughEachOther) {
  const Ring ring;
  CoupledProblem problem = ring.under(8);
  problem.surfaces.contacts.clear();
  CoupledOptions options;
  options.times = {0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
  const CoupledSolution solution = CoupledSolver(std::move(problem), options).solve();
  const Points& points = solution.surface.bodies[0].positions;
  const int middle = Ring::along / 2 * Ring::around;
  EXPECT_LT(points(middle + Ring::around / 4, 1), points(middle + 3 * Ring::around / 4, 1));
}

}  // namespace
}  // namespace vasorod
