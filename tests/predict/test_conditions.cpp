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

}  // namespace
}  // namespace vasorod
