#include "data/crew.h"

#include <chrono>
#include <memory>
#include <pthread.h>
#include <system_error>

namespace vasorod {
namespace {

thread_local std::unique_ptr<Crew> crew;

// Looks for so long before it sleeps: about as long as the system takes to wake a thread.
constexpr std::chrono::microseconds patience{50};

template <class Condition>
void look_for(const Condition& condition) {
  const auto begin = std::chrono::steady_clock::now();
  do
    for (int i = 0; i < 16; ++i) {
      if (condition()) return;
      std::this_thread::yield();
    }
  while (std::chrono::steady_clock::now() - begin < patience);
}

}  // namespace

Crew& Crew::mine() {
  // The threads are not in the new process, so nothing may wait for them there.
  [[maybe_unused]] static const int forks =
      pthread_atfork(nullptr, nullptr, [] { static_cast<void>(crew.release()); });
  if (!crew) crew = std::make_unique<Crew>();
  return *crew;
}

Crew::~Crew() {
  {
    const std::lock_guard<std::mutex> alone(one_);
    over_ = true;
  }
  called_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::begin(int others) {
  try {
    while (static_cast<int>(threads_.size()) < others)
      threads_.emplace_back([this] { wait_for_work(); });
  } catch (const std::system_error&) {
    // The system gives no more: those that are there do it all.
  }
}

void Crew::wait_for_work() {
  std::unique_lock<std::mutex> alone(one_);
  while (!over_) {
    if (wanted_ == 0) {
      alone.unlock();
      look_for([&] { return wanted_ > 0; });
      alone.lock();
    }
    called_.wait(alone, [&] { return wanted_ > 0 || over_; });
    if (wanted_ == 0) continue;
    --wanted_;
    ++working_;
    const std::function<void()>& work = *work_;
    alone.unlock();
    work();
    alone.lock();
    if (--working_ == 0) ended_.notify_one();
  }
}

void Crew::run(int others, const std::function<void()>& work) {
  if (others <= 0 || work_ != nullptr) return work();
  begin(others);
  {
    const std::lock_guard<std::mutex> alone(one_);
    work_ = &work;
    wanted_ = others;
  }
  for (int i = 0; i < others; ++i) called_.notify_one();
  work();
  {
    const std::lock_guard<std::mutex> alone(one_);
    wanted_ = 0;
  }
  look_for([&] { return working_ == 0; });
  std::unique_lock<std::mutex> alone(one_);
  ended_.wait(alone, [&] { return working_ == 0; });
  work_ = nullptr;
}

}  // namespace vasorod
