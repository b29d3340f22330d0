#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/predict.h>
#include <vasorod/read_scene.h>

#include "predict/input_hashes.h"
#include "result/sha256.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

class InputHashesOf : public ScratchFolder {
 protected:
  std::filesystem::path scene_file() const {
    return write("scene.yaml",
                 "scene: pulled\nunits: {length: mm, stress: MPa}\nvessels:\n"
                 "  - name: tube\n    tube: {length: 60, radius: 6, around: 16, along: 24}\n"
                 "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n"
                 "ends:\n  - {vessel: tube, end: start, hold: true}\n"
                 "  - {vessel: tube, end: end, move: [0, 0, 1]}\nfidelity: skin\n");
  }
};

// What becomes of the scene's file while it is solved.
TEST_F(InputHashesOf, ASceneChangedOrGoneDuringTheRunKeepsTheHashOfWhatWasRead) {
  for (const bool gone : {false, true}) {
    const std::filesystem::path file = scene_file();
    const std::string read = sha256_of_file(file);
    const Scene scene = read_scene(file);
    SolveOptions options;
    options.progress = [&](const std::string&) {
      if (gone)
        std::filesystem::remove(file);
      else
        write("scene.yaml", "another scene");
    };
    const Result result = predict(scene, options);
    EXPECT_EQ(result.environment.inputs.at("scene.yaml"), read);
    EXPECT_EQ(std::filesystem::exists(file), !gone);
  }
}

TEST_F(InputHashesOf, ASurfaceThatChangesWhileItIsReadIsRefused) {
  Scene scene;
  VesselSpec vessel;
  vessel.name = "wall";
  vessel.surface = write("wall.vtp", "one");
  scene.vessels = {vessel};
  InputHashes inputs(scene);
  EXPECT_THROW(inputs.while_reading(vessel, [&] { write("wall.vtp", "two"); }), FileError);
  inputs.while_reading(vessel, [] {});
  EXPECT_EQ(inputs.hashes().at("wall.vtp"), sha256_of_file(*vessel.surface));
  write("wall.vtp", "three");
  EXPECT_NE(inputs.hashes().at("wall.vtp"), sha256_of_file(*vessel.surface));
}

}  // namespace
}  // namespace vasorod
