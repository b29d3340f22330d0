#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "result/example_result.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ResultFolder, HoldsWhatTheContractSays) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  write_result_folder(result, base.path / "out");
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(base.path / "out"))
    names.insert(entry.path().filename().string());
  for (const char* name :
       {"result.json", "scene.pvd", "svc.vtp", "svc_centerline.vtp", "svc_stump.vtp", "aorta.vtp"})
    EXPECT_EQ(names.count(name), 1u) << name;
  EXPECT_EQ(names.count("aorta_centerline.vtp"), 0u);
  EXPECT_EQ(text_of(base.path / "out/result.json"), to_json(result));
}

TEST(ResultFolder, WithoutAReportItHoldsNumbersAndVtpOnly) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  write_result_folder(result, base.path / "out");  // whose pictures and page are to go
  EXPECT_TRUE(fs::exists(base.path / "out/report.html"));
  WriteOptions options;
  options.report = false;
  write_result_folder(result, base.path / "out", options);
  for (const auto& entry : fs::directory_iterator(base.path / "out")) {
    const std::string name = entry.path().filename().string(), end = entry.path().extension();
    EXPECT_TRUE(end == ".vtp" || name == "scene.pvd" || name == "result.json") << name;
  }
  EXPECT_EQ(text_of(base.path / "out/result.json"), to_json(result));
}

TEST(ResultFolder, EverythingItWritesItMayReplace) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  write_result_folder(result, base.path / "out");
  write_result_folder(result, base.path / "out");
  EXPECT_EQ(text_of(base.path / "out/result.json"), to_json(result));
}

TEST(ResultFolder, CountsItsOwnTime) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  write_result_folder(result, base.path / "out");
  ASSERT_EQ(result.seconds.count("write"), 1U);
  EXPECT_DOUBLE_EQ(result.seconds.at("total"), 1.0 + result.seconds.at("write"));
}

TEST(ResultFolder, TwoWritesDifferOnlyInSeconds) {
  const test::TemporaryFolder base;
  Result first = test::example_result(), second = test::example_result();
  write_result_folder(first, base.path / "first");
  write_result_folder(second, base.path / "second");
  for (const auto& entry : fs::directory_iterator(base.path / "first")) {
    const std::string name = entry.path().filename().string();
    if (name == "result.json" || name == "report.html") continue;
    EXPECT_EQ(text_of(entry.path()), text_of(base.path / "second" / name)) << name;
  }
  auto a = nlohmann::json::parse(text_of(base.path / "first/result.json"));
  auto b = nlohmann::json::parse(text_of(base.path / "second/result.json"));
  a.erase("seconds");
  b.erase("seconds");
  EXPECT_EQ(a, b);
}

TEST(ResultFolder, NamesThatWouldShareAFileAreRefused) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  result.vessels[1].name = "svc_centerline";
  EXPECT_THROW(write_result_folder(result, base.path / "out"), InputError);
  EXPECT_TRUE(fs::is_empty(base.path));
}

TEST(ResultFolder, ABareRodHasNoSurfaceFile) {
  const test::TemporaryFolder base;
  Result result = test::example_result();
  result.vessels.resize(1);
  VesselResult rod;
  rod.name = "rod";
  rod.centerline = result.vessels[0].centerline;
  result.vessels = {rod};
  result.stages.clear();
  write_result_folder(result, base.path / "out");
  EXPECT_FALSE(fs::exists(base.path / "out/rod.vtp"));
  EXPECT_TRUE(fs::exists(base.path / "out/rod_centerline.vtp"));
}

}  // namespace
}  // namespace vasorod
