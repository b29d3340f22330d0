// The built program beside the test.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace vasorod::testing {

/// A program that runs beside the test, which sends it signals.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments) : process_(fork()) {
    if (process_ != 0) return;
    std::vector<char*> words{const_cast<char*>(VASOROD_PROGRAM)};
    for (const std::string& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stdout) != nullptr) execv(words[0], words.data());
    _exit(127);
  }
  ~RunningProgram() {
    if (ended_) return;
    kill(process_, SIGKILL);
    wait();
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits until the program answers to the signal itself, sends it, waits until it was taken.
  void send(int signal) {
    const std::uint64_t bit = std::uint64_t{1} << (signal - 1);
    wait_until([&] { return (mask("SigCgt:") & bit) != 0; });
    kill(process_, signal);
    wait_until([&] { return ((mask("SigPnd:") | mask("ShdPnd:")) & bit) == 0; });
  }
  /// Ends the program as it stands, whatever it does.
  int kill_now() {
    kill(process_, SIGKILL);
    return wait();
  }
  /// The exit code, or minus the signal that ended it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  std::uint64_t mask(const std::string& key) const {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind(key, 0) == 0) return std::stoull(line.substr(key.size()), nullptr, 16);
    return 0;
  }
  template <class Question>
  static void wait_until(Question&& question) {
    for (int i = 0; i < 3000 && !question(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  pid_t process_;
  bool ended_ = false;
};

}  // namespace vasorod::testing
