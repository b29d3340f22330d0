#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <tuple>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "result/example_result.h"
#include "result/read_json.h"

namespace vasorod {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

TEST(ReadJson, ReadsWhatAComparisonNeeds) {
  const test::TemporaryFolder folder;
  Result written = test::example_result();
  written.status = Status::not_unique;
  written.ends[0].force.y() = std::numeric_limits<double>::quiet_NaN();
  write(folder.path / "result.json", to_json(written));
  EXPECT_THROW(read_json(folder.path / "result.json"), InputError) << "its surfaces are missing";
  for (const char* name : {"svc.vtp", "svc_centerline.vtp", "aorta.vtp"})
    write(folder.path / name, "");
  const Result read = read_json(folder.path / "result.json");
  EXPECT_EQ(read.scene, "example");
  EXPECT_EQ(read.fidelity, "skin");
  EXPECT_EQ(read.status, Status::not_unique);
  EXPECT_EQ(read.length_unit, "mm");
  EXPECT_EQ(read.seconds, written.seconds);
  EXPECT_EQ(read.environment.inputs, written.environment.inputs);
  ASSERT_EQ(read.ends.size(), 1u);
  EXPECT_EQ(read.ends[0].force.x(), 0.1);
  EXPECT_TRUE(std::isnan(read.ends[0].force.y()));
  ASSERT_EQ(read.vessels.size(), 2u);
  EXPECT_EQ(read.vessels[1].name, "aorta");
  EXPECT_TRUE(read.vessels[1].obstacle);
}

TEST(ReadJson, WhatIsNotOursIsRefusedInASentence) {
  const test::TemporaryFolder folder;
  const auto file = folder.path / "result.json";
  EXPECT_THROW(read_json(file), InputError);
  for (const char* text :
       {"", "{", "[]", R"({"schema": 1})", R"({"schema": 1, "program": "other 2"})",
        R"({"schema": 1, "program": "vasorod 0.1.0"})"}) {
    write(file, text);
    EXPECT_THROW(read_json(file), InputError) << text;
  }
}

// Names become names of files and parts of messages.
TEST(ReadJson, NamesThatAreNoFilesOrSpanLinesAreRefusedOnOneLine) {
  const test::TemporaryFolder folder;
  const auto file = folder.path / "result.json";
  const auto refusal = [&](const std::string& before, const std::string& after) -> std::string {
    std::string text = to_json(test::example_result());
    const auto at = text.find(before);
    if (at == std::string::npos) return "nothing to replace";
    write(file, text.replace(at, before.size(), after));
    try {
      read_json(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  for (const auto& [before, after, word] :
       {std::tuple(R"("name": "svc")", R"("name": "../svc")", "../svc"),
        std::tuple(R"("name": "svc")", R"("name": "a\nb")", R"(a\nb)"),
        std::tuple(R"("status": ")", R"("status": "\n)", "the status"),
        std::tuple(R"("surface": ")", R"("surface": "\n)", R"(found no \n)")}) {
    const std::string found = refusal(before, after);
    EXPECT_NE(found.find(word), std::string::npos) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
}

TEST(ReadJson, KnowsAFolderOfOurs) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(holds_our_result(folder.path));
  write(folder.path / "result.json", R"({"schema": 1, "program": "other 2"})");
  EXPECT_FALSE(holds_our_result(folder.path));
  write(folder.path / "result.json", to_json(test::example_result()));
  EXPECT_TRUE(holds_our_result(folder.path));
}

}  // namespace
}  // namespace vasorod
