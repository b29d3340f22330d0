#include <atomic>
#include <gtest/gtest.h>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

#include "data/crew.h"

namespace vasorod {
namespace {

// Works until so many threads do at once; the system may take its time to wake them.
class Meeting {
 public:
  explicit Meeting(int expected) : expected_(expected) {}

  void come() {
    {
      const std::lock_guard<std::mutex> alone(one_);
      came_.insert(std::this_thread::get_id());
    }
    while (count() < expected_) std::this_thread::yield();
  }
  std::set<std::thread::id> came() {
    const std::lock_guard<std::mutex> alone(one_);
    return came_;
  }

 private:
  int count() { return static_cast<int>(came().size()); }

  int expected_;
  std::mutex one_;
  std::set<std::thread::id> came_;
};

std::set<std::thread::id> meet(Crew& crew, int others) {
  Meeting meeting(others + 1);
  crew.run(others, [&] { meeting.come(); });
  return meeting.came();
}

TEST(Crew, TheSameThreadsWorkAgain) {
  Crew crew;
  const auto first = meet(crew, 2);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_TRUE(first.contains(std::this_thread::get_id()));
  for (int repeat = 0; repeat < 100; ++repeat) ASSERT_EQ(meet(crew, 2), first);
  EXPECT_EQ(meet(crew, 3).size(), 4U) << "another is begun";
}

// Longer pauses than a thread looks for work before it sleeps.
TEST(Crew, ThreadsThatSleepAreWoken) {
  Crew crew;
  const auto first = meet(crew, 2);
  for (int repeat = 0; repeat < 5; ++repeat) {
    usleep(2000);
    ASSERT_EQ(meet(crew, 2), first);
  }
}

TEST(Crew, AllHaveEndedWhenRunReturns) {
  Crew crew;
  for (int repeat = 0; repeat < 2000; ++repeat) {
    std::atomic<int> working = 0, done = 0;
    crew.run(3, [&] {
      ++working;
      ++done;
      --working;
    });
    ASSERT_EQ(working, 0);
    ASSERT_GE(done, 1);
    ASSERT_LE(done, 4);
  }
}

TEST(Crew, AtWorkItIsNoHelp) {
  Crew crew;
  std::atomic<int> inside = 0;
  crew.run(1, [&] { crew.run(5, [&] { ++inside; }); });
  EXPECT_GE(inside, 1);
  EXPECT_LE(inside, 2) << "one for each that asked";
}

TEST(Crew, WithoutOthersTheCallingThreadWorksAlone) {
  Crew crew;
  int calls = 0;
  for (const int others : {-1, 0}) crew.run(others, [&] { ++calls; });
  EXPECT_EQ(calls, 2);
}

TEST(Crew, EachThreadHasItsOwn) {
  Crew* mine = &Crew::mine();
  EXPECT_EQ(&Crew::mine(), mine);
  std::thread([mine] { EXPECT_NE(&Crew::mine(), mine); }).join();
}

// Only the thread that forks is in the new process.
TEST(Crew, AfterAForkOthersBegin) {
  ASSERT_EQ(meet(Crew::mine(), 1).size(), 2U);
  const pid_t process = fork();
  if (process == 0) _exit(meet(Crew::mine(), 1).size() == 2 ? 0 : 1);
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

}  // namespace
}  // namespace vasorod
