#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "coupled/free_motions.h"
#include "coupled/held_tubes.h"

namespace vasorod {
namespace {

using namespace testing;
using Fixed = std::array<bool, 6>;

HeldSection fixed(HeldSection section, const Fixed& which) {
  section.fixed = which;
  return section;
}

// Empty where nothing is free.
std::string free_motion(const CoupledProblem& problem) {
  ScaledBodies scaled = scale_bodies(problem.surfaces);
  for (ScaledBody& body : scaled.bodies) body.modelled = true;
  try {
    check_free_motions(problem, scaled);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string free_motion(const Fixed& start, const Fixed& end) {
  const HeldTube tube(60, 6, 0.6, 12, 18);
  return free_motion(bent(tube, Vec6::Zero(), fixed(tube.start(), start), fixed(tube.end(), end)));
}

TEST(FreeMotions, EnoughIsHeld) {
  EXPECT_EQ(free_motion({1, 1, 1, 1, 1, 1}, {}), "");
  EXPECT_EQ(free_motion({1, 1, 1, 0, 0, 1}, {1, 1, 0, 0, 0, 0}), "");
  EXPECT_EQ(free_motion({1, 0, 0, 1, 1, 1}, {0, 1, 1, 0, 0, 0}), "");
}

TEST(FreeMotions, WhatIsLeftIsNamed) {
  const std::string spin = free_motion({1, 1, 1, 0, 0, 0}, {1, 1, 0, 0, 0, 0});
  EXPECT_NE(spin.find("vessel tube"), std::string::npos) << spin;
  EXPECT_NE(spin.find("rotation"), std::string::npos) << spin;
  const std::string slide = free_motion({1, 1, 0, 1, 1, 1}, {1, 1, 0, 0, 0, 0});
  EXPECT_NE(slide.find("translation along (0, 0, "), std::string::npos) << slide;
  EXPECT_NE(free_motion({}, {}), "");
}

TEST(FreeMotions, ASeamLetsOneBodyHoldAnother) {
  const HeldTube tube(60, 6, 0.6, 12, 18);
  CoupledProblem problem = bent(tube, Vec6::Zero(), tube.start(), fixed(tube.end(), {}));
  CoupledProblem other = bent(tube, Vec6::Zero(), fixed(tube.start(), {}), fixed(tube.end(), {}));
  other.surfaces.bodies[0].name = "branch";
  problem.surfaces.bodies.push_back(other.surfaces.bodies[0]);
  problem.vessels.push_back(std::move(other.vessels[0]));
  const std::string alone = free_motion(problem);
  EXPECT_NE(alone.find("vessel branch"), std::string::npos) << alone;
  problem.surfaces.seams.push_back({1, 0, 0, 5});
  EXPECT_EQ(free_motion(problem), "");
}

TEST(FreeMotions, BodiesThatAreNotModelledMayFloat) {
  const HeldTube tube(60, 6, 0.6, 12, 18);
  const CoupledProblem problem =
      bent(tube, Vec6::Zero(), fixed(tube.start(), {}), fixed(tube.end(), {}));
  ScaledBodies scaled = scale_bodies(problem.surfaces);
  EXPECT_FALSE(scaled.bodies[0].modelled);
  EXPECT_NO_THROW(check_free_motions(problem, scaled));
}

// Where the vessel lies and in which unit says nothing of what is free.
TEST(FreeMotions, FarFromTheOriginTheAnswerIsTheSame) {
  for (const double unit : {1.0, 1e-3, 1e3}) {
    HeldTube tube(60 * unit, 6 * unit, 0.6 * unit, 12, 18);
    const Vec3 far = unit * Vec3(4000, -7000, 2000);
    tube.surface.points.rowwise() += far.transpose();
    HeldSection start = tube.start(), end = tube.end();
    start.rest.position += far;
    end.rest.position += far;
    const auto answer = [&](const Fixed& a, const Fixed& b) {
      return free_motion(bent(tube, Vec6::Zero(), fixed(start, a), fixed(end, b)));
    };
    EXPECT_EQ(answer({1, 1, 1, 0, 0, 1}, {1, 1, 0, 0, 0, 0}), "") << unit;
    EXPECT_NE(answer({1, 1, 1, 0, 0, 0}, {1, 1, 0, 0, 0, 0}), "") << unit;
  }
}

}  // namespace
}  // namespace vasorod
