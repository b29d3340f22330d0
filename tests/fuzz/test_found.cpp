// Every file in found/ once hung, crashed, filled the memory or was silently accepted. Each is
// refused with one sentence or read as what it then says; ctest ends what takes longer than
// TIMEOUT.
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <vasorod/compare.h>
#include <vasorod/error.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "mask/mask_surface.h"
#include "result/example_result.h"
#include "result/read_vtp.h"
#include "result/write_vtp.h"
#include "scratch_folder.h"
#include "surface_file/read_surface.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;

const fs::path found = fs::path(VASOROD_SOURCE_DIR) / "tests/fuzz/found";
const fs::path seeds = fs::path(VASOROD_SOURCE_DIR) / "tests/fuzz/seeds";

std::vector<fs::path> files(const std::string& folder, const std::string& ending) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(found / folder))
    if (entry.is_regular_file() && entry.path().extension() == ending) all.push_back(entry.path());
  EXPECT_FALSE(all.empty()) << folder;
  return all;
}

// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): a fixture; gtest deletes the test
class Found : public ScratchFolder {
 protected:
  ~Found() override {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    EXPECT_LT(used.ru_maxrss, 1'000'000) << "kilobytes";
  }
  // The sentence, or nothing where `read` comes back.
  template <class Read>
  static std::string refusal(const Read& read) {
    try {
      read();
    } catch (const InputError& error) {
      std::string sentence = error.what();
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      EXPECT_LT(sentence.size(), 600U) << sentence;
      return sentence;
    }
    return "";
  }
  std::string refusal_of_surface(const fs::path& file) const {
    return refusal([&] {
      const LoadedSurface loaded = load_surface({.name = "vessel", .surface = file}, Scene());
      EXPECT_TRUE(loaded.surface.points.allFinite());
      EXPECT_GT(loaded.surface.triangles.rows(), 0);
      EXPECT_GE(loaded.surface.triangles.minCoeff(), 0);
      EXPECT_LT(loaded.surface.triangles.maxCoeff(), loaded.surface.points.rows());
    });
  }
};

TEST_F(Found, ScenesAreRefused) {
  for (const char* kind : {"", "scene_comma"})
    for (const fs::path& file : files(kind, ".yaml")) {
      const std::string sentence = refusal([&] { read_scene(file); });
      EXPECT_EQ(sentence.rfind(file.string() + ":", 0), 0U) << file << ": " << sentence;
      EXPECT_NE(sentence.find(", expected "), std::string::npos) << file << ": " << sentence;
    }
}

TEST_F(Found, SurfacesAreRefused) {
  for (const char* ending : {".vtp", ".stl"})
    for (const fs::path& file : files("", ending))
      EXPECT_NE(refusal_of_surface(file).find("damaged or truncated"), std::string::npos) << file;
}

TEST_F(Found, SurfacesThatFilledTheMemoryAreReadOrRefused) {
  for (const fs::path& file : files("vtp_memory", "")) {
    fs::copy_file(file, folder / "vessel.vtp", fs::copy_options::overwrite_existing);
    refusal_of_surface(folder / "vessel.vtp");
    refusal([&] { read_vessel_vtp(folder / "vessel.vtp"); });
    refusal([&] { read_centerline_vtp(folder / "vessel.vtp"); });
  }
}

TEST_F(Found, MasksAreRefused) {
  for (const char* ending : {".nrrd", ".mha"})
    for (const fs::path& file : files("mask", ending))
      EXPECT_NE(refusal([&] { read_mask(file); }).find(", expected "), std::string::npos) << file;
}

TEST_F(Found, NamesThatAreNotEscapedAreRefusedAndEscapedOnesRead) {
  EXPECT_EQ(refusal_of_surface(found / "array_name/in.vtp"), "");
  EXPECT_NE(refusal_of_surface(found / "array_name/result_not_wellformed.vtp"), "");
}

TEST_F(Found, ResultsAreComparedOrRefused) {
  const Result result = test::example_result();
  for (const char* side : {"a", "b"}) {
    fs::create_directories(folder / side);
    std::ofstream(folder / side / "result.json") << to_json(result);
    for (const VesselResult& vessel : result.vessels) {
      if (vessel.rest.rows() > 0)
        std::ofstream(folder / side / (vessel.name + ".vtp")) << vessel_vtp(vessel);
      if (vessel.centerline)
        std::ofstream(folder / side / (vessel.name + "_centerline.vtp"))
            << centerline_vtp(*vessel.centerline);
    }
  }
  ASSERT_EQ(refusal([&] { compare_results(folder / "a", folder / "b"); }), "");
  for (const char* name : {"svc.vtp", "svc_centerline.vtp"})
    for (const fs::path& file : files("compare", ".vtp")) {
      const fs::path replaced = folder / "a" / name;
      fs::rename(replaced, folder / "kept");
      fs::copy_file(file, replaced);
      refusal([&] { compare_results(folder / "a", folder / "b"); });
      refusal([&] { compare_results(folder / "b", folder / "a"); });
      refusal([&] { compare_results(folder / "a", folder / "a"); });
      fs::remove(replaced);
      fs::rename(folder / "kept", replaced);
    }
}

// What the fuzz targets start from must be sound, or they would fuzz the first check alone. The
// surfaces were written by make_seeds.py, which shares no code with the readers.
TEST_F(Found, SeedsAreRead) {
  int surfaces = 0;
  for (const char* format : {"vtp", "ply", "stl", "obj"})
    for (const auto& entry : fs::directory_iterator(seeds / format)) {
      const LoadedSurface loaded =
          load_surface({.name = "vessel", .surface = entry.path()}, Scene());
      EXPECT_EQ(loaded.surface.points.rows(), 18) << entry.path();
      EXPECT_EQ(loaded.surface.triangles.rows(), 24) << entry.path();
      EXPECT_EQ(loaded.surface.points.col(2).maxCoeff(), 12) << entry.path();
      ++surfaces;
    }
  EXPECT_EQ(surfaces, 17);
  int masks = 0;
  for (const auto& entry : fs::directory_iterator(seeds / "mask")) {
    if (!is_mask(entry.path())) continue;  // voxels.raw
    const Mask mask = read_mask(entry.path());
    EXPECT_EQ(mask.label.size(), 60U) << entry.path();
    EXPECT_EQ(mask.count, (std::map<std::int32_t, std::int64_t>{{1, 6}})) << entry.path();
    EXPECT_NEAR(mask_surface("mask", mask, {}).voxel, std::cbrt(1.6), 1e-6) << entry.path();
    ++masks;
  }
  EXPECT_EQ(masks, 12);
  for (const char* scenes : {"scene", "solve"})
    for (const auto& entry : fs::directory_iterator(seeds / scenes))
      EXPECT_EQ(refusal([&] { read_scene(entry.path()); }), "") << entry.path();
}

}  // namespace
}  // namespace vasorod
