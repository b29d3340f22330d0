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

// The digests of "abc" and of "" are those of FIPS 180-4.
TEST_F(InputHashesOf, SceneAndSurfacesAreNamedByFile) {
  Scene scene;
  scene.file = write("scene.yaml", "abc");
  VesselSpec vessel;
  vessel.surface = write("svc.obj", "");
  scene.vessels = {vessel, VesselSpec{}};
  InputHashes inputs(scene);
  for (const VesselSpec& one : scene.vessels) inputs.add(one);
  ASSERT_EQ(inputs.hashes().size(), 2u);
  EXPECT_EQ(inputs.hashes().at("scene.yaml"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(inputs.hashes().at("svc.obj"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(InputHashesOf, TwoOfOneNameAreNamedByPath) {
  for (const char* sub : {"before", "after"}) std::filesystem::create_directories(folder / sub);
  Scene scene;
  scene.file = write("scene.yaml", "");
  for (const char* name : {"before/svc.obj", "after/svc.obj"})
    scene.vessels.emplace_back().surface = write(name, name);
  InputHashes inputs(scene);
  for (const VesselSpec& vessel : scene.vessels) inputs.add(vessel);
  EXPECT_EQ(inputs.hashes().count("svc.obj"), 0u);
  ASSERT_EQ(inputs.hashes().count("before/svc.obj"), 1u);
  ASSERT_EQ(inputs.hashes().count("after/svc.obj"), 1u);
  EXPECT_NE(inputs.hashes().at("before/svc.obj"), inputs.hashes().at("after/svc.obj"));
}

}  // namespace
}  // namespace vasorod
