// Threads that stay for the next work to share: to begin and end one takes longer than much of what
// is shared. One that has just worked looks for more before it sleeps.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vasorod {

/// The threads that work beside one, the owner. They begin when they are first asked for and end
/// with the owner. In a process that a fork made there are none: the owner begins others.
class Crew {
 public:
  /// That of the calling thread.
  static Crew& mine();

  Crew() = default;
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Calls `work`, which throws nothing, on the calling thread, and at the same time on up to
  /// `others` more: fewer where the system gives none or where they come too late, none where the
  /// crew is at work already. Returns when all have ended.
  void run(int others, const std::function<void()>& work);

 private:
  void begin(int others);
  void wait_for_work();

  std::vector<std::thread> threads_;
  std::mutex one_;
  std::condition_variable called_, ended_;
  const std::function<void()>* work_ = nullptr;  // nullptr: none is to begin
  std::atomic<int> wanted_ = 0, working_ = 0;    // threads; changed by who holds `one_`
  bool over_ = false;
};

}  // namespace vasorod
