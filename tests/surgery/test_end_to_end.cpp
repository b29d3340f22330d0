// The end-to-end join of generated tubes: rims, pairs and what is refused.
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "rod/binding.h"
#include "straight_tube.h"
#include "surgery/end_to_end.h"

namespace vasorod {
namespace {

using testing::straight_tube;

struct Joined {
  std::array<PreparedVessel, 2> vessels;
  std::array<VesselConditions, 2> conditions;
  Operation operation;
};

// Whole tubes of 40 along z, 4 apart.
Scene two_tubes(int first_around, int second_around, double second_radius = 4) {
  Scene scene;
  scene.name = "two-tubes";
  for (const int k : {0, 1}) {
    VesselSpec& spec = scene.vessels.emplace_back();
    spec.name = k == 0 ? "first" : "second";
    const int around = k == 0 ? first_around : second_around;
    spec.tube = straight_tube(40, k == 0 ? 4 : second_radius, around,
                              static_cast<int>(std::lround(40 * around / (8 * M_PI))));
    if (k == 1) spec.tube->position = Vec3(0, 0, 44);
    spec.surface_is = SurfaceIs::mid;
    spec.wall = Wall{0.4, Material::isotropic(0.5, 0.45)};
  }
  EndToEndSpec& spec = scene.end_to_end.emplace();
  spec.rotation_deg = 0;
  spec.rims[0].vessel = "first";
  spec.rims[1].vessel = "second";
  spec.rims[0].end.kind = EndSelector::Kind::end;
  spec.rims[1].end.kind = EndSelector::Kind::start;
  return scene;
}

// Both lose 8 at their rims, which are 4 apart then.
void cut_both(Scene& scene, double second_radius = 4) {
  EndToEndSpec& spec = *scene.end_to_end;
  scene.vessels[1].tube->position = Vec3(0, 0, 28);
  spec.rims[0].cut = Vec3(4, 0, 32);
  spec.rims[0].keep.kind = EndSelector::Kind::start;
  spec.rims[1].cut = Vec3(second_radius, 0, 36);
  spec.rims[1].keep.kind = EndSelector::Kind::end;
}

Joined joined(const Scene& scene) {
  Joined all;
  for (size_t k = 0; k < 2; ++k) {
    all.vessels[k] = read_vessel(scene.vessels[k], scene);
    fit(all.vessels[k]);
    all.conditions[k] = end_conditions(scene, scene.vessels[k].name, all.vessels[k].vessel);
  }
  all.operation = join_end_to_end(scene, *scene.end_to_end,
                                  {VesselToJoin{all.vessels[0], all.conditions[0]},
                                   VesselToJoin{all.vessels[1], all.conditions[1]}});
  return all;
}

double distance(const PreparedVessel& vessel, int a, int b) {
  return (vessel.vessel.surface.points.row(a) - vessel.vessel.surface.points.row(b)).norm();
}

// Every vertex of both rims is in one pair, paired segments have the same share of their rims, and
// no edge of the seam is short.
void expect_equal_seam(const Joined& all) {
  const auto& pairs = all.operation.pairs;
  const size_t n = pairs.size();
  std::array<std::vector<double>, 2> lengths;
  for (size_t side = 0; side < 2; ++side) {
    const PreparedVessel& vessel = all.vessels[side];
    std::vector<int> on_seam;
    for (size_t k = 0; k < n; ++k) {
      lengths[side].push_back(distance(vessel, pairs[k][side], pairs[(k + 1) % n][side]));
      on_seam.push_back(pairs[k][side]);
    }
    std::vector<std::vector<int>> loops = boundary_loops(vessel.vessel.surface.triangles);
    std::sort(on_seam.begin(), on_seam.end());
    int rims = 0;
    for (std::vector<int>& loop : loops) {
      std::sort(loop.begin(), loop.end());
      rims += loop == on_seam;
    }
    EXPECT_EQ(rims, 1);
    const double mean = mean_edge_length(vessel.vessel.surface);
    for (const double length : lengths[side]) EXPECT_GT(length, 0.05 * mean);
    const Points bound =
        carried_points(vessel.vessel.rod, vessel.vessel.rod.rest, vessel.vessel.binding);
    EXPECT_LT((bound - vessel.vessel.surface.points).cwiseAbs().maxCoeff(), 1e-9);
  }
  const auto whole = [&](size_t side) {
    return std::accumulate(lengths[side].begin(), lengths[side].end(), 0.0);
  };
  const double ratio = whole(1) / whole(0);
  for (size_t k = 0; k < n; ++k)
    EXPECT_NEAR(ratio * lengths[0][k], lengths[1][k], 1e-6 * whole(1) / double(n)) << k;
}

TEST(EndToEnd, PairsAreAtEqualArcLengthForAllCounts) {
  for (const auto& [first, second] :
       {std::pair(24, 24), {24, 30}, {37, 24}, {60, 41}, {120, 120}, {120, 64}})
    for (const double degrees : {0.0, 7.0}) {
      SCOPED_TRACE(std::to_string(first) + " and " + std::to_string(second));
      Scene scene = two_tubes(first, second);
      scene.end_to_end->rotation_deg = degrees;
      expect_equal_seam(joined(scene));
      cut_both(scene);
      const Joined all = joined(scene);
      expect_equal_seam(all);
      EXPECT_NEAR(all.operation.end_to_end->rims[0].cut.fraction, 0.8, 1e-3);
      for (const OperatedVessel& vessel : all.operation.vessels) {
        ASSERT_TRUE(vessel.stump.has_value());
        EXPECT_EQ(vessel.rod->summary.status, Status::converged);
      }
    }
}

TEST(EndToEnd, RimsOfDifferentPerimetersAreDividedInTheSameProportions) {
  for (const double radius : {3.0, 6.0}) {
    Scene scene = two_tubes(24, 24, radius);
    cut_both(scene, radius);
    const Joined all = joined(scene);
    expect_equal_seam(all);
    EXPECT_EQ(all.operation.end_to_end->narrower, radius < 4 ? 1 : 0);
  }
}

// The tubes' nodes of both rims lie on one line before they are joined, and so in pairs.
TEST(EndToEnd, WithoutARotationOppositePointsMeetAndWithOneThoseBesideThem) {
  Scene scene = two_tubes(24, 24);
  for (const int shift : {0, 3}) {
    scene.end_to_end->rotation_deg = 15.0 * shift;
    const Joined all = joined(scene);
    EXPECT_EQ(all.operation.pairs.size(), 24u);
    for (const auto& pair : all.operation.pairs) {
      const Vec3 a = all.vessels[0].vessel.surface.points.row(pair[0]),
                 b = all.vessels[1].vessel.surface.points.row(pair[1]);
      // The second turns by the angle about +z, so that its point was that angle behind.
      const double angle = std::atan2(a.y(), a.x()) - std::atan2(b.y(), b.x());
      EXPECT_NEAR(std::remainder(angle - shift * M_PI / 12, 2 * M_PI), 0, 1e-6);
    }
  }
}

// A tilted cut is an ellipse, longest towards the pick, and lies flat on the other rim.
TEST(EndToEnd, ATiltLeavesThePartLongestOnThePicksSide) {
  Scene scene = two_tubes(48, 48);
  cut_both(scene);
  for (const double degrees : {30.0, -30.0}) {
    scene.end_to_end->rims[0].cut_tilt_deg = degrees;
    const Joined all = joined(scene);
    expect_equal_seam(all);
    const CutReport& cut = all.operation.end_to_end->rims[0].cut;
    EXPECT_NEAR(cut.normal.z(), std::cos(M_PI / 6), 1e-6);
    EXPECT_NEAR(cut.normal.x(), -std::sin(degrees * M_PI / 180), 1e-3);
    const double tilt = M_PI / 6,
                 exact = 4 * 4 / std::cos(tilt) * std::comp_ellint_2(std::sin(tilt));
    EXPECT_NEAR(cut.perimeter / exact, 1, 3e-3);
    EXPECT_EQ(cut.tilt_deg, degrees);
    EXPECT_NEAR(all.operation.end_to_end->join.axis_turn_deg, 30, 0.05);
    std::array<Vec3, 2> normals;
    for (size_t k = 0; k < 2; ++k) {
      const PreparedVessel& vessel = all.vessels[k];
      const auto node = index(all.operation.vessels[k].rim_node);
      normals[k] = all.operation.vessels[k].rod->poses[node].rotation *
                   (vessel.vessel.rod.rest[node].rotation.transpose() *
                    all.operation.end_to_end->rims[k].cut.normal);
    }
    EXPECT_LT((normals[0] + normals[1]).norm(), 1e-9);
  }
}

// Without an entry in the scene the far ends stay; an entry counts alone.
TEST(EndToEnd, FarEndsWithoutAnEntryAreHeld) {
  Scene scene = two_tubes(24, 24);
  cut_both(scene);
  scene.end_to_end->rims[1].cut.reset();
  scene.vessels[1].tube->position = Vec3(0, 0, 36);
  const Joined all = joined(scene);
  for (size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(all.conditions[k].rod.supports.size(), 2u);  // far end and rim
    EXPECT_TRUE(all.conditions[k].acts);
    EXPECT_EQ(all.conditions[k].rod.supports[1].node, all.operation.vessels[k].rim_node);
  }
}

std::string refusal(const std::function<void(Scene&)>& change) {
  Scene scene = two_tubes(24, 24);
  cut_both(scene);
  change(scene);
  try {
    joined(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(EndToEnd, WhatCannotBeIsRefusedWithASentence) {
  const auto says = [](const std::string& words, const std::function<void(Scene&)>& change) {
    const std::string said = refusal(change);
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_NE(said.find("expected "), std::string::npos) << said;
    EXPECT_EQ(said.find("scene \"two-tubes\": "), 0u) << said;
  };
  says("off vessel first", [](Scene& scene) { scene.end_to_end->rims[0].cut->point.x() = 12; });
  says("open end", [](Scene& scene) { scene.end_to_end->rims[0].cut->point.z() = 39.9; });
  says("cut_tilt_deg: found 60, expected at most ", [](Scene& scene) {
    scene.end_to_end->rims[0].cut->point.z() = 37;
    scene.end_to_end->rims[0].cut_tilt_deg = 60;
  });
  says("cut_tilt_deg: found 80", [](Scene& scene) { scene.end_to_end->rims[0].cut_tilt_deg = 80; });
  says("off the vessel's middle", [](Scene& scene) {
    scene.end_to_end->rims[0].cut->point.x() = 0.01;
    scene.end_to_end->rims[0].cut_tilt_deg = 10;
  });
  says("expected one at most 2 times the other; an oblique cut of second", [](Scene& scene) {
    scene.vessels[1].tube->radius = 1.9;
    scene.end_to_end->rims[1].cut->point.x() = 1.9;
  });
  says("expected an end without a condition, as the seam holds it", [](Scene& scene) {
    scene.end_to_end->rims[0].cut.reset();
    EndCondition& held = scene.ends.emplace_back();
    held.vessel = "first";
    held.end.kind = EndSelector::Kind::end;
    held.hold = true;
  });
}

}  // namespace
}  // namespace vasorod
