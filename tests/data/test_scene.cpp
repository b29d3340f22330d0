#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/scene.h>

namespace vasorod {
namespace {

enum Kind { hold, rotate, move, force, moment, fix };
constexpr Kind kinds[] = {hold, rotate, move, force, moment, fix};

bool is_motion(Kind kind) {
  return kind == hold || kind == rotate || kind == move;
}

void add(Kind kind, EndCondition& end) {
  if (kind == hold) end.hold = true;
  if (kind == rotate) end.rotate_deg = Vec3(0, 90, 0);
  if (kind == move) end.move = Vec3(1, 0, 0);
  if (kind == force) end.force = Vec3(0, 0, 1);
  if (kind == moment) end.moment = Vec3(0, 1, 0);
  if (kind == fix) end.fix = {true, true, false, false, false, false};
}

EndCondition with(std::initializer_list<Kind> given) {
  EndCondition end;
  for (const Kind kind : given) add(kind, end);
  return end;
}

TEST(Scene, EndsAreNamedAsTheSceneHasThem) {
  EXPECT_EQ(to_string(EndSelector{EndSelector::Kind::start, {}, 0}), "start");
  EXPECT_EQ(to_string(EndSelector{EndSelector::Kind::end, {}, 0}), "end");
  EXPECT_EQ(to_string(EndSelector{EndSelector::Kind::near, Vec3(1, -2.5, 0), 0}),
            "near(1, -2.5, 0)");
  EXPECT_EQ(to_string(EndSelector{EndSelector::Kind::at, Vec3::Zero(), 0.25}), "at(0.25)");
  EXPECT_EQ(to_string(EndSelector{EndSelector::Kind::face, {}, 0, 12}), "face(12)");
}

TEST(Scene, RolesAndFacesAreNamedAsTheSceneHasThem) {
  EXPECT_EQ(to_string(Role::deformable), "deformable");
  EXPECT_EQ(to_string(Role::obstacle), "obstacle");
  EXPECT_EQ(to_string(SurfaceIs::mid), "mid");
  EXPECT_EQ(to_string(SurfaceIs::outer), "outer");
  EXPECT_EQ(to_string(SurfaceIs::inner), "inner");
}

TEST(Scene, OneConditionMakesSenseAndNoneDoesNot) {
  for (const Kind kind : kinds) EXPECT_EQ(contradiction(with({kind})), "") << kind;
  EXPECT_NE(contradiction(EndCondition{}).find("without a condition"), std::string::npos);
}

// A motion alone, of rotation and displacement; or loads, with or without fixed freedoms.
TEST(Scene, PairsOfConditionsContradictWhereTheScenePageSaysSo) {
  for (const Kind a : kinds)
    for (const Kind b : kinds) {
      if (a == b) continue;
      const bool both_motions = is_motion(a) && is_motion(b);
      const bool sense = both_motions ? a != hold && b != hold : !is_motion(a) && !is_motion(b);
      const std::string said = contradiction(with({a, b}));
      EXPECT_EQ(said.empty(), sense) << a << ' ' << b << ": " << said;
      if (!sense) {
        EXPECT_NE(said.find(", expected "), std::string::npos) << said;
      }
    }
}

TEST(Scene, TwoEntriesForOneEndAddUpOnlyAsALoadAndAFix) {
  for (const Kind a : kinds)
    for (const Kind b : kinds) {
      const bool load_and_fix = !is_motion(a) && !is_motion(b) && ((a == fix) != (b == fix));
      EXPECT_EQ(exclude_each_other(with({a}), with({b})), !load_and_fix) << a << ' ' << b;
    }
  EXPECT_TRUE(exclude_each_other(with({force, fix}), with({force})));
  EXPECT_TRUE(exclude_each_other(with({force, fix}), with({fix})));
}

TEST(Scene, AVesselIsFoundByItsName) {
  Scene scene;
  scene.file = "glenn.yaml";
  scene.vessels.resize(2);
  scene.vessels[0].name = "svc";
  scene.vessels[1].name = "rpa";
  EXPECT_EQ(&scene.vessel("rpa"), &scene.vessels[1]);
  EXPECT_EQ(&scene.vessel("svc"), scene.vessels.data());
  try {
    scene.vessel("aorta");
    FAIL() << "found a vessel that is not there";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "glenn.yaml: found no vessel \"aorta\", expected one of the scene's");
  }
}

}  // namespace
}  // namespace vasorod
