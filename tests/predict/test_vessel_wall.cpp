#include <cmath>
#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "predict/vessel_wall.h"

namespace vasorod {
namespace {

using shapes::change_of;
using shapes::judged_tube;
using shapes::strained;

TEST(VesselWall, ThicknessFollowsTheNodesAndTheFibreTheAxis) {
  PreparedVessel tube = judged_tube();
  for (size_t n = 0; n < tube.node_thickness.size(); ++n)
    tube.node_thickness[n] = 1 + 0.01 * tube.vessel.rod.rest[n].position.z();
  const WallInput wall = wall_of(tube);
  EXPECT_EQ(wall.name, "vessel tube");
  EXPECT_EQ(wall.mid_offset, 0);
  EXPECT_EQ(wall.material.young_axial, 0.5);
  const Points& points = tube.vessel.surface.points;
  ASSERT_EQ(wall.thickness.size(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    EXPECT_NEAR(wall.thickness[i], 1 + 0.01 * points(i, 2), 1e-8) << i;
  ASSERT_EQ(wall.axis.size(), static_cast<size_t>(tube.vessel.surface.triangles.rows()));
  for (const Vec3& axis : wall.axis) EXPECT_GT(axis.normalized().z(), 1 - 1e-12);
}

TEST(VesselWall, AnOuterSurfaceHasItsMiddleHalfAThicknessInside) {
  PreparedVessel tube = judged_tube();
  tube.spec.surface_is = SurfaceIs::outer;
  EXPECT_EQ(wall_of(tube).mid_offset, -0.5);
  tube.spec.surface_is = SurfaceIs::inner;
  EXPECT_EQ(wall_of(tube).mid_offset, 0.5);
}

TEST(VesselWall, SectionsAreTheEndsThatTheConditionsNameButTheMouth) {
  const PreparedVessel tube = judged_tube();
  const auto& ends = tube.vessel.ends;
  VesselConditions conditions;
  EXPECT_TRUE(sections_of(tube.vessel, conditions, -1).sections.empty());
  RodSupport support;
  support.node = ends[0].node;
  support.fixed = {true, true, false, false, false, true};
  support.motion.rotate = Vec3(0, 0.3, 0);
  conditions.rod.supports = {support};
  conditions.rod.loads = {{ends[1].node, Vec3(1, 0, 0), Vec3(0, 2, 0), false},
                          {ends[1].node, Vec3(0, 1, 0), Vec3(0, 0, 3), true}};
  conditions.ends = {{"start", 0, true}, {"end", 1, false}};
  const VesselSections both = sections_of(tube.vessel, conditions, -1);
  ASSERT_EQ(both.sections.size(), 2u);
  EXPECT_EQ(both.nodes, (std::vector<int>{ends[0].node, ends[1].node}));
  const HeldSection &start = both.sections[0], &end = both.sections[1];
  EXPECT_EQ(start.label, "start");
  EXPECT_TRUE(start.rigid);
  EXPECT_EQ(start.fixed, support.fixed);
  EXPECT_EQ(start.motion.rotate, Vec3(0, 0.3, 0));
  EXPECT_EQ(start.ring, ends[0].loop);
  EXPECT_LT((start.rest.position - ends[0].center).norm(), 1e-8);
  EXPECT_EQ(end.label, "end");
  EXPECT_FALSE(end.rigid);
  EXPECT_EQ(end.fixed, (std::array<bool, 6>{}));
  EXPECT_EQ(end.force, Vec3(1, 1, 0)) << "loads of one end add up";
  EXPECT_EQ(end.moment, Vec3(0, 2, 0));
  EXPECT_EQ(end.body_moment, Vec3(0, 0, 3));
  const VesselSections one = sections_of(tube.vessel, conditions, ends[0].node);
  ASSERT_EQ(one.sections.size(), 1u);
  EXPECT_EQ(one.sections[0].label, "end");
}

TEST(VesselWall, AShareOfTheStrainIsTheArcOfThatShareWithoutStretch) {
  const PreparedVessel tube = judged_tube();
  const RodTree& rod = tube.vessel.rod;
  const double curvature = 0.03;
  const RodPoses bent = strained(rod, change_of(0, {0, curvature, 0}));
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const RodPoses partly = share_of_strain(rod, bent, share);
    const RodPoses exact = strained(rod, change_of(0, {0, share * curvature, 0}));
    for (size_t n = 0; n < partly.size(); ++n) {
      EXPECT_LT((partly[n].position - exact[n].position).norm(), 1e-9) << share;
      EXPECT_LT((partly[n].rotation - exact[n].rotation).norm(), 1e-11) << share;
    }
  }
}

TEST(VesselWall, ARigidMotionIsFollowedAlongItsScrew) {
  const PreparedVessel tube = judged_tube();
  const RodTree& rod = tube.vessel.rod;
  const Pose motion = shapes::some_motion();
  RodPoses moved = rod.rest;
  for (Pose& pose : moved) pose = motion * pose;
  const RodPoses half = share_of_strain(rod, moved, 0.5);
  // No strain on the way: distances stay.
  for (size_t n = 1; n < half.size(); ++n)
    EXPECT_NEAR((half[n].position - half[0].position).norm(),
                (rod.rest[n].position - rod.rest[0].position).norm(), 1e-9);
}

}  // namespace
}  // namespace vasorod
