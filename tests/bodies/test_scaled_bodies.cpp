#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include <vasorod/error.h>

#include "bodies/scaled_bodies.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Two tubes, one of them bent, and an obstacle far away; lengths times `length`, forces over length
// times `stiffness`.
BodyProblem three_bodies(double length, double stiffness) {
  BodyProblem problem;
  for (int i = 0; i < 3; ++i) {
    SurfaceBody& body = problem.bodies.emplace_back();
    body.name = "vessel" + std::to_string(i);
    body.rest = tube(3 + i, 20, 12, 9);
    if (i == 0) {
      const Carried carried = bent(body.rest.points, 20, 0.5, 0.2, 1.1);
      body.carried = length * carried.points;
      body.rotations = carried.rotations;
    }
    if (i == 2) body.rest.points.array() += 500;
    body.rest.points *= length;
    body.k = {2.0 * stiffness, 0.5 * stiffness, (3.0 + i) * stiffness};
    body.thickness = 0.5 * length;
    body.offset = 0.25 * length;
    body.obstacle = i == 2;
  }
  return problem;
}

TEST(ScaledBodies, UnitsDoNotMatter) {
  const ScaledBodies one = scale_bodies(three_bodies(1, 1));
  const ScaledBodies other = scale_bodies(three_bodies(1e3, 1e-6));
  EXPECT_NEAR(other.length / one.length, 1e3, 1e-9);
  EXPECT_NEAR(other.stiffness / one.stiffness, 1e-6, 1e-18);
  EXPECT_NEAR(other.force() / one.force(), 1e-3, 1e-15);
  EXPECT_NEAR(other.pressure() / one.pressure(), 1e-9, 1e-21);
  EXPECT_NEAR(other.energy() / one.energy(), 1, 1e-12);
  for (size_t b = 0; b < 3; ++b) {
    const ScaledBody &a = one.bodies[b], &c = other.bodies[b];
    EXPECT_LT((a.rest.points - c.rest.points).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((a.now - c.now).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_NEAR(a.k.stretching, c.k.stretching, 1e-14);
    EXPECT_NEAR(a.thickness, c.thickness, 1e-14);
    EXPECT_NEAR(a.offset, c.offset, 1e-14);
    EXPECT_NEAR(a.mean_area, c.mean_area, 1e-12);
  }
}

TEST(ScaledBodies, AnEdgeIsOneLongTheLargestStiffnessOneAndTheCentreTheOrigin) {
  const BodyProblem problem = three_bodies(7, 13);
  const ScaledBodies scaled = scale_bodies(problem);
  double edges = 0, vertices = 0, largest = 0;
  Vec3 centre = Vec3::Zero();
  for (const ScaledBody& body : scaled.bodies) {
    if (body.obstacle) continue;
    const auto count = static_cast<double>(body.rest.points.rows());
    edges += count * mean_edge_length(body.rest);
    centre += body.rest.points.colwise().sum().transpose();
    vertices += count;
    largest = std::max({largest, body.k.binding, body.k.bending, body.k.stretching});
  }
  EXPECT_NEAR(edges / vertices, 1, 1e-12);
  EXPECT_NEAR((centre / vertices).norm(), 0, 1e-11);
  EXPECT_DOUBLE_EQ(largest, 1);
}

TEST(ScaledBodies, AndBack) {
  const BodyProblem problem = three_bodies(7, 13);
  const ScaledBodies scaled = scale_bodies(problem);
  for (size_t b = 0; b < 3; ++b) {
    const Points& rest = problem.bodies[b].rest.points;
    EXPECT_LT((scaled.unscaled(scaled.bodies[b].rest.points) - rest).cwiseAbs().maxCoeff(),
              1e-13 * rest.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(
      (scaled.unscaled(scaled.bodies[0].now) - problem.bodies[0].carried).cwiseAbs().maxCoeff(),
      1e-11);
}

TEST(ScaledBodies, MovedIsWhatItsRodHasCarriedOrTurned) {
  BodyProblem problem = three_bodies(1, 1);
  ScaledBodies scaled = scale_bodies(problem);
  EXPECT_TRUE(scaled.bodies[0].moved);
  EXPECT_FALSE(scaled.bodies[1].moved);
  EXPECT_FALSE(scaled.bodies[2].moved);
  // Carried to where it was, in sections as they were: at rest. Turned sections alone are a motion.
  problem.bodies[1].carried = problem.bodies[1].rest.points;
  const auto count = static_cast<size_t>(problem.bodies[1].rest.points.rows());
  problem.bodies[1].rotations.assign(count, Mat3::Identity());
  EXPECT_FALSE(scale_bodies(problem).bodies[1].moved);
  problem.bodies[1].rotations[3] = random_rotations(1, 5)[0];
  EXPECT_TRUE(scale_bodies(problem).bodies[1].moved);
}

TEST(ScaledBodies, AGuardKnowsTheFacesOfTheWall) {
  ScaledBody body;
  body.mean_edge = 1;
  body.thickness = 0.5;
  body.offset = 0.1;
  const GuardedWall wall = guarded_wall(body);
  EXPECT_DOUBLE_EQ(wall.inside, 0.4);
  EXPECT_DOUBLE_EQ(wall.outside, 0.1);
  EXPECT_DOUBLE_EQ(wall.along, 4) << "thin: some edges";
  body.thickness = 3.1;
  EXPECT_DOUBLE_EQ(guarded_wall(body).along, 3 * std::numbers::pi)
      << "thick: half a turn about the inner face";
}

TEST(ScaledBodies, WhatDoesNotFitIsRefusedWithTheBodysName) {
  const auto refused = [](const std::function<void(SurfaceBody&)>& spoil, const std::string& word) {
    BodyProblem problem = three_bodies(1, 1);
    spoil(problem.bodies[1]);
    try {
      scale_bodies(problem);
      ADD_FAILURE() << word << ": accepted";
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.rfind("vessel vessel1: ", 0), 0u) << said;
      EXPECT_NE(said.find(word), std::string::npos) << said;
      EXPECT_NE(said.find("expected"), std::string::npos) << said;
    }
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](SurfaceBody& body) { body.rest = {}; }, "no triangles");
  refused([](SurfaceBody& body) { body.rest.points(4, 1) = nan; }, "not a number");
  refused([](SurfaceBody& body) { body.carried = Points::Zero(5, 3); }, "5 carried points");
  refused([](SurfaceBody& body) { body.rotations.resize(2); }, "2 rotations");
  refused([](SurfaceBody& body) { body.fixed = {1}; }, "1 flags");
  refused([](SurfaceBody& body) { body.k.binding = 0; }, "k_c");
  refused([](SurfaceBody& body) { body.k.bending = -1; }, "k_b");
  refused([](SurfaceBody& body) { body.k.stretching = nan; }, "k_s");
}

}  // namespace
}  // namespace vasorod
