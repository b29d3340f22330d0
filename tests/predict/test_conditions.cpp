// Scenes as a program makes them, without a file: what they must say before they are solved.
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/predict.h>

namespace vasorod {
namespace {

Scene tube_scene() {
  VesselSpec tube;
  tube.name = "tube";
  TubeSpec& shape = tube.tube.emplace();
  shape.length = 60;
  shape.radius = 6;
  shape.around = 16;
  shape.along = 24;
  tube.surface_is = SurfaceIs::mid;
  tube.wall = Wall{.thickness = 0.6, .material = Material::isotropic(1, 0.3)};
  Scene scene;
  scene.name = "tube";
  scene.vessels = {tube};
  scene.fidelity = "skin";
  return scene;
}

Scene rod_scene() {
  RodPiece piece;
  piece.length = 10;
  piece.elements = 4;
  piece.stiffness = Mat6::Identity();
  VesselSpec rod;
  rod.name = "rod";
  rod.rod.emplace().pieces = {piece};
  Scene scene;
  scene.name = "rod";
  scene.vessels = {rod};
  scene.fidelity = "rod";
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    predict(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Conditions, ASceneInWhichNothingWouldHappenIsRefused) {
  for (const Scene& scene : {tube_scene(), rod_scene()})
    EXPECT_EQ(refusal(scene).find("scene \"" + scene.name + "\": found no condition in ends"), 0U)
        << refusal(scene);
}

TEST(Conditions, ARodThatIsNotAtEaseAsDrawnMayRelax) {
  Scene scene = rod_scene();
  Vec6 natural;
  natural << 0, 0, 1, 0.1, 0, 0;
  scene.vessels[0].rod->pieces[0].natural = natural;
  EXPECT_EQ(refusal(scene), "");
}

TEST(Conditions, APointBeyondTwoRadiiOfEveryEndIsRefused) {
  Scene scene = tube_scene();
  EndCondition held;
  held.vessel = "tube";
  held.end.kind = EndSelector::Kind::near;
  held.end.near = {0, 0, 60 + 11.9};
  held.hold = true;
  scene.ends = {held};
  EXPECT_EQ(refusal(scene), "");
  scene.ends[0].end.near = {0, 0, 60 + 12.5};
  const std::string said = refusal(scene);
  for (const char* words : {"near: found (0, 0, 72.5)", "12.5 off the nearest end's centre", "60)",
                            "expected at most two radii there"})
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

// Every sentence about a scene without a file begins with the scene's name.
TEST(Conditions, SentencesNameASceneThatHasNoFile) {
  EndCondition start, near_start;
  start.hold = near_start.hold = true;
  near_start.end.kind = EndSelector::Kind::near;
  Scene twice = tube_scene(), far = tube_scene(), exact = tube_scene(), misspelt = tube_scene(),
        unknown = tube_scene();
  start.vessel = near_start.vessel = "tube";
  for (Scene* scene : {&twice, &far, &exact, &misspelt, &unknown}) scene->ends = {start};
  twice.ends.push_back(near_start);
  near_start.end.near = {0, 0, 90};
  far.ends.push_back(near_start);
  exact.fidelity.reset();
  exact.accuracy = 1e-6;
  exact.vessels[0].tube->around = 32;  // fine enough for the table of promises
  exact.vessels[0].tube->along = 60;
  EndCondition moved = start;
  moved.hold = false;
  moved.end.kind = EndSelector::Kind::end;
  moved.move = Vec3(0, 0, 1);
  exact.ends.push_back(moved);
  misspelt.fidelity = "skim";
  unknown.ends[0].vessel = "aorta";

  Scene supported_twice = rod_scene(), ring = rod_scene();
  start.vessel = "rod";
  supported_twice.ends = {start, start};
  ring.ends = {start};
  ring.vessels[0].rod->parent = "rod";

  Scene beside = tube_scene();
  beside.vessels.push_back(beside.vessels[0]);
  beside.vessels[1].name = "other";
  beside.vessels[1].tube->position = {30, 0, 0};
  start.vessel = "tube";
  beside.ends = {start};
  GlennSpec& glenn = beside.glenn.emplace();
  glenn.svc = "tube";
  glenn.rpa = "other";
  glenn.incision = {300, 0, 30};

  const std::pair<const Scene*, const char*> expected[] = {
      {&twice, ": end: found near(0, 0, 0) of tube, the end that another condition calls start"},
      {&far, ": near: found (0, 0, 90)"},
      {&exact, ": accuracy: found 1e-06"},
      {&misspelt, ": fidelity: found \"skim\""},
      {&unknown, ": found no vessel \"aorta\""},
      {&supported_twice, ": start of 'rod' is supported a second time"},
      {&ring, ": vessel 'rod': rods are each other's parents"},
      {&beside, ": incision: found a point (300, 0, 30)"}};
  for (const auto& [scene, words] : expected) {
    const std::string said = refusal(*scene);
    EXPECT_EQ(said.find("scene \"" + scene->name + "\"" + words), 0U) << words << '\n' << said;
  }
}

}  // namespace
}  // namespace vasorod
