#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "bodies/body_contacts.h"
#include "bodies/late_contacts.h"
#include "geometry/triangle_surface.h"
#include "paper/paper_tubes.h"
#include "surgery/cap.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 6;
constexpr int around = 24;

// What a cut leaves below z = 0.
TriangleSurface stump() {
  TriangleSurface closed = tube(radius, 6, around, 4);
  closed.points.col(2).array() -= 6;
  for (const std::vector<int>& loop : boundary_loops(closed.triangles))
    closed = close_planar_hole(closed, loop).surface;
  return closed;
}

// A vein with its mouth on its stump. `open`: the mouth is on its way.
BodyProblem cut_vein(bool open) {
  BodyProblem problem;
  SurfaceBody& vein = problem.bodies.emplace_back();
  vein.name = "vein";
  vein.rest = tube(radius, 24, around, 16);
  vein.thickness = 0.6;
  vein.k = {1, 0.1, 0.4};
  vein.open_mouth = open;
  SurfaceBody& below = problem.bodies.emplace_back();
  below.name = "stump";
  below.rest = stump();
  below.obstacle = below.edged = true;
  problem.contacts.emplace_back(0, 1);
  return problem;
}

// Deepest penetration once the mouth is tilted by 3 degrees about its middle, length.
double tilted(bool open, bool met) {
  const BodyProblem problem = cut_vein(open);
  ScaledBodies scaled = scale_bodies(problem);
  ScaledBody& vein = scaled.bodies[0];
  vein.modelled = true;
  BodyContacts contacts(problem, scaled, 10);
  contacts.refresh(scaled);
  if (met) {
    contacts.meet_up_to_seams();
    contacts.allow(0);
  }
  const Vec3 mouth = -scaled.origin / scaled.length;
  const Mat3 turn = Eigen::AngleAxisd(3 * M_PI / 180, Vec3::UnitX()).toRotationMatrix();
  vein.now =
      ((vein.now.rowwise() - mouth.transpose()) * turn.transpose()).rowwise() + mouth.transpose();
  return contacts.refresh(scaled).penetration * scaled.length;
}

// Vertices of the cap are then behind the plane of the mouth, as far from the wall as a radius.
// None has passed through the wall, whose own vertices are no deeper in the stump than a hundredth
// of it.
TEST(BodyContacts, WhatIsInAnOpenMouthDoesNotTouchTheWall) {
  EXPECT_LT(tilted(true, false), 0.01 * radius);
}

// Once a mouth is sewn, nothing is in it that has not passed through a wall.
TEST(BodyContacts, WhatIsInASewnMouthHasPassedThroughTheWall) {
  EXPECT_GT(tilted(false, false), 0.15 * radius);
  EXPECT_GT(tilted(true, true), 0.15 * radius);
}

// Parallel tubes across their boxes' diagonal, whose boxes overlap: half an edge and some seven
// mean edges apart.
TEST(BodyContacts, FindsTheGapOfWallsFarFromEachOther) {
  for (const double gap : {0.8, 12.6}) {
    BodyProblem problem;
    const Mat3 turn = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()).toRotationMatrix();
    for (const double to : {0.0, 2 * radius + gap}) {
      SurfaceBody& body = problem.bodies.emplace_back();
      body.name = "tube";
      body.rest = tube(radius, 60, around, 40);
      body.rest.points.col(1).array() += to;
      body.rest.points *= turn.transpose();
      body.thickness = 0.6;
      body.k = {1, 0.1, 0.4};
    }
    problem.contacts.emplace_back(0, 1);
    ScaledBodies scaled = scale_bodies(problem);
    for (ScaledBody& body : scaled.bodies) body.modelled = true;
    BodyContacts contacts(problem, scaled, 10);
    contacts.refresh(scaled);
    // The facets lie inside the circles, and surfaces that are given are the outer ones.
    EXPECT_NEAR(contacts.smallest_gap(0, scaled) * scaled.length, gap, 0.01 * 2 * radius) << gap;
  }
}

TEST(LateContacts, AreSearchedAtFewerAndFewerUpdates) {
  LateContacts late(12);
  std::vector<int> searched;
  for (int update = 1; update < 100; ++update)
    if (late.search(update) && late.is_late(update)) searched.push_back(update);
  EXPECT_EQ(searched, (std::vector<int>{13, 23, 38, 60, 93}));
  EXPECT_TRUE(LateContacts(12).search(12));
  EXPECT_EQ(LateContacts::note({}),
            "contacts that still open and close were accepted at ten times their tolerance");
  EXPECT_TRUE(LateContacts::note(0.02).ends_with("found walls in each other by 0.02 mean edges"));
}

}  // namespace
}  // namespace vasorod
