// A ring under pressure from outside, which collapses and touches itself.
#pragma once

#include "bodies/self_contact.h"
#include "coupled/held_tubes.h"

namespace vasorod::testing {

/// A tube as thin as a ring with the pressure q D / R^3 from outside, between soft sections. Its
/// faces touch where the middle surfaces do. It is oval by 2e-4 of its radius, which decides the
/// direction in which it collapses and moves its areas by 0.1 %.
struct CollapsedRing {
  static constexpr double radius = 10, thickness = 0.2;
  static constexpr int around = 96, along = 4;
  HeldTube tube{2.3, radius, thickness, around, along, 0};

  CollapsedRing() {
    tube.surface.points.col(0) *= 1.0002;
    tube.surface.points.col(1) *= 0.9998;
    tube.wall.rest = tube.surface;
  }

  CoupledProblem under(double q) const {
    CoupledProblem problem = bent(tube, Vec6::Zero(), soft(tube.start()), soft(tube.end()));
    const double d = thickness * thickness * thickness / 12;
    problem.vessels[0]->pressure = LumenPressure{0, -q * d / (radius * radius * radius)};
    problem.surfaces.bodies[0].thickness = 1e-3;
    problem.surfaces.bodies[0].offset = 5e-4;
    problem.surfaces.contacts = self_contacts(problem.surfaces.bodies);
    return problem;
  }

  /// In steps of half a collapse pressure (q = 3).
  CoupledSolution at(double q) const {
    CoupledOptions options;
    options.times.clear();
    for (double before = 2.5; before < q; before += 1.5) options.times.push_back(before / q);
    options.times.push_back(1);
    return CoupledSolver(under(q), options).solve();
  }

  Points middle(const CoupledSolution& solution) const {
    return solution.surface.bodies[0].positions.middleRows(along / 2 * around, around);
  }

  /// Area inside the middle section over that of the ring at rest.
  double area_ratio(const CoupledSolution& solution) const {
    return area_of(middle(solution)) / area_of(tube.surface.points.topRows(around));
  }

 private:
  // Inside a ring of points in the plane z = const.
  static double area_of(const Points& ring) {
    double area = 0;
    for (Eigen::Index i = 0; i < ring.rows(); ++i) {
      const auto a = ring.row(i), b = ring.row((i + 1) % ring.rows());
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    return area;
  }
};

}  // namespace vasorod::testing
