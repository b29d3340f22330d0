#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "paper/paper_solver.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;
constexpr double pi = std::numbers::pi;

// A tube along x with a slit in its top, and one above it along -z whose lowest ring is joined to
// the slit's rim.
struct Glenn {
  BodyProblem problem;
  int around = 24;
  double radius = 8;

  Glenn() {
    SurfaceBody mouth;
    mouth.name = "svc";
    mouth.rest = tube(radius, 40, around, 20);
    mouth.carried = mouth.rest.points;
    const Carried c = bent(mouth.rest.points, 40, 0.4, 0.3, 1.0);
    mouth.carried = c.points;
    mouth.rotations = c.rotations;
    mouth.k = {0.01, 1, 0.5};
    mouth.fixed.assign(static_cast<size_t>(mouth.rest.points.rows()), 0);
    for (int i = 0; i < around; ++i) mouth.fixed[static_cast<size_t>(i)] = 1;
    // The other body: a tube at rest that continues from the mouth, slightly offset and with
    // another radius.
    SurfaceBody other;
    other.name = "rpa";
    other.rest = tube(0.8 * radius, 40, around, 20);
    const Vec3 center = c.points.bottomRows(around).colwise().mean();
    const Mat3 r = c.rotations.back();
    other.rest.points = (other.rest.points * r.transpose()).rowwise() +
                        (center + r * Vec3(0.5, 0.3, 1)).transpose();
    other.k = {0.01, 0.8, 0.5};
    other.fixed.assign(static_cast<size_t>(other.rest.points.rows()), 0);
    for (int i = 0; i < around; ++i)
      other.fixed[other.fixed.size() - 1 - static_cast<size_t>(i)] = 1;
    const int last = static_cast<int>(mouth.rest.points.rows()) - around;
    for (int i = 0; i < around; ++i) problem.seams.push_back({0, last + i, 1, i});
    problem.bodies = {mouth, other};
  }
};

TEST(PaperSolver, WithoutAnEquilibriumSaysWhichCriterionIsNotMet) {
  const Glenn glenn;
  PaperOptions options;
  options.max_outer = 1;
  options.seam_tolerance = 1e-12;
  const SurfaceSolution s = solve_paper(glenn.problem, options);
  EXPECT_EQ(s.status, Status::iteration_limit);
  ASSERT_EQ(s.notes.size(), 1U);
  for (const char* words : {"after 1 multiplier updates", "residual ", "expected at most 1e-08",
                            "seam gap over the mouth's radius "})
    EXPECT_NE(s.notes[0].find(words), std::string::npos) << s.notes[0];
}

TEST(PaperSolver, ClosesTheSeamAndBalancesEveryBody) {
  const Glenn glenn;
  PaperOptions options;
  options.certify = true;
  const SurfaceSolution s = solve_paper(glenn.problem, options);
  EXPECT_EQ(s.status, Status::converged);
  EXPECT_TRUE(s.smallest_curvature_positive);
  EXPECT_LE(s.largest_seam_gap, 1e-3 * s.seam_radius);
  EXPECT_NEAR(s.seam_radius, glenn.radius, 1e-9);
  for (const BodySolution& b : s.bodies) {
    EXPECT_LT(b.residual, 1e-6);
    EXPECT_GT(b.joining.norm(), 0);
    EXPECT_LT((b.binding + b.support + b.joining + b.contact).norm(), 1e-6 * b.joining.norm());
  }
  EXPECT_LT((s.bodies[0].joining + s.bodies[1].joining).norm(), 1e-9 * s.bodies[0].joining.norm());
  for (int i = 0; i < glenn.around; ++i)
    EXPECT_TRUE(
        s.bodies[0].positions.row(i).isApprox(glenn.problem.bodies[0].carried.row(i), 1e-12));
}

TEST(PaperSolver, TheJoinForceDoesNotDependOnTheJoiningStiffness) {
  const Glenn glenn;
  PaperOptions stiff, soft;
  stiff.seam_stiffness = 1000;
  soft.seam_stiffness = 10;
  stiff.seam_tolerance = soft.seam_tolerance = 1e-5;
  const Vec3 a = solve_paper(glenn.problem, stiff).bodies[0].joining;
  const Vec3 b = solve_paper(glenn.problem, soft).bodies[0].joining;
  EXPECT_LT((a - b).norm(), 1e-3 * a.norm());
}

TEST(PaperSolver, UnitsDoNotMatter) {
  const Glenn glenn;
  BodyProblem metres = glenn.problem;
  const double length = 1e-3,
               stiffness = 1e6 * 1e-3;  // mm, MPa -> m, Pa: forces stay in N, force / length grows
  for (SurfaceBody& b : metres.bodies) {
    b.rest.points *= length;
    b.carried *= length;
    b.k = {b.k.binding * stiffness, b.k.bending * stiffness, b.k.stretching * stiffness};
  }
  const SurfaceSolution mm = solve_paper(glenn.problem), m = solve_paper(metres);
  EXPECT_EQ(m.iterations, mm.iterations);
  for (size_t b = 0; b < 2; ++b)
    EXPECT_LT((m.bodies[b].positions / length - mm.bodies[b].positions).cwiseAbs().maxCoeff(),
              1e-9 * glenn.radius);
  EXPECT_LT((m.bodies[0].joining - mm.bodies[0].joining * stiffness * length).norm(),
            1e-8 * m.bodies[0].joining.norm());
}

TEST(PaperSolver, ARigidMotionOfTheSceneMovesTheAnswerWithIt) {
  const Glenn glenn;
  BodyProblem turned = glenn.problem;
  const Mat3 r = random_rotations(1, 5).front();
  const Eigen::RowVector3d shift(30, -500, 12);
  for (SurfaceBody& b : turned.bodies) {
    b.rest.points = (b.rest.points * r.transpose()).eval().rowwise() + shift;
    if (b.carried.rows() > 0)
      b.carried = (b.carried * r.transpose()).eval().rowwise() + shift;
    else
      b.carried = b.rest.points;
    // rotations from the rotated rest surface to the rotated carried surface
    for (Mat3& rotation : b.rotations) rotation = r * rotation * r.transpose();
  }
  const SurfaceSolution here = solve_paper(glenn.problem), there = solve_paper(turned);
  for (size_t b = 0; b < 2; ++b) {
    const Points moved = (here.bodies[b].positions * r.transpose()).rowwise() + shift;
    EXPECT_LT((moved - there.bodies[b].positions).cwiseAbs().maxCoeff(), 1e-6 * glenn.radius);
  }
}

TEST(PaperSolver, WhatNothingMovesOrTouchesIsReturnedAtRest) {
  Glenn glenn;
  SurfaceBody idle;
  idle.name = "aorta";
  idle.rest = tube(5, 20, 16, 10);
  idle.rest.points.col(0).array() += 100;
  idle.k = {1, 1, 1};
  glenn.problem.bodies.push_back(idle);
  glenn.problem.contacts = all_contacts(glenn.problem.bodies);
  const SurfaceSolution s = solve_paper(glenn.problem);
  EXPECT_FALSE(s.bodies[2].modelled);
  EXPECT_TRUE((s.bodies[2].positions.array() == idle.rest.points.array()).all());
  EXPECT_TRUE((s.bodies[2].pressure.array() == 0).all());
  EXPECT_FALSE(s.contacts[1].within_reach);
}

TEST(PaperSolver, CanBeInterrupted) {
  const Glenn glenn;
  PaperOptions options;
  int iterations = 0;
  options.progress = [&](const SolverProgress& at) { iterations = at.iterations; };
  options.stop = [&] { return iterations >= 3; };
  const SurfaceSolution s = solve_paper(glenn.problem, options);
  EXPECT_EQ(s.status, Status::interrupted);
  EXPECT_TRUE(s.bodies[0].positions.allFinite());
}

// At the first, a middle and the last question that is asked within a factorisation.
TEST(PaperSolver, CanBeInterruptedWithinAFactorisation) {
  const Glenn glenn;
  PaperOptions options;
  options.certify = true;
  bool within = false;
  int asked = 0, last = 0;
  options.step = [&](const std::string&) { within = true; };
  options.progress = [&](const SolverProgress&) { within = false; };
  options.stop = [&] { return within && ++asked == last; };
  ASSERT_EQ(solve_paper(glenn.problem, options).status, Status::converged);
  const int questions = asked;
  ASSERT_GT(questions, 2);
  for (const int at : {1, questions / 2, questions}) {
    asked = 0;
    last = at;
    const SurfaceSolution s = solve_paper(glenn.problem, options);
    EXPECT_EQ(s.status, Status::interrupted) << at;
    EXPECT_EQ(asked, at) << "it went on";
    for (const BodySolution& body : s.bodies) EXPECT_TRUE(body.positions.allFinite());
    EXPECT_TRUE(std::isfinite(s.residual));
    EXPECT_FALSE(s.smallest_curvature_positive);
  }
}

TEST(PaperSolver, BadInputIsASentence) {
  Glenn glenn;
  const auto sentence = [](const BodyProblem& problem) -> std::string {
    try {
      solve_paper(problem);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  BodyProblem bad = glenn.problem;
  bad.bodies[0].k.binding = 0;
  EXPECT_NE(sentence(bad).find("vessel svc: its coefficients"), std::string::npos);
  bad = glenn.problem;
  bad.bodies[1].fixed.pop_back();
  EXPECT_NE(sentence(bad).find("flags of fixed vertices"), std::string::npos);
  bad = glenn.problem;
  bad.bodies[0].carried(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(sentence(bad).find("not a number"), std::string::npos);
  bad = glenn.problem;
  bad.seams[0].vertex_b = 100000;
  EXPECT_NE(sentence(bad).find("found vertex 100000"), std::string::npos);
}

TEST(PaperSolver, SolvesAgainAsIfForTheFirstTime) {
  Glenn glenn;
  PaperSolver solver;
  solver.solve(glenn.problem);
  const Carried c = bent(glenn.problem.bodies[0].rest.points, 40, 0.3, 0.3, 1.0);
  glenn.problem.bodies[0].carried = c.points;
  glenn.problem.bodies[0].rotations = c.rotations;
  const SurfaceSolution again = solver.solve(glenn.problem), fresh = solve_paper(glenn.problem);
  ASSERT_EQ(again.status, Status::converged);
  for (size_t b = 0; b < 2; ++b)
    EXPECT_LT((again.bodies[b].positions - fresh.bodies[b].positions).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace vasorod
