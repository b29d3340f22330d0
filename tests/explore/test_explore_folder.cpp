#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

#include <vasorod/error.h>

#include "explore/explore_folder.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

class ExploreFolderTest : public ScratchFolder {
 protected:
  std::string refusal() const {
    try {
      const ExploreFolder taken(folder / "dir");
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
};

Row finished_row() {
  Row row;
  row.option = "0123456789abcdef";
  row.fidelity = "skin";
  row.ending = Ending::solved;
  row.status = Status::converged;
  row.criteria = {{"twist_shear", 0.1}};
  return row;
}

TEST_F(ExploreFolderTest, ASecondOneIsRefusedUntilTheFirstEnds) {
  auto first = std::make_unique<ExploreFolder>(folder / "dir");
  const std::string sentence = refusal();
  EXPECT_NE(sentence.find("another vasorod explore (process " + std::to_string(getpid()) + ")"),
            std::string::npos)
      << sentence;
  first.reset();
  EXPECT_EQ(refusal(), "");
}

TEST_F(ExploreFolderTest, ThoseThatShareItAreTogetherAndKeepAnotherOut) {
  using Sharing = ExploreFolder::Sharing;
  auto first = std::make_unique<ExploreFolder>(folder / "dir", Sharing::together);
  std::ofstream(folder / "dir" / "finished" / ".a.json.writing-1") << "half";
  auto second = std::make_unique<ExploreFolder>(folder / "dir", Sharing::together);
  EXPECT_TRUE(fs::exists(folder / "dir" / "finished" / ".a.json.writing-1"));  // another's
  EXPECT_THROW(ExploreFolder(folder / "dir"), FileError);
  first.reset();
  EXPECT_THROW(ExploreFolder(folder / "dir"), FileError);
  second.reset();
  const ExploreFolder alone(folder / "dir");
  EXPECT_FALSE(fs::exists(folder / "dir" / "finished" / ".a.json.writing-1"));
  EXPECT_THROW(ExploreFolder(folder / "dir", Sharing::together), FileError);
}

TEST_F(ExploreFolderTest, AKilledOneBlocksNothing) {
  const pid_t process = fork();
  if (process == 0) {
    const ExploreFolder taken(folder / "dir");
    std::ofstream(taken.path() / "done");
    for (;;) pause();
  }
  for (int i = 0; i < 500 && !fs::exists(folder / "dir" / "done"); ++i) usleep(10'000);
  EXPECT_NE(refusal(), "");
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  // What it was writing.
  std::ofstream(folder / "dir" / (".options.csv.writing-" + std::to_string(process))) << "half";
  EXPECT_EQ(refusal(), "");
  for (const auto& entry : fs::directory_iterator(folder / "dir"))
    EXPECT_EQ(entry.path().filename().string().find(".writing-"), std::string::npos);
}

TEST_F(ExploreFolderTest, ForeignFilesAreNotTouched) {
  fs::create_directories(folder / "dir");
  std::ofstream(folder / "dir" / "letter.txt") << "mine";
  EXPECT_NE(refusal().find("holds files but no exploration of ours"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "dir" / "explore.lock"));
  fs::remove_all(folder / "dir");
  std::ofstream(folder / "dir") << "a file";
  EXPECT_NE(refusal().find("is a file"), std::string::npos);
}

TEST_F(ExploreFolderTest, FinishedRowsAreFoundAgain) {
  const ExploreFolder taken(folder / "dir");
  Row row = finished_row();
  taken.finish(row);
  Row same;
  same.option = row.option;
  same.fidelity = row.fidelity;
  ASSERT_TRUE(taken.find(same, false));
  EXPECT_EQ(same.criteria, row.criteria);
  Row other = same;
  other.fidelity = "coupled";
  EXPECT_FALSE(taken.find(other, false));
  // A result folder belongs to it, and is not there.
  EXPECT_FALSE(taken.find(same, true));
  fs::create_directories(taken.path() / ExploreFolder::kept(same));
  std::ofstream(taken.path() / ExploreFolder::kept(same) / "result.json") << "{}";
  EXPECT_TRUE(taken.find(same, true));
  std::ofstream(taken.path() / "finished" / (row.name() + ".json")) << "{\"half\": ";
  EXPECT_FALSE(taken.find(same, false));
}

}  // namespace
}  // namespace vasorod::testing
