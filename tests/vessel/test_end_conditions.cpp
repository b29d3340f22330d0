#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/error.h>

#include "vessel/end_conditions.h"

namespace vasorod {
namespace {

using Kind = EndSelector::Kind;

// Three ends at nodes 0, 4 and 9; no surface is needed.
Vessel forked() {
  Vessel vessel;
  vessel.ends.resize(3);
  vessel.ends[0].node = 0;
  vessel.ends[1].node = 4;
  vessel.ends[1].center = Vec3(10, 0, 0);
  vessel.ends[2].node = 9;
  vessel.ends[2].center = Vec3(0, 10, 0);
  vessel.rod.radius.assign(10, 3.0);
  return vessel;
}

Vessel tube() {
  Vessel vessel = forked();
  vessel.ends.pop_back();
  return vessel;
}

EndSelector face(int number) {
  EndSelector selector;
  selector.kind = Kind::face;
  selector.face = number;
  return selector;
}

EndCondition at(Kind kind, const Vec3& near = Vec3::Zero()) {
  EndCondition end;
  end.vessel = "svc";
  end.end.kind = kind;
  end.end.near = near;
  return end;
}

std::string refusal(const std::vector<EndCondition>& ends, const Vessel& vessel) {
  Scene scene;
  scene.file = "scene.yaml";
  scene.ends = ends;
  for (size_t i = 0; i < ends.size(); ++i) scene.ends[i].line = 20 + static_cast<int>(i);
  try {
    end_conditions(scene, "svc", vessel);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

VesselConditions conditions_of(const std::vector<EndCondition>& ends, const Vessel& vessel) {
  Scene scene;
  scene.ends = ends;
  return end_conditions(scene, "svc", vessel);
}

std::string refusal_of_face(const Vessel& vessel, int number) {
  try {
    find_end(vessel, face(number), "scene.yaml:7");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(EndConditions, EndsAreFoundByTheFaceOfTheirLid) {
  Vessel vessel = forked();
  EXPECT_EQ(refusal_of_face(vessel, 3),
            "scene.yaml:7: face: found 3, expected start, end or {near: [x, y, z]}, as no end of "
            "this vessel had a lid with a ModelFaceID");
  vessel.ends[1].face = "3";
  vessel.ends[2].face = "12";
  EXPECT_EQ(find_end(vessel, face(3), ""), 1);
  EXPECT_EQ(find_end(vessel, face(12), ""), 2);
  EXPECT_EQ(refusal_of_face(vessel, 1),
            "scene.yaml:7: face: found 1, expected the ModelFaceID of a lid over one of its ends: "
            "3 or 12");
  vessel.ends[2].face = "3";
  EXPECT_NE(refusal_of_face(vessel, 3).find("closed several ends"), std::string::npos);
}

TEST(EndConditions, EndsAreFoundByNameAndByPlace) {
  EXPECT_EQ(find_end(forked(), at(Kind::start).end, ""), 0);
  EXPECT_EQ(find_end(tube(), at(Kind::end).end, ""), 1);
  EXPECT_EQ(find_end(forked(), at(Kind::near, {1, 8, 0}).end, ""), 2);
  EXPECT_EQ(find_end(forked(), at(Kind::near, {8, 1, 0}).end, ""), 1);
  EXPECT_EQ(find_end(forked(), at(Kind::near, {-1, -1, 0}).end, ""), 0);
  EXPECT_EQ(find_end(forked(), at(Kind::near, {15.9, 0, 0}).end, ""), 1);
  EXPECT_THROW(find_end(forked(), at(Kind::near, {16.1, 0, 0}).end, ""), InputError);
}

TEST(EndConditions, AMotionIsASupportInRadians) {
  EndCondition held = at(Kind::start), moved = at(Kind::end);
  held.hold = true;
  moved.rotate_deg = Vec3(0, 400, 0);
  moved.move = Vec3(1, 2, 3);
  moved.soft_section = true;
  const VesselConditions all = conditions_of({held, moved}, tube());
  ASSERT_EQ(all.rod.supports.size(), 2u);
  const RodSupport& support = all.rod.supports[1];
  EXPECT_EQ(support.node, 4);
  EXPECT_EQ(support.fixed, (std::array<bool, 6>{1, 1, 1, 1, 1, 1}));
  EXPECT_NEAR(support.motion.rotate.y(), 400 * std::numbers::pi / 180, 1e-14)
      << "more than a turn is meant";
  EXPECT_EQ(support.motion.move, Vec3(1, 2, 3));
  ASSERT_EQ(all.ends.size(), 2u);
  EXPECT_TRUE(all.ends[0].rigid);
  EXPECT_FALSE(all.ends[1].rigid);
  EXPECT_EQ(all.ends[1].label, "end");
  EXPECT_TRUE(all.acts);
  EXPECT_FALSE(conditions_of({held}, tube()).acts) << "to be held moves nothing";
}

TEST(EndConditions, ALoadAndAFixOfOneEndAddUp) {
  EndCondition load = at(Kind::end), fix = at(Kind::near, {9, 0, 0});
  load.force = Vec3(0, 1, 0);
  load.moment = Vec3(0, 0, 2);
  load.moment_in_body = true;
  fix.fix = {true, false, false, false, false, true};
  const VesselConditions all = conditions_of({load, fix}, tube());
  ASSERT_EQ(all.rod.loads.size(), 1u);
  EXPECT_EQ(all.rod.loads[0].node, 4);
  EXPECT_EQ(all.rod.loads[0].force, Vec3(0, 1, 0));
  EXPECT_EQ(all.rod.loads[0].moment, Vec3(0, 0, 2));
  EXPECT_TRUE(all.rod.loads[0].moment_in_body);
  ASSERT_EQ(all.rod.supports.size(), 1u);
  EXPECT_EQ(all.rod.supports[0].fixed, fix.fix);
  ASSERT_EQ(all.ends.size(), 1u) << "one end by two names";
  EXPECT_EQ(all.ends[0].end, 1);
}

TEST(EndConditions, OtherVesselsEntriesAreTheirs) {
  EndCondition other = at(Kind::start);
  other.vessel = "rpa";
  other.hold = true;
  const VesselConditions none = conditions_of({other}, tube());
  EXPECT_TRUE(none.ends.empty());
  EXPECT_TRUE(none.rod.supports.empty());
}

TEST(EndConditions, WhatIsNotOneEndIsRefusedWithItsLine) {
  EndCondition held = at(Kind::end);
  held.hold = true;
  EXPECT_EQ(
      refusal({held}, forked()).rfind("scene.yaml:20: end: found `end` on a vessel with 3", 0), 0u);
  EndCondition along = at(Kind::at);
  along.hold = true;
  EXPECT_NE(refusal({along}, tube()).find("expected start, end, {near"), std::string::npos);
  // The same end by two names.
  EndCondition again = at(Kind::near, {10, 1, 0});
  again.hold = true;
  const std::string said = refusal({held, again}, tube());
  EXPECT_EQ(said.rfind("scene.yaml:21: end: found near(10, 1, 0) of svc", 0), 0u) << said;
  EXPECT_NE(said.find("line 20 calls end"), std::string::npos) << said;
}

}  // namespace
}  // namespace vasorod
