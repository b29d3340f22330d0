// `vasorod explore` as a user runs it: a table, a page, kept results; stopped, killed, refused.
#include <algorithm>
#include <csignal>
#include <gtest/gtest.h>
#include <sstream>
#include <thread>

#include "program/run_program.h"
#include "program/running_program.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

class Explore : public ::testing::Test {
 protected:
  std::string scene(const std::string& options) const {
    std::ofstream(scratch / "scene.yaml")
        << small_glenn("skin") << "explore: {" << options << "}\n";
    return (scratch / "scene.yaml").string();
  }
  std::string dir() const { return (scratch / "dir").string(); }
  ProgramRun explore(const std::string& options, const std::string& more = "") const {
    return run_program(
        vasorod("explore '" + scene(options) + "' -o '" + dir() + "' --threads 2 " + more));
  }
  // Cells of options.csv; its sentences have no line breaks here.
  std::vector<std::vector<std::string>> table() const {
    std::vector<std::vector<std::string>> lines;
    std::istringstream csv(contents_of(scratch / "dir" / "options.csv"));
    for (std::string line; std::getline(csv, line);) {
      std::istringstream cells(line);
      lines.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) lines.back().push_back(cell);
    }
    return lines;
  }
  void expect_refused(const ProgramRun& run, int exit_code, const std::string& words) const {
    EXPECT_EQ(run.exit_code, exit_code) << run.out;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  std::size_t finished() const {
    std::error_code error;
    fs::directory_iterator entry(scratch / "dir" / "finished", error);
    return static_cast<std::size_t>(
        std::count_if(entry, fs::directory_iterator(),
                      [](const auto& file) { return file.path().extension() == ".json"; }));
  }
  void wait_for_finished(std::size_t count) const {
    for (int i = 0; i < 3000 && finished() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_GE(finished(), count);
  }
  ScratchFolder scratch;
};

const std::string many = "rotation_deg: {from: -180, to: 180, steps: 200}, stages: skin";

TEST_F(Explore, WritesATableAPageAndTheKeptResults) {
  const ProgramRun run = explore("rotation_deg: [0, 45], stages: skin");
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_EQ(run.err, "");  // nothing of progress in a pipe
  EXPECT_NE(run.out.find("2 options, 2 converged at skin"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("1. rotation_deg 0: converged (skin)"), std::string::npos) << run.out;
  const auto lines = table();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0][2], "rotation_deg");
  EXPECT_EQ(lines[1][2], "0");
  EXPECT_EQ(lines[2][2], "45");
  const fs::path kept = scratch / "dir" / "options" / (lines[1][1] + "-skin");
  EXPECT_TRUE(fs::exists(kept / "result.json"));
  EXPECT_TRUE(fs::exists(kept / "report.html"));
  const std::string page = contents_of(scratch / "dir" / "index.html");
  EXPECT_NE(page.find("iVBORw0KGgo"), std::string::npos);  // pictures
}

TEST_F(Explore, OptionsThatCannotBeBuiltAreNoFailure) {
  const ProgramRun run =
      explore("incision_along: [0.5, 0.02], around_deg: 0, stages: skin", "--no-report");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("1 cannot be built"), std::string::npos) << run.out;
  const auto lines = table();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NE(std::find(lines[2].begin(), lines[2].end(), "not_built"), lines[2].end());
}

TEST_F(Explore, WithoutAConvergedOptionItIsOneAndSaysWhy) {
  const ProgramRun run = explore("incision_along: [0.01, 0.02], around_deg: 0", "--no-report");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find(", expected "), std::string::npos) << run.out;
  EXPECT_EQ(finished(), 2U);
}

TEST_F(Explore, TheCommandLineSaysStagesAndBest) {
  const ProgramRun run =
      explore("rotation_deg: [0, 45, 90]", "--no-report --stages rod,skin --best 1");
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_NE(run.out.find("3 options, 1 converged at skin"), std::string::npos) << run.out;
  EXPECT_EQ(finished(), 4U);
}

TEST_F(Explore, ListedOptionsAreSolvedOneByOne) {
  const std::string options = "rotation_deg: [0, 45], stages: skin";
  const ProgramRun listed = explore(options, "--list 1");
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  std::istringstream names(listed.out);
  std::size_t count = 0;
  for (std::string name; std::getline(names, name);) {
    EXPECT_EQ(finished(), count++);
    const ProgramRun one = explore(options, "--no-report --only " + name);
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_TRUE(fs::exists(scratch / "dir" / "options" / name / "result.json"));
  }
  EXPECT_EQ(count, 2U);
  EXPECT_FALSE(fs::exists(scratch / "dir" / "options.csv"));
  expect_refused(explore(options, "--list 2"), 2, "stage: found 2, expected 1 to 1");
  expect_refused(explore(options, "--only wrong"), 2, "found no option \"wrong\" of this scene");
}

TEST_F(Explore, RefinesAndSaysWhetherTheRankingSurvives) {
  const ProgramRun run = explore(
      "rotation_deg: [-60, 100], stages: skin, refine: {evaluations: 4}, vary: "
      "{uncertain: [{what: young, sd: 0.1}], samples: 2, best: 2}",
      "--no-report");
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_NE(run.out.find(" found by refining"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("% of 2 samples"), std::string::npos) << run.out;
  const auto lines = table();
  EXPECT_NE(std::find(lines[0].begin(), lines[0].end(), "score_low"), lines[0].end());
  EXPECT_NE(contents_of(scratch / "dir" / "index.html").find("Uncertainty"), std::string::npos);
}

TEST_F(Explore, BadInputIsOneSentence) {
  expect_refused(explore("cut_along: 2"), 2, "explore.cut_along: found 2, expected a number");
  expect_refused(explore("best: 3"), 2, "found no values, expected at least one of cut_along");
  expect_refused(explore("rotation_deg: 0", "--stages fine"), 2, "fine");
  std::ofstream(scratch / "plain.yaml") << small_glenn("skin");
  expect_refused(run_program(vasorod("explore '" + (scratch / "plain.yaml").string() + "' -o '" +
                                     (scratch / "other").string() + "'")),
                 2, "found no explore, expected explore: ");
  EXPECT_FALSE(fs::exists(scratch / "other"));
  fs::create_directories(scratch / "dir");
  fs::remove_all(scratch / "dir");
  fs::create_directories(scratch / "dir");
  std::ofstream(scratch / "dir" / "letter.txt") << "mine";
  expect_refused(explore("rotation_deg: 0"), 3, "holds files but no exploration of ours");
}

TEST_F(Explore, ASecondOneInTheFolderIsRefused) {
  RunningProgram first({"explore", scene(many), "-o", dir(), "--threads", "1", "--no-report"});
  wait_for_finished(1);
  const ProgramRun second = run_program(
      vasorod("explore '" + (scratch / "scene.yaml").string() + "' -o '" + dir() + "'"));
  expect_refused(second, 3, "another vasorod explore (process ");
  first.send(SIGINT);
  EXPECT_EQ(first.wait(), 1);
}

// Ctrl-C, a closed terminal, the end of a batch job.
TEST_F(Explore, ASignalEndsItWithWhatIsFinished) {
  for (const int signal : {SIGINT, SIGHUP, SIGTERM}) {
    fs::remove_all(scratch / "dir");
    RunningProgram run({"explore", scene(many), "-o", dir(), "--threads", "2", "--no-report"});
    wait_for_finished(3);
    run.send(signal);
    EXPECT_EQ(run.wait(), 1) << signal;
    EXPECT_LT(finished(), 200U);
    EXPECT_EQ(table().size(), 201U);
    EXPECT_NE(contents_of(scratch / "dir" / "index.html").find("stopped before its end"),
              std::string::npos);
    for (const auto& entry : fs::directory_iterator(scratch / "dir" / "options"))
      EXPECT_EQ(entry.path().filename().string()[0] == '.', false) << entry.path();
  }
}

TEST_F(Explore, AKilledRunGoesOnWhereItStopped) {
  const std::string few = "rotation_deg: {from: 0, to: 180, steps: 12}, stages: skin";
  {
    RunningProgram run({"explore", scene(few), "-o", dir(), "--threads", "2", "--no-report"});
    wait_for_finished(3);
    EXPECT_EQ(run.kill_now(), -SIGKILL);
  }
  const auto first =
      fs::last_write_time(fs::directory_iterator(scratch / "dir" / "finished")->path());
  const fs::path same = fs::directory_iterator(scratch / "dir" / "finished")->path();
  const ProgramRun again = explore(few, "--no-report");
  EXPECT_EQ(again.exit_code, 0) << again.err << again.out;
  EXPECT_EQ(finished(), 12U);
  EXPECT_EQ(fs::last_write_time(same), first);  // not solved a second time
  const auto resumed = table();
  fs::remove_all(scratch / "dir");
  ASSERT_EQ(explore(few, "--no-report").exit_code, 0);
  const auto whole = table();
  ASSERT_EQ(resumed.size(), whole.size());
  const auto seconds = std::find(whole[0].begin(), whole[0].end(), "seconds") - whole[0].begin();
  for (std::size_t k = 0; k < whole.size(); ++k)
    for (std::size_t cell = 0; cell < whole[k].size(); ++cell)
      if (static_cast<std::ptrdiff_t>(cell) != seconds || k == 0) {
        EXPECT_EQ(resumed[k][cell], whole[k][cell]) << k << ' ' << cell;
      }
}

TEST_F(Explore, ATimeLimitEndsItWithWhatIsFinished) {
  const ProgramRun run =
      run_program("timeout -k 1 60 " + vasorod("explore '" + scene(many) + "' -o '" + dir() +
                                               "' --threads 2 --no-report --time-limit 2"));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("stopped before its end"), std::string::npos) << run.out;
  EXPECT_LT(finished(), 200U);
}

// A limit of the files' size ends writes as a full disk does.
TEST_F(Explore, AFullDiskIsThreeAndLosesNothingFinished) {
  const std::string options = "rotation_deg: [0, 45], stages: [rod, skin]";
  ASSERT_EQ(explore(options, "--no-report --stages rod").exit_code, 0);
  const std::size_t before = finished();
  EXPECT_EQ(before, 2U);
  const ProgramRun run = run_program("bash -c 'ulimit -f 8; exec \"$@\"' - " +
                                     vasorod("explore '" + (scratch / "scene.yaml").string() +
                                             "' -o '" + dir() + "' --threads 2"));
  EXPECT_EQ(run.exit_code, 3) << run.out;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("cannot be written"), std::string::npos) << run.err;
  EXPECT_EQ(finished(), before);
  EXPECT_EQ(explore(options, "--no-report").exit_code, 0);
}

}  // namespace
}  // namespace vasorod::testing
