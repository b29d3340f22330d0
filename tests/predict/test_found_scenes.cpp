// Scenes of the fuzz target `solve` that crashed or hung an earlier version: each is solved or
// refused.
#include <filesystem>
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/predict.h>
#include <vasorod/read_scene.h>

namespace vasorod {
namespace {

TEST(FoundScenes, AreSolvedOrRefused) {
  int scenes = 0;
  const auto found = std::filesystem::path(VASOROD_SOURCE_DIR) / "tests/fuzz/found/solve";
  for (const auto& entry : std::filesystem::directory_iterator(found)) {
    ++scenes;
    try {
      const Result result = predict(read_scene(entry.path()));
      if (result.status != Status::converged) continue;
      for (const VesselResult& vessel : result.vessels)
        EXPECT_TRUE(vessel.current.allFinite()) << entry.path();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(", expected "), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(scenes, 0);
}

}  // namespace
}  // namespace vasorod
