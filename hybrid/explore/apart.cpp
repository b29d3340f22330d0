#include "explore/apart.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <iostream>
#include <new>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <vasorod/error.h>

namespace vasorod {
namespace {

constexpr int between_looks = 100;                   // ms
constexpr std::chrono::milliseconds patience(2000);  // between SIGTERM and SIGKILL

// First byte of what a process sends.
constexpr char answered = 'a', refused_by_file_system = 'f', failed = 'x';

std::string work(const std::function<std::string(int)>& job, int k) {
  try {
    return answered + job(k);
  } catch (const FileError& error) {
    return refused_by_file_system + std::string(error.what());
  } catch (const std::bad_alloc&) {
    return failed + std::string("found no memory left");
  } catch (const std::exception& error) {
    return failed + std::string(error.what());
  }
}

bool write_all(int to, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t written = write(to, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += static_cast<std::size_t>(written);
  }
  return true;
}

struct Child {
  pid_t process = 0;
  int from = -1;  // the pipe's end to read from
  int job = 0;
  std::string said;
};

ApartEnding ending_of(const Child& child, int status) {
  ApartEnding ending;
  const bool whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !child.said.empty();
  if (whole && child.said.front() == answered)
    ending.answer = child.said.substr(1);
  else if (whole && child.said.front() == refused_by_file_system)
    ending.file_error = child.said.substr(1);
  else if (whole)
    ending.failure = child.said.substr(1);
  else if (WIFSIGNALED(status))
    ending.failure = "its process was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                     strsignal(WTERMSIG(status)) + ")" +  // NOLINT(concurrency-mt-unsafe)
                     (WTERMSIG(status) == SIGKILL ? ", as where the memory does not suffice" : "");
  else
    ending.failure = "its process ended with exit code " + std::to_string(WEXITSTATUS(status)) +
                     " and no answer";
  return ending;
}

class Children {
 public:
  Children(const std::function<std::string(int)>& job, const ApartOptions& options)
      : job_(job), options_(options) {}
  ~Children() { end_all(); }
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  std::size_t running() const { return children_.size(); }

  void start(int k) {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0)
      throw FileError(std::string("no pipe can be made: ") + std::strerror(errno));
    std::cout.flush();
    std::cerr.flush();
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process == 0) {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (options_.begin) options_.begin();
      if (getppid() != parent) _exit(1);  // it ended before it was asked to say so
      close(pipe_ends[0]);
      for (const Child& sibling : children_) close(sibling.from);
      // Not exit(): it would run what the parent's ending runs.
      _exit(write_all(pipe_ends[1], work(job_, k)) ? 0 : 1);
    }
    close(pipe_ends[1]);
    if (process < 0) {
      close(pipe_ends[0]);
      throw FileError(std::string("no process can be started: ") + std::strerror(errno));
    }
    children_.push_back({process, pipe_ends[0], k, {}});
  }

  // Waits until one ends, at most for `between_looks`, and returns those that have.
  std::vector<std::pair<int, ApartEnding>> wait() {
    std::vector<pollfd> ends;
    for (const Child& child : children_) ends.push_back({child.from, POLLIN, 0});
    std::vector<std::pair<int, ApartEnding>> ended;
    if (poll(ends.data(), ends.size(), between_looks) <= 0) return ended;
    for (std::size_t i = ends.size(); i-- > 0;) {
      if (ends[i].revents == 0) continue;
      std::array<char, 65536> block{};
      const ssize_t got = read(ends[i].fd, block.data(), block.size());
      if (got < 0 && errno == EINTR) continue;
      if (got > 0) {
        children_[i].said.append(block.data(), static_cast<std::size_t>(got));
        continue;
      }
      int status = 0;
      reap(children_[i].process, status);
      close(children_[i].from);
      ended.emplace_back(children_[i].job, ending_of(children_[i], status));
      children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return ended;
  }

  void end_all() {
    for (const Child& child : children_) kill(child.process, SIGTERM);
    const auto last = std::chrono::steady_clock::now() + patience;
    for (const Child& child : children_) {
      int status = 0;
      while (waitpid(child.process, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > last) kill(child.process, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
      close(child.from);
    }
    children_.clear();
  }

 private:
  static void reap(pid_t process, int& status) {
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
  }

  const std::function<std::string(int)>& job_;
  const ApartOptions& options_;
  std::vector<Child> children_;
};

}  // namespace

bool run_apart(int count, const std::function<std::string(int)>& job,
               const std::function<void(int, const ApartEnding&)>& take,
               const ApartOptions& options) {
  Children children(job, options);
  int next = 0;
  while (next < count || children.running() > 0) {
    if (options.stop && options.stop()) return false;
    while (next < count && children.running() < static_cast<std::size_t>(options.at_once))
      children.start(next++);
    for (const auto& [k, ending] : children.wait()) take(k, ending);
  }
  return true;
}

}  // namespace vasorod
