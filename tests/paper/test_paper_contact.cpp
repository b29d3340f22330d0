#include <gtest/gtest.h>

#include "paper/paper_solver.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 8, length = 60;

SurfaceBody deformable(const std::string& name, int around, int along) {
  SurfaceBody body;
  body.name = name;
  body.rest = tube(radius, length, around, along);
  body.rest.points.col(2).array() -= length / 2;
  const double fine = 3200.0 / (around * (along + 1));  // the paper's sums depend on the mesh
  body.k = {0.02 * fine, 1, 0.3};
  return body;
}

// A cylinder of radius 12 along y whose top touches x = -radius - gap.
SurfaceBody cylinder(double gap) {
  SurfaceBody body;
  body.name = "cylinder";
  body.rest = tube(12, 40, 72, 36);
  const Points p = body.rest.points;
  body.rest.points.col(0) = p.col(1).array() - radius - gap - 12;
  body.rest.points.col(1) = p.col(2).array() - 20;
  body.rest.points.col(2) = p.col(0);
  body.obstacle = true;
  return body;
}

void move(SurfaceBody& body, const Eigen::RowVector3d& by) {
  body.carried = body.rest.points.rowwise() + by;
  body.rotations.assign(static_cast<size_t>(body.rest.points.rows()), Mat3::Identity());
}

BodyProblem pressed(double depth, double gap = 0.01, int around = 32, int along = 38) {
  BodyProblem problem;
  problem.bodies = {deformable("tube", around, along), cylinder(gap)};
  move(problem.bodies[0], Eigen::RowVector3d(-depth, 0, 0));
  problem.contacts = all_contacts(problem.bodies);
  return problem;
}

double integral(const SurfaceSolution& s, const BodyProblem& problem, size_t body) {
  return s.bodies[body].pressure.dot(vertex_areas(problem.bodies[body].rest));
}

TEST(PaperContact, ATubePressedOntoACylinderIsHeldByTheRod) {
  const BodyProblem problem = pressed(3);
  const SurfaceSolution s = solve_paper(problem);
  EXPECT_EQ(s.status, Status::converged);
  ASSERT_EQ(s.contacts.size(), 1u);
  const double force = s.contacts[0].force.x();
  EXPECT_GT(force, 0);
  // the rod carries the force of the cylinder on the tube
  EXPECT_LT((s.contacts[0].force + s.bodies[0].binding).norm(), 1e-6 * force);
  EXPECT_LT((s.contacts[0].force + s.bodies[1].contact).norm(), 1e-9 * force);
  EXPECT_NEAR(std::abs(s.contacts[0].force.y()) + std::abs(s.contacts[0].force.z()), 0,
              2e-3 * force);
  // the patch is nearly flat: its pressure adds up to the force except for the tilt of its normals
  double along_x = 0;
  const Eigen::VectorXd area = vertex_areas(problem.bodies[0].rest);
  for (int i = 0; i < area.size(); ++i) along_x += s.bodies[0].pressure[i] * area[i];
  EXPECT_GE(along_x, force);
  EXPECT_LT(along_x, 1.2 * force);
  EXPECT_NEAR(integral(s, problem, 1) / integral(s, problem, 0), 1, 0.02);
  EXPECT_LT(s.contacts[0].smallest_gap, 1e-3);
  EXPECT_GT(s.contacts[0].smallest_gap, -2e-3);
  EXPECT_GT(s.contacts[0].area, 0);
  EXPECT_EQ(s.contacts[0].largest_pressure, s.bodies[0].pressure.maxCoeff());
}

TEST(PaperContact, TheForceDoesNotDependOnThePenalty) {
  const BodyProblem problem = pressed(3);
  std::vector<double> forces;
  for (const double stiffness : {0.5, 2.0, 8.0}) {
    PaperOptions options;
    options.contact_stiffness = stiffness;
    const SurfaceSolution s = solve_paper(problem, options);
    EXPECT_EQ(s.status, Status::converged) << stiffness;
    forces.push_back(s.contacts[0].force.x());
  }
  EXPECT_NEAR(forces[0] / forces[1], 1, 1e-3);
  EXPECT_NEAR(forces[2] / forces[1], 1, 1e-3);
}

TEST(PaperContact, IsExactlyZeroWhenApart) {
  const BodyProblem problem = pressed(3, 3.5);
  const SurfaceSolution s = solve_paper(problem);
  EXPECT_EQ(s.status, Status::converged);
  for (const BodySolution& b : s.bodies) EXPECT_TRUE((b.pressure.array() == 0).all());
  EXPECT_EQ(s.contacts[0].force.norm(), 0);
  EXPECT_EQ(s.contacts[0].area, 0);
  EXPECT_NEAR(s.contacts[0].smallest_gap, 0.5,
              0.06);  // the facets of both lie inside their circles
}

TEST(PaperContact, ForceFallsMonotonicallyToZeroWithTheDepth) {
  double before = std::numeric_limits<double>::infinity();
  for (const double depth : {3.0, 1.5, 0.3}) {
    const double force = solve_paper(pressed(depth)).contacts[0].force.x();
    EXPECT_GT(force, 0);
    EXPECT_LT(force, before);
    before = force;
  }
}

// Two deformable tubes crossing at right angles; the upper tube is pressed into the lower.
BodyProblem crossing(double depth, double overlap_at_rest = 0) {
  BodyProblem problem;
  SurfaceBody upper = deformable("upper", 30, 36), lower = deformable("lower", 26, 30);
  const Points p = lower.rest.points;
  lower.rest.points.col(1) = p.col(2);
  lower.rest.points.col(2) = -p.col(1);
  lower.rest.points.col(0).array() -= 2 * radius - overlap_at_rest;
  move(upper, Eigen::RowVector3d(-depth, 0, 0));
  problem.bodies = {upper, lower};
  problem.contacts = {{1, 0}};
  return problem;
}

TEST(PaperContact, TwoDeformableVesselsShareTheForceAndBothCarryPressure) {
  const BodyProblem problem = crossing(2);
  const SurfaceSolution s = solve_paper(problem);
  EXPECT_EQ(s.status, Status::converged);
  EXPECT_TRUE(s.bodies[1].modelled);  // it was at rest until touched
  EXPECT_GT(s.bodies[0].contact.norm(), 0);
  EXPECT_LT((s.bodies[0].contact + s.bodies[1].contact).norm(), 1e-9 * s.bodies[0].contact.norm());
  EXPECT_LT((s.contacts[0].force - s.bodies[1].contact).norm(), 1e-9 * s.bodies[0].contact.norm());
  EXPECT_LT(s.contacts[0].force.x(), 0);
  for (const BodySolution& b : s.bodies) {
    EXPECT_LT(b.residual, 1e-6);
    EXPECT_GT(b.largest_pressure, 0);
  }
  EXPECT_NEAR(integral(s, problem, 1) / integral(s, problem, 0), 1, 0.02);
  const double moved =
      (s.bodies[1].positions - problem.bodies[1].rest.points).cwiseAbs().maxCoeff();
  EXPECT_GT(moved, 0.2);
}

// What sticks between searches ends in the same place: the force along the walls that is left is a
// hundredth of the pressure at most.
TEST(PaperContact, WallsThatStickBetweenSearchesCarryTheSameForce) {
  const BodyProblem problem = crossing(2);
  PaperOptions held;
  held.hold_after = 4;
  const SurfaceSolution free = solve_paper(problem), stuck = solve_paper(problem, held);
  ASSERT_EQ(stuck.status, Status::converged);
  EXPECT_TRUE(free.notes.empty());
  ASSERT_EQ(stuck.notes.size(), 1U);
  EXPECT_NE(stuck.notes[0].find("did not settle until they stuck"), std::string::npos);
  const Vec3 force = free.contacts[0].force;
  EXPECT_LT((stuck.contacts[0].force - force).norm(), 0.01 * force.norm());
  EXPECT_GT(stuck.contacts[0].smallest_gap, -2e-3);
  const double moved = (free.bodies[1].positions - problem.bodies[1].rest.points).norm();
  EXPECT_LT((stuck.bodies[1].positions - free.bodies[1].positions).norm(), 0.02 * moved);
}

TEST(PaperContact, OverlapAtRestCarriesNoPressureAtRest) {
  BodyProblem problem = crossing(0, 1.5);
  problem.bodies[0].carried.col(1).array() += 1e-9;  // its rod moves by a negligible amount
  const SurfaceSolution s = solve_paper(problem);
  EXPECT_EQ(s.status, Status::converged);
  EXPECT_LT(s.bodies[0].contact.norm(), 1e-6);

  // pressed further, it responds nearly as if it had touched without overlap
  const SurfaceSolution pressed_on = solve_paper(crossing(1, 1.5));
  EXPECT_GT(pressed_on.bodies[0].contact.x(), 0);
}

TEST(PaperContact, UnitsDoNotMatter) {
  const BodyProblem problem = pressed(2);
  BodyProblem metres = problem;
  for (SurfaceBody& b : metres.bodies) {
    b.rest.points *= 1e-3;
    b.carried *= 1e-3;
    b.k = {b.k.binding * 1e3, b.k.bending * 1e3, b.k.stretching * 1e3};
  }
  const SurfaceSolution mm = solve_paper(problem), m = solve_paper(metres);
  EXPECT_EQ(mm.iterations, m.iterations);
  EXPECT_NEAR(m.contacts[0].force.x() / mm.contacts[0].force.x(), 1, 1e-9);
  EXPECT_NEAR(m.contacts[0].largest_pressure / mm.contacts[0].largest_pressure, 1e6, 1e-2);
  EXPECT_NEAR(m.contacts[0].area / mm.contacts[0].area, 1e-6, 1e-15);
}

}  // namespace
}  // namespace vasorod
