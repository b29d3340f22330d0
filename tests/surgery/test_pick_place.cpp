// Picks on a bent tube whose axis, frames and wall have closed forms.
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "surgery/pick_place.h"

namespace vasorod {
namespace {

// A tube that turns by 60 degrees towards its normal.
struct BentTube {
  TubeSpec spec;

  BentTube() {
    spec.length = 60;
    spec.radius = 5;
    spec.around = 96;
    spec.along = 96;
    spec.bend_deg = 60;
    spec.position = {7, -3, 11};
    spec.tangent = Vec3(1, 2, 2).normalized();
    spec.normal = Vec3(2, 1, -2).normalized();
  }

  PreparedVessel prepared() const {
    PreparedVessel vessel;
    vessel.spec.name = "tube";
    vessel.vessel = fit_vessel("tube", tube_surface(spec));
    return vessel;
  }
  Vec3 axis(double fraction) const {
    const double angle = spec.bend_deg * M_PI / 180, turn = spec.length / angle;
    return spec.position + turn * std::sin(fraction * angle) * spec.tangent +
           turn * (1 - std::cos(fraction * angle)) * spec.normal;
  }
  Vec3 wall(double fraction, double around_deg) const {
    const double at = fraction * spec.bend_deg * M_PI / 180, around = around_deg * M_PI / 180;
    const Vec3 normal = std::cos(at) * spec.normal - std::sin(at) * spec.tangent;
    return axis(fraction) + spec.radius * (std::cos(around) * normal +
                                           std::sin(around) * spec.tangent.cross(spec.normal));
  }
  // Of the wall's chords (the sagitta of 96 edges is 0.003), and of the fitted axis.
  static constexpr double tolerance = 0.03;
};

PickSpec along(double fraction, double around_deg = 0) {
  PickSpec pick;
  pick.along = fraction;
  pick.around_deg = around_deg;
  return pick;
}

EndSelector end_of_kind(EndSelector::Kind kind) {
  EndSelector end;
  end.kind = kind;
  return end;
}

std::string refusal(const PickSpec& pick, const PreparedVessel& vessel) {
  try {
    place_incision_pick("scene.yaml:3: incision", pick, vessel);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(PickPlace, AFractionAndAnAngleAreWhereTheTubesFormulaSays) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  for (const double fraction : {0.1, 0.4, 0.77})
    for (const double around : {0.0, 90.0, -135.0, 270.0}) {
      const PickPlace place = place_incision_pick("", along(fraction, around), vessel);
      EXPECT_LT((place.point - tube.wall(fraction, around)).norm(), tube.tolerance)
          << fraction << ' ' << around;
      EXPECT_EQ(*place.fraction, fraction);
    }
}

TEST(PickPlace, FromTheOtherEndTheFractionIsTheRestAndTheAngleTheSame) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  PickSpec pick = along(0.3, 50);
  pick.from = end_of_kind(EndSelector::Kind::end);
  EXPECT_LT((place_incision_pick("", pick, vessel).point - tube.wall(0.7, 50)).norm(),
            tube.tolerance);
  pick.to = pick.from;
  EXPECT_NE(refusal(pick, vessel).find("found one end of the vessel"), std::string::npos);
}

TEST(PickPlace, ACutCountsFromTheKeptEnd) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  EXPECT_LT((place_cut("", along(0.2), vessel, 0).point - tube.axis(0.2)).norm(), tube.tolerance);
  EXPECT_LT((place_cut("", along(0.2), vessel, 1).point - tube.axis(0.8)).norm(), tube.tolerance);
}

TEST(PickPlace, APointHasTheFractionAndTheAngleOfItsPlace) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  const PickPlace place = place_incision_pick("", tube.wall(0.35, -70), vessel);
  EXPECT_NEAR(*place.fraction, 0.35, 1e-3);
  EXPECT_NEAR(place.angle * 180 / M_PI, -70, 0.5);
  EXPECT_EQ(place.point, tube.wall(0.35, -70));
}

TEST(PickPlace, AMarkupIsTurnedIntoTheSpaceOfTheVessel) {
  const BentTube tube;
  PreparedVessel vessel = tube.prepared();
  const Vec3 point = tube.wall(0.5, 10);
  for (const std::string space : {"LPS", "RAS"}) {
    PickSpec same = point, other(-point.x(), -point.y(), point.z());
    same.space = space;
    other.space = space == "LPS" ? "RAS" : "LPS";
    vessel.loaded.space = space;
    EXPECT_EQ(place_incision_pick("", same, vessel).point, point);
    EXPECT_EQ(place_incision_pick("", other, vessel).point, point);
    vessel.loaded.space.clear();
    EXPECT_EQ(place_incision_pick("", same, vessel).point, point);
    const std::string said = refusal(other, vessel);
    EXPECT_NE(said.find("names no SPACE, and its points are not in " + other.space),
              std::string::npos)
        << said;
  }
}

TEST(PickPlace, OffTheVesselTheNearestPointIsNamed) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  const Vec3 out = tube.wall(0.5, 40) - tube.axis(0.5), pick = tube.axis(0.5) + 3 * out;
  const std::string said = refusal(pick, vessel);
  EXPECT_EQ(said.rfind("scene.yaml:3: incision: found a point (", 0), 0u) << said;
  const std::string words = "the nearest point on it is (";
  const auto at = said.find(words);
  ASSERT_NE(at, std::string::npos) << said;
  Vec3 named;
  ASSERT_EQ(std::sscanf(said.c_str() + at + words.size(), "%lf, %lf, %lf", &named.x(), &named.y(),
                        &named.z()),
            3);
  EXPECT_LT((named - tube.wall(0.5, 40)).norm(), 0.25);  // a vertex, half an edge aside
}

// At the very end of the tube, half of a ray's directions meet no wall.
// From the axis to an outer surface it is half the wall more than the mid-wall radius.
TEST(PickPlace, ACutMayBePickedOnTheAxisOfAnOuterSurface) {
  const BentTube tube;
  PreparedVessel vessel = tube.prepared();
  for (double& radius : vessel.vessel.rod.radius) radius = tube.spec.radius - 0.3;
  PickSpec pick;
  pick.point = tube.axis(0.4);
  const PickPlace place = place_cut("scene.yaml:3: cut", pick, vessel, 0);
  EXPECT_NEAR(place.fraction.value(), 0.4, 1e-3);
  EXPECT_EQ(place.point, pick.point);
  // Of a file without SPACE, the other space is found there too.
  PickSpec turned = pick;
  turned.point.head<2>() *= -1;
  turned.space = "RAS";
  try {
    place_cut("scene.yaml:3: cut", turned, vessel, 0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("with x and y negated"), std::string::npos)
        << error.what();
  }
  // An incision has no side there.
  EXPECT_NE(refusal(pick, vessel).find("off vessel tube"), std::string::npos);
}

TEST(PickPlace, AtAnOpenEndThereMayBeNoWall) {
  const BentTube tube;
  const RayHits wall(tube_surface(tube.spec));
  Pose section;
  section.position = tube.axis(0) - 0.1 * tube.spec.tangent;
  section.rotation << tube.spec.normal, tube.spec.tangent.cross(tube.spec.normal),
      tube.spec.tangent;
  EXPECT_FALSE(wall_point(wall, section, 0.3));
  section.position = tube.axis(0) + 0.1 * tube.spec.tangent;
  EXPECT_TRUE(wall_point(wall, section, 0.3));
}

TEST(PickPlace, AMovedPickIsTheNearestStepThatFits) {
  const BentTube tube;
  const PreparedVessel vessel = tube.prepared();
  const PickPlace pick = place_incision_pick("", tube.wall(0.5, 20), vessel);
  const AxisRoute route = pick_route("", {}, vessel.vessel, 0);
  const Vec3 bound = tube.wall(0.41, 20);
  const auto moved = moved_pick(vessel.vessel, pick, route, 12, [&](const Vec3& point) {
    return (point - tube.wall(0, 20)).norm() < (bound - tube.wall(0, 20)).norm();
  });
  ASSERT_TRUE(moved);  // 5.4 of 60 off, in steps of 1.2
  EXPECT_NEAR(moved->by, 6, 0.1);
  EXPECT_NEAR(moved->fraction, 0.4, 2e-3);
  EXPECT_LT((moved->point - tube.wall(0.4, 20)).norm(), 2 * tube.tolerance);
  EXPECT_FALSE(moved_pick(vessel.vessel, pick, route, 3, [](const Vec3&) { return false; }));
}

}  // namespace
}  // namespace vasorod
