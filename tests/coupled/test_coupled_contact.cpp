#include <gtest/gtest.h>

#include "coupled/coupled_contacts.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 8, length = 60, thickness = 1.2;

HeldSection moved(HeldSection section, const Vec3& by) {
  section.motion.move = by;
  return section;
}

// A tube between rigid ends, pressed by `depth` onto a perpendicular cylinder of radius 12.
CoupledProblem pressed(double depth, double gap = 0.01, int around = 32, int along = 38) {
  const HeldTube tube(length, radius, thickness, around, along);
  CoupledProblem problem;
  const Vec3 down(-depth, 0, 0);
  add_tube(problem, tube, "tube", Vec3::Zero(),
           {moved(tube.start(), down), moved(tube.end(), down)});
  TubeSpec across;
  across.length = 60;
  across.radius = 12;
  across.around = 72;
  across.along = 60;
  TriangleSurface cylinder = tube_surface(across);
  const Points p = cylinder.points;
  cylinder.points.col(0) = p.col(1).array() - radius - thickness / 2 - gap - 12;
  cylinder.points.col(1) = p.col(2).array() - 30;
  cylinder.points.col(2) = p.col(0).array() + length / 2;
  add_obstacle(problem, "cylinder", cylinder);
  problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
  carry_by_sections(problem);
  return problem;
}

Vec3 support(const CoupledSolution& s, size_t body) {
  Vec3 sum = Vec3::Zero();
  for (const SectionSolution& section : s.sections[body]) sum += section.force;
  return sum;
}

void expect_settled(const CoupledSolution& s) {
  EXPECT_EQ(s.status, Status::converged) << to_string(s.status);
  for (const BodySolution& body : s.surface.bodies) EXPECT_LT(body.residual, 1e-6);
}

TEST(CoupledContact, APressedTubeIsHeldByItsEnds) {
  CoupledSolver solver(pressed(3));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  ASSERT_EQ(s.surface.contacts.size(), 1u);
  const Vec3 force = s.surface.contacts[0].force;
  EXPECT_GT(force.x(), 0);
  EXPECT_LT((force + support(s, 0)).norm(), 1e-6 * force.norm());
  EXPECT_LT((force + s.surface.bodies[1].contact).norm(), 1e-9 * force.norm());
  EXPECT_LT(std::abs(s.surface.contacts[0].smallest_gap), 2e-3);
}

TEST(CoupledContact, ApartThePressureIsExactlyZero) {
  CoupledSolver solver(pressed(3, 3.5));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  EXPECT_EQ(s.surface.contacts[0].force, Vec3::Zero());
  EXPECT_EQ(s.surface.bodies[0].pressure.maxCoeff(), 0);
  EXPECT_EQ(s.surface.contact_energy, 0);
}

TEST(CoupledContact, TheForceDoesNotDependOnThePenalty) {
  std::vector<double> forces;
  for (const double stiffness : {3.0, 30.0}) {
    CoupledOptions options;
    options.contact_stiffness = stiffness;
    CoupledSolver solver(pressed(3), options);
    const CoupledSolution s = solver.solve();
    expect_settled(s);
    forces.push_back(s.surface.contacts[0].force.x());
  }
  EXPECT_NEAR(forces[0], forces[1], 1e-3 * forces[0]);
}

// With so soft a penalty the pressures converge slowly, by the same factor at each update: without
// extrapolation after 35.
TEST(CoupledContact, PressuresThatConvergeAlongOneLineTakeFewUpdates) {
  CoupledOptions options;
  options.contact_stiffness = 0.3;
  CoupledSolver soft(pressed(3), options), stiff(pressed(3));
  const CoupledSolution slow = soft.solve(), fast = stiff.solve();
  expect_settled(slow);
  EXPECT_LT(slow.surface.work.counts.outer, 25);
  EXPECT_GT(slow.surface.work.counts.outer, fast.surface.work.counts.outer);
  EXPECT_NEAR(slow.surface.contacts[0].force.x(), fast.surface.contacts[0].force.x(),
              1e-4 * fast.surface.contacts[0].force.x());
}

// Pressures settle over several minimisations, and the certificate is asked for once, at the end:
// without it the same minimum takes one factorisation and one Hessian less. One factor serves
// several of them.
TEST(CoupledContact, TheMinimumIsCertifiedOnce) {
  CoupledOptions options;
  CoupledSolver with(pressed(3), options);
  options.certify = false;
  CoupledSolver without(pressed(3), options);
  const CoupledSolution certified = with.solve(), bare = without.solve();
  expect_settled(certified);
  EXPECT_TRUE(certified.smallest_curvature_positive);
  EXPECT_FALSE(bare.smallest_curvature_positive);
  EXPECT_EQ(certified.surface.bodies[0].positions, bare.surface.bodies[0].positions);
  const Counts &more = certified.surface.work.counts, &less = bare.surface.work.counts;
  EXPECT_EQ(more.factorisations, less.factorisations + 1);
  EXPECT_EQ(more.hessians, less.hessians + 1);
  EXPECT_EQ(more.outer, less.outer);
  EXPECT_GT(more.outer, 3);
  EXPECT_LT(less.factorisations, 2 * less.outer);
}

// The sum of pressure times area along the cylinder's normals, compared with the supports' force.
TEST(CoupledContact, ThePressuresAddUpToTheSupports) {
  const HeldTube tube(length, radius, thickness, 32, 38);
  CoupledSolver solver(pressed(3));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  const Eigen::VectorXd areas = vertex_areas(tube.surface);
  const double center = -radius - thickness / 2 - 0.01 - 12;
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < areas.size(); ++i) {
    const Vec3 x = s.surface.bodies[0].positions.row(i);
    sum += s.surface.bodies[0].pressure[i] * areas[i] *
           Vec3(x.x() - center, 0, x.z() - length / 2).normalized();
  }
  EXPECT_NEAR(sum.x(), -support(s, 0).x(), 1e-3 * sum.x());
}

// A short tube held at its ends' mean positions is pressed onto a plate: a ring under a line load P
// per length against a distributed vertical load. For an inextensional motion a_n cos(n theta) the
// energy is pi/2 (E I / R^3) (n^2 - 1)^2 a_n^2. The contact line therefore moves relative to the
// ring's mean by P R^3 / (pi E I) sum_{n >= 2} 1 / (n^2 - 1)^2, and the sum is pi^2 / 12 - 11 / 16.
TEST(CoupledContact, ARingOnAPlateHasItsClosedFormStiffness) {
  const double t = 0.2, gap = 0.01, sink = 0.11;
  HeldTube tube(4, 8, t, 64, 6, 0);
  const Vec3 down(-sink, 0, 0);
  HeldSection start = moved(tube.start(), down), end = moved(tube.end(), down);
  start.rigid = end.rigid = false;
  CoupledProblem problem;
  add_tube(problem, tube, "ring", Vec3::Zero(), {start, end});
  add_obstacle(problem, "plate", plate(-8 - t / 2 - gap, 30, -30, 34));
  problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
  carry_by_sections(problem);
  CoupledSolver solver(std::move(problem));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  const double inertia = 4 * t * t * t / 12;
  const double exact = (sink - gap) * M_PI * inertia / (512 * (M_PI * M_PI / 12 - 11.0 / 16));
  EXPECT_NEAR(s.surface.contacts[0].force.x(), exact, 0.03 * exact);
  // On a plane the pressure's integral is the force.
  EXPECT_NEAR(
      s.surface.bodies[0].pressure.dot(vertex_areas({tube.surface.points, tube.surface.triangles})),
      s.surface.contacts[0].force.x(), 1e-9 * exact);
}

TEST(CoupledContact, TwoTubesPushEachOtherEquallyHard) {
  const HeldTube one(length, radius, thickness, 28, 32), other(length, radius, 0.8, 24, 28);
  CoupledProblem problem;
  // The other tube lies across, slightly off the middle.
  const Mat3 across = exp_rotation(Vec3(M_PI / 2, 0, 0));
  const Vec3 down(-3, 0, 0), aside(-2 * radius - 1.01, 31, 29);
  add_tube(problem, one, "one", Vec3::Zero(), {moved(one.start(), down), moved(one.end(), down)});
  add_tube(problem, other, "other", aside, {other.start(), other.end()}, across);
  problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
  carry_by_sections(problem);
  CoupledSolver solver(std::move(problem));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  EXPECT_TRUE(s.surface.bodies[1].modelled) << "touched, so it yields too";
  const double force = s.surface.contacts[0].force.norm();
  EXPECT_GT(force, 0);
  EXPECT_LT((s.surface.bodies[0].contact + s.surface.bodies[1].contact).norm(), 1e-12 * force);
  EXPECT_LT((support(s, 0) + support(s, 1)).norm(), 1e-6 * force);
  const Points rest = (other.surface.points * across.transpose()).rowwise() + aside.transpose();
  EXPECT_GT((s.surface.bodies[1].positions - rest).cwiseAbs().maxCoeff(), 0.1);
}

// Side by side, the rigid ends of one tube are moved by 3 into those of the other. The contact has
// no solution at the ends, but it has one between them that does not depend on the path.
TEST(CoupledContact, ParallelTubesWhoseRigidEndsOverlapPressInBetween) {
  const HeldTube one(length, radius, thickness, 28, 38), other(length, radius, 0.8, 24, 32);
  const Vec3 down(-3, 0, 0), beside(-2 * radius - 1.01, 0, 0);
  std::vector<double> forces;
  for (const std::vector<double>& times : {std::vector{1.0}, std::vector{0.5, 1.0}}) {
    CoupledProblem problem;
    add_tube(problem, one, "one", Vec3::Zero(), {moved(one.start(), down), moved(one.end(), down)});
    add_tube(problem, other, "other", beside, {other.start(), other.end()});
    problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
    carry_by_sections(problem);
    CoupledOptions options;
    options.times = times;
    CoupledSolver solver(std::move(problem), options);
    const CoupledSolution s = solver.solve();
    expect_settled(s);
    EXPECT_NEAR(s.surface.contacts[0].held_depth, 3 - 0.01, 0.05);
    EXPECT_GT(s.surface.contacts[0].smallest_gap, -2e-3);
    forces.push_back(s.surface.contacts[0].force.x());
    EXPECT_GT(forces.back(), 0);
    EXPECT_LT((support(s, 0) + support(s, 1)).norm(), 1e-6 * forces.back());
  }
  EXPECT_NEAR(forces[1], forces[0], 1e-3 * forces[0]);
}

TEST(CoupledSeam, TwoTubesJoinedAtTheirRimsPullLikeOne) {
  const HeldTube half(30, 6, 0.6, 24, 18);
  CoupledProblem problem;
  const Vec3 pull(0, 0, 0.06);
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", Vec3(0, 0, 30), {moved(half.end(), pull)});
  for (const int v : half.row(0)) problem.surfaces.seams.push_back({0, v + 18 * 24, 1, v});
  carry_by_sections(problem);
  CoupledSolver solver(std::move(problem));
  const CoupledSolution s = solver.solve();
  expect_settled(s);
  EXPECT_LT(s.surface.largest_seam_gap, 1e-4 * 6);
  EXPECT_LT((s.surface.bodies[0].joining + s.surface.bodies[1].joining).norm(),
            1e-9 * s.surface.bodies[0].joining.norm());
  const HeldTube whole(60, 6, 0.6, 24, 36);
  CoupledSolver one(
      bent(whole, (Vec6() << 0, 0, 1e-3, 0, 0, 0).finished(), whole.start(), whole.end()));
  const double exact = one.solve().sections[0][1].force.z();
  EXPECT_NEAR(s.sections[1][0].force.z(), exact, 1e-3 * exact);
}

}  // namespace
}  // namespace vasorod
