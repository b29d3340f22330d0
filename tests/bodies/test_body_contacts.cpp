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

// Two plates face to face, the first a spring's end: it is `given` deep in the second where nothing
// presses, and a pressure p moves it out by p / spring. Its minima are known in closed form.
class PressedPlates {
 public:
  PressedPlates() : scaled_(scale_bodies(problem_)) {
    for (ScaledBody& body : scaled_.bodies) body.modelled = true;
    rest_ = scaled_.bodies[0].rest.points;
    update();
  }
  // The minimum with the multipliers at hand, and their update.
  void update() {
    minimise();
    contacts_.refresh(scaled_);
  }
  // With another force of the spring from here on.
  void pull(double deeper) { given_ += deeper; }
  bool extrapolate() { return contacts_.extrapolate(); }
  double multiplier() const { return points().empty() ? 0 : points().front().multiplier; }
  double expected() const { return spring_ * given_; }

 private:
  static BodyProblem plates() {
    BodyProblem problem;
    for (const double side : {1.0, -1.0}) {
      SurfaceBody& body = problem.bodies.emplace_back();
      body.name = "plate";
      body.rest = plate(side);
      body.thickness = 0.2;
      body.k = {1, 0.1, 0.4};
    }
    problem.contacts.emplace_back(0, 1);
    return problem;
  }
  // In the plane z = 0.15 * side, its outside turned to the other; the second one is larger.
  static TriangleSurface plate(double side) {
    constexpr int cells = 6;
    const double edge = side > 0 ? 1 : 1.5;
    TriangleSurface plate;
    plate.points.resize((cells + 1) * (cells + 1), 3);
    plate.triangles.resize(2 * cells * cells, 3);
    for (int i = 0, t = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j) {
        const int v = i * (cells + 1) + j;
        plate.points.row(v) << edge * (i - 0.5 * cells), edge * (j - 0.5 * cells), 0.15 * side;
        if (i == cells || j == cells) continue;
        const int right = v + cells + 1, up = v + 1;
        plate.triangles.row(t++) << v, side > 0 ? up : right, side > 0 ? right : up;
        plate.triangles.row(t++) << right, side > 0 ? up : up + cells + 1,
            side > 0 ? up + cells + 1 : up;
      }
    return plate;
  }
  std::vector<ContactPoint> points() const {
    return contacts_.stacked(scaled_, {0, static_cast<int>(rest_.rows())}).points;
  }
  void minimise() {
    const double m = multiplier(), k = points().empty() ? 0 : points().front().stiffness;
    if (k > 0) spring_ = 2 * k;
    const double depth = k > 0 ? (spring_ * given_ - m) / (spring_ + k) : given_;
    const double gap = 0.3 / scaled_.length;  // at rest
    scaled_.bodies[0].now = rest_;
    scaled_.bodies[0].now.col(2).array() -= gap + depth;
  }

  BodyProblem problem_ = plates();
  ScaledBodies scaled_;
  BodyContacts contacts_{problem_, scaled_, 10};
  Points rest_;
  double given_ = 0.02, spring_ = 1;
};

TEST(BodyContacts, ChangesThatBecomeSmallerByTheSameFactorAreSummedUp) {
  PressedPlates plates;
  plates.update();
  EXPECT_FALSE(plates.extrapolate()) << "the first search was no update";
  plates.update();
  plates.update();
  const double off = std::abs(plates.multiplier() - plates.expected());
  ASSERT_GT(off, 1e-2 * plates.expected()) << plates.multiplier();
  ASSERT_TRUE(plates.extrapolate());
  EXPECT_NEAR(plates.multiplier(), plates.expected(), 1e-6 * plates.expected());
  EXPECT_FALSE(plates.extrapolate()) << "what was added is no update";
}

TEST(BodyContacts, ChangesThatGrowOrTurnAreNotSummedUp) {
  PressedPlates plates;
  for (int k = 0; k < 3; ++k) plates.update();
  plates.pull(0.05);
  plates.update();
  EXPECT_FALSE(plates.extrapolate()) << "it is pulled in";
  plates.pull(-0.05);
  plates.update();
  EXPECT_FALSE(plates.extrapolate()) << "it is let out again";
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
