#include <chrono>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "result/example_result.h"
#include "result/folder_replacement.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void put(const fs::path& folder, const std::string& content) {
  FolderReplacement replacement(folder);
  replacement.write("data", content);
  replacement.commit();
}

TEST(FolderReplacement, MakesANewPlaceWithItsParents) {
  const test::TemporaryFolder base;
  put(base.path / "a" / "b" / "c", "1");
  EXPECT_EQ(text_of(base.path / "a/b/c/data"), "1");
  EXPECT_EQ(entries(base.path / "a/b"), 1u) << "something was left beside the result";
}

TEST(FolderReplacement, ATrailingSlashMeansTheSameFolder) {
  const test::TemporaryFolder base;
  put(base.path / "out/", "1");
  EXPECT_EQ(text_of(base.path / "out/data"), "1");
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, FillsAnEmptyFolder) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "out");
  put(base.path / "out", "1");
  EXPECT_EQ(text_of(base.path / "out/data"), "1");
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, ReplacesAFormerResultWhole) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "out");
  write(base.path / "out/result.json", to_json(test::example_result()));
  write(base.path / "out/old.vtp", "old");
  put(base.path / "out", "2");
  EXPECT_EQ(text_of(base.path / "out/data"), "2");
  EXPECT_FALSE(fs::exists(base.path / "out/old.vtp"));
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, FollowsALinkToAFormerResult) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "real");
  write(base.path / "real/result.json", to_json(test::example_result()));
  fs::create_directory_symlink("real", base.path / "link");
  put(base.path / "link", "2");
  EXPECT_TRUE(fs::is_symlink(base.path / "link"));
  EXPECT_EQ(text_of(base.path / "real/data"), "2");
}

TEST(FolderReplacement, LeavesAForeignFolderAlone) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "out");
  write(base.path / "out/thesis.tex", "years of work");
  EXPECT_THROW(require_replaceable(base.path / "out"), FileError);
  EXPECT_THROW(FolderReplacement(base.path / "out"), FileError);
  write(base.path / "out/result.json", R"({"schema": 1, "program": "other 1.0"})");
  EXPECT_THROW(FolderReplacement(base.path / "out"), FileError);
  EXPECT_EQ(text_of(base.path / "out/thesis.tex"), "years of work");
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, AForeignFileInAFormerResultIsNamedAndKept) {
  for (const std::string name :
       {"scene.yaml", ".git/", "svc.vtp/", "notes.png", "result.json.bak"}) {
    const test::TemporaryFolder base;
    const fs::path out = base.path / "out", mine = out / name;
    fs::create_directory(out);
    write(out / "result.json", to_json(test::example_result()));
    if (name.ends_with('/'))
      fs::create_directory(mine.parent_path());
    else
      write(mine, "years of work");
    try {
      FolderReplacement replacement(out);
      ADD_FAILURE() << name << " would be removed";
    } catch (const FileError& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(name.substr(0, name.find('/'))), std::string::npos) << said;
    }
    EXPECT_THROW(require_replaceable(out), FileError);
    EXPECT_TRUE(fs::exists(mine));
  }
}

TEST(FolderReplacement, ALinkInAFormerResultIsForeign) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "out");
  write(base.path / "out/result.json", to_json(test::example_result()));
  fs::create_symlink("../real.vtp", base.path / "out/svc.vtp");
  EXPECT_THROW(require_replaceable(base.path / "out"), FileError);
}

TEST(FolderReplacement, AnInputInsideIsRefused) {
  const test::TemporaryFolder base;
  const fs::path out = base.path / "out";
  fs::create_directories(out / "deep");
  write(out / "v.vtp", "a surface");
  write(out / "deep/v.vtp", "a surface");
  write(base.path / "v.vtp", "a surface");
  fs::create_symlink(out / "v.vtp", base.path / "link.vtp");
  fs::create_symlink(base.path / "v.vtp", out / "link.vtp");
  fs::create_directory_symlink(out, base.path / "same");
  for (const fs::path& inside :
       {out / "v.vtp", out / "deep/../v.vtp", out / "deep/v.vtp", base.path / "link.vtp",
        out / "link.vtp", base.path / "same/v.vtp"})
    for (const fs::path& folder : {out, base.path / "same", base.path / "out/"})
      EXPECT_THROW(require_outside(folder, {base.path / "v.vtp", inside}), FileError) << inside;
  EXPECT_NO_THROW(require_outside(out, {base.path / "v.vtp", ""}));
  EXPECT_NO_THROW(require_outside(base.path / "out2", {out / "v.vtp"}));
}

// As a killed run leaves it; another's that still runs stays.
TEST(FolderReplacement, WhatAKilledRunLeftIsRemovedByTheNext) {
  const test::TemporaryFolder base;
  const pid_t ended = fork();
  if (ended == 0) _exit(0);
  waitpid(ended, nullptr, 0);
  const auto left = [&](const std::string& name) {
    fs::create_directory(base.path / name);
    write(base.path / name / "svc.vtp", "half");
    return base.path / name;
  };
  const fs::path dead = left(".out.writing-" + std::to_string(ended) + "-AbCdEf"),
                 living = left(".out.writing-" + std::to_string(getppid()) + "-AbCdEf"),
                 other = left(".out2.writing-" + std::to_string(ended) + "-AbCdEf"),
                 fresh = left(".out.writing-AbCdEf"), old = left(".out.writing-GhIjKl");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(48));
  put(base.path / "out", "1");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_FALSE(fs::exists(old));
  for (const fs::path& kept : {living, other, fresh}) EXPECT_TRUE(fs::exists(kept)) << kept;
}

TEST(FolderReplacement, ANameTheFileSystemDoesNotTakeIsRefusedBeforehand) {
  const test::TemporaryFolder base;
  EXPECT_THROW(require_replaceable(base.path / std::string(300, 'x')), FileError);
  EXPECT_THROW(require_replaceable(base.path / std::string(300, 'x') / "out"), FileError);
  EXPECT_THROW(require_replaceable(base.path / "not-there" / std::string(300, 'x')), FileError);
  fs::path deep = base.path;
  for (int i = 0; i < 50; ++i) deep /= std::string(100, 'y');
  EXPECT_THROW(require_replaceable(deep), FileError);
  const std::string longest(255, 'z');
  require_replaceable(base.path / longest);
  put(base.path / longest, "1");
  EXPECT_EQ(text_of(base.path / longest / "data"), "1");
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, ASignalHandlerRemovesWhatIsHalfWritten) {
  const test::TemporaryFolder base;
  FolderReplacement replacement(base.path / "out");
  replacement.write("a.vtp", "half");
  replacement.write("b.vtp", "half");
  EXPECT_TRUE(remove_unfinished_folder());
  EXPECT_TRUE(fs::is_empty(base.path));
}

// Processes that make result folders, one after the other, are stopped at some moment. Each makes
// those of another place, or the next one would remove what it left.
TEST(FolderReplacement, ASignalAtAnyMomentLeavesNothingHalfWritten) {
  const test::TemporaryFolder base;
  constexpr int processes = 60;
  for (int k = 0; k < processes; ++k) {
    const fs::path place = base.path / std::to_string(k);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      std::signal(SIGTERM, [](int) {
        if (remove_unfinished_folder()) _exit(0);
      });
      while (true) const FolderReplacement replacement(place);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(3000 + 37 * k));
    kill(child, SIGTERM);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
  }
  EXPECT_TRUE(fs::is_empty(base.path)) << entries(base.path) << " of " << processes << " left";
}

TEST(FolderReplacement, AFileInThePlaceOrAboveItIsRefused) {
  const test::TemporaryFolder base;
  write(base.path / "out", "a file");
  EXPECT_THROW(FolderReplacement(base.path / "out"), FileError);
  EXPECT_THROW(FolderReplacement(base.path / "out" / "below"), FileError);
  EXPECT_EQ(text_of(base.path / "out"), "a file");
  EXPECT_THROW(FolderReplacement(""), FileError);
}

TEST(FolderReplacement, TheCurrentFolderIsRefused) {
  const test::TemporaryFolder base;
  const fs::path before = fs::current_path();
  fs::create_directories(base.path / "out/inner");
  fs::current_path(base.path / "out/inner");
  EXPECT_THROW(FolderReplacement("."), FileError);
  fs::remove(base.path /
             "out/inner");  // so that `out` is empty, and the current folder no longer exists
  fs::current_path(base.path / "out");
  EXPECT_THROW(FolderReplacement(base.path / "out"), FileError);
  fs::current_path(before);
}

// In a separate process, which gives up root's right to write anywhere if the tests have it.
TEST(FolderReplacement, AFolderThatCannotBeWrittenToIsRefused) {
  const test::TemporaryFolder base;
  fs::permissions(base.path, static_cast<fs::perms>(0555));
  const auto try_to_write = [&] {
    if (geteuid() == 0 && setuid(65534) != 0) _exit(2);
    try {
      put(base.path / "out", "1");
    } catch (const FileError&) {
      _exit(0);
    }
    _exit(1);
  };
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // VTK may have started threads
  EXPECT_EXIT(try_to_write(), testing::ExitedWithCode(0), "");
  fs::permissions(base.path, fs::perms::owner_all);
  EXPECT_TRUE(fs::is_empty(base.path));
}

TEST(FolderReplacement, WithoutCommitTheOldResultStays) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "out");
  write(base.path / "out/result.json", to_json(test::example_result()));
  {
    FolderReplacement replacement(base.path / "out");
    replacement.write("data", "half");
    EXPECT_EQ(entries(base.path / "out"), 1u);
  }
  EXPECT_EQ(text_of(base.path / "out/result.json"), to_json(test::example_result()));
  EXPECT_EQ(entries(base.path), 1u);
}

TEST(FolderReplacement, WhatAppearedMeanwhileIsNotOverwritten) {
  const test::TemporaryFolder base;
  FolderReplacement replacement(base.path / "out");
  replacement.write("data", "ours");
  fs::create_directory(base.path / "out");
  write(base.path / "out/theirs", "theirs");
  EXPECT_THROW(replacement.commit(), FileError);
  EXPECT_EQ(text_of(base.path / "out/theirs"), "theirs");
}

TEST(FolderReplacement, AFileThatCannotBeWrittenIsAnError) {
  const test::TemporaryFolder base;
  FolderReplacement replacement(base.path / "out");
  EXPECT_THROW(replacement.write("no/such/folder", "x"), FileError);
}

TEST(FolderReplacement, HasThePermissionsOfAnyNewFolder) {
  const test::TemporaryFolder base;
  fs::create_directory(base.path / "plain");
  put(base.path / "out", "1");
  EXPECT_EQ(fs::status(base.path / "out").permissions(),
            fs::status(base.path / "plain").permissions());
}

}  // namespace
}  // namespace vasorod
