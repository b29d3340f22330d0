// Jobs in processes of their own: what comes back, what a crash loses, and that nothing outlives.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <vasorod/error.h>

#include "explore/apart.h"
#include "numerics/threads.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

class Apart : public ScratchFolder {};

using namespace std::chrono_literals;

std::map<int, ApartEnding> endings_of(int count, const std::function<std::string(int)>& job,
                                      const ApartOptions& options) {
  std::map<int, ApartEnding> endings;
  EXPECT_TRUE(run_apart(
      count, job, [&](int k, const ApartEnding& ending) { endings.emplace(k, ending); }, options));
  return endings;
}

bool alive(pid_t process) {
  return kill(process, 0) == 0;
}

TEST_F(Apart, EveryJobAnswersWhateverTheNumberOfProcesses) {
  // Longer than what a pipe holds.
  const auto job = [](int k) { return std::string(300'000, 'a') + std::to_string(k * k); };
  for (const int at_once : {1, 2, 7}) {
    const auto endings = endings_of(5, job, {at_once, {}, {}});
    ASSERT_EQ(endings.size(), 5U);
    for (const auto& [k, ending] : endings) EXPECT_EQ(ending.answer, job(k)) << at_once;
  }
}

TEST_F(Apart, NoMoreRunAtOnceThanAsked) {
  const auto job = [](int) {
    const auto begin = std::chrono::steady_clock::now().time_since_epoch().count();
    std::this_thread::sleep_for(30ms);
    const auto end = std::chrono::steady_clock::now().time_since_epoch().count();
    return std::to_string(begin) + " " + std::to_string(end);
  };
  std::vector<std::pair<long, int>> changes;
  for (const auto& [k, ending] : endings_of(8, job, {2, {}, {}})) {
    std::istringstream times(ending.answer.value());
    long begin = 0, end = 0;
    times >> begin >> end;
    changes.emplace_back(begin, 1);
    changes.emplace_back(end, -1);
  }
  std::sort(changes.begin(), changes.end());
  int running = 0, most = 0;
  for (const auto& [time, change] : changes) most = std::max(most, running += change);
  EXPECT_LE(most, 2);
}

// A job waits until it has the threads of the one beside it, which ends first.
TEST_F(Apart, ThreadsOfThoseThatHaveEndedAreTheOthers) {
  const auto job = [](int k) -> std::string {
    const int first = threads();
    const auto last = std::chrono::steady_clock::now() + 20s;
    while (k == 2 && threads() == 1 && std::chrono::steady_clock::now() < last)
      std::this_thread::sleep_for(1ms);
    if (k == 1) std::this_thread::sleep_for(100ms);
    return std::to_string(first) + " " + std::to_string(threads());
  };
  const auto endings = endings_of(3, job, {2, {}, {}});
  EXPECT_EQ(endings.at(0).answer, "1 1");
  EXPECT_EQ(endings.at(1).answer, "1 1");
  EXPECT_EQ(endings.at(2).answer, "1 2");
  EXPECT_EQ(endings_of(1, job, {4, {}, {}}).at(0).answer, "4 4");
}

// As many processes as run at once: each does one job after the other, and what a job leaves behind
// is there for the next.
TEST_F(Apart, AProcessGoesOnUntilAJobFails) {
  int done = 0;
  const auto job = [&](int k) -> std::string {
    ++done;  // of this process's copy
    if (k == 2) throw std::runtime_error("a sentence");
    return std::to_string(getpid()) + " " + std::to_string(done);
  };
  const auto endings = endings_of(5, job, {1, {}, {}});
  std::vector<std::pair<pid_t, int>> said;
  for (const int k : {0, 1, 3, 4}) {
    std::istringstream answer(endings.at(k).answer.value());
    answer >> said.emplace_back().first >> said.back().second;
  }
  EXPECT_EQ(done, 0);
  EXPECT_NE(said[0].first, getpid());
  EXPECT_EQ(said[1].first, said[0].first);
  EXPECT_NE(said[2].first, said[0].first);
  EXPECT_EQ(said[3].first, said[2].first);
  EXPECT_EQ(said[0].second, 1);
  EXPECT_EQ(said[1].second, 2);
  EXPECT_EQ(said[2].second, 1);
  EXPECT_EQ(said[3].second, 2);
}

TEST_F(Apart, WhatGoesWrongIsSaidAndLosesOneJobAlone) {
  const auto endings = endings_of(6,
                                  [](int k) -> std::string {
                                    if (k == 1) throw FileError("disk: no room");
                                    if (k == 2) throw std::runtime_error("a sentence");
                                    if (k == 3) raise(SIGKILL);
                                    if (k == 4) _exit(7);
                                    return "fine";
                                  },
                                  {2, {}, {}});
  ASSERT_EQ(endings.size(), 6U);
  EXPECT_EQ(endings.at(0).answer, "fine");
  EXPECT_EQ(endings.at(1).file_error, "disk: no room");
  EXPECT_EQ(endings.at(2).failure, "a sentence");
  EXPECT_NE(endings.at(3).failure.find("signal 9 (Killed)"), std::string::npos);
  EXPECT_NE(endings.at(4).failure.find("exit code 7"), std::string::npos);
  EXPECT_EQ(endings.at(5).answer, "fine");
  for (int k = 1; k < 5; ++k) EXPECT_FALSE(endings.at(k).answer) << k;
}

// The job that is stopped writes its number first; afterwards no process has it.
void expect_ended(const std::filesystem::path& file) {
  std::ifstream stream(file);
  pid_t process = 0;
  ASSERT_TRUE(stream >> process);
  for (int i = 0; i < 500 && alive(process); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_FALSE(alive(process));
}

std::string sleep_forever(const std::filesystem::path& file) {
  std::ofstream(file) << getpid() << '\n' << std::flush;
  for (;;) std::this_thread::sleep_for(1s);
}

TEST_F(Apart, AStopEndsWhatRunsEvenWhereItDoesNotListen) {
  const auto file = folder / "process";
  int taken = 0;
  const bool whole = run_apart(
      3,
      [&](int) -> std::string {
        std::signal(SIGTERM, SIG_IGN);
        return sleep_forever(file);
      },
      [&](int, const ApartEnding&) { ++taken; },
      {1, [&] { return std::filesystem::exists(file); }, {}});
  EXPECT_FALSE(whole);
  EXPECT_EQ(taken, 0);
  expect_ended(file);
}

TEST_F(Apart, AnExceptionWhileTakingEndsWhatRuns) {
  const auto file = folder / "process";
  EXPECT_THROW(run_apart(
                   2,
                   [&](int k) -> std::string {
                     if (k == 1) return sleep_forever(file);
                     while (!std::filesystem::exists(file)) std::this_thread::sleep_for(5ms);
                     return "";
                   },
                   [](int, const ApartEnding&) { throw FileError("no room"); }, {2, {}, {}}),
               FileError);
  expect_ended(file);
}

TEST_F(Apart, AProcessEndsWithItsParent) {
  const auto file = folder / "process";
  const pid_t parent = fork();
  if (parent == 0) {
    run_apart(
        1, [&](int) { return sleep_forever(file); }, [](int, const ApartEnding&) {}, {1, {}, {}});
    _exit(0);
  }
  for (int i = 0; i < 500 && !std::filesystem::exists(file); ++i) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(50ms);
  kill(parent, SIGKILL);
  int status = 0;
  waitpid(parent, &status, 0);
  expect_ended(file);
}

}  // namespace
}  // namespace vasorod::testing
