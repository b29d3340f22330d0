#include <gtest/gtest.h>

#include "data/scene_place.h"

namespace vasorod {
namespace {

TEST(ScenePlace, IsTheFileAndTheLineAsFarAsTheyAreKnown) {
  Scene scene;
  scene.file = "cases/glenn.yaml";
  scene.name = "infant";
  EXPECT_EQ(place_in(scene, 12), "cases/glenn.yaml:12");
  EXPECT_EQ(place_in(scene), "cases/glenn.yaml");
}

TEST(ScenePlace, OfAVesselEndsWithItsName) {
  Scene scene;
  scene.file = "cases/glenn.yaml";
  VesselSpec vessel;
  vessel.name = "svc";
  vessel.line = 7;
  EXPECT_EQ(place_of(scene, vessel), "cases/glenn.yaml:7: vessel svc: ");
}

TEST(ScenePlace, IsTheNameOfASceneWithoutAFile) {
  Scene scene;
  scene.name = "in\nfant";
  EXPECT_EQ(place_in(scene), "scene \"in\\nfant\"");
  EXPECT_EQ(place_in(scene, 12), "scene \"in\\nfant\"");
}

}  // namespace
}  // namespace vasorod
