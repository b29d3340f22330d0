#include "explore/apart.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <iostream>
#include <new>
#include <optional>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <vasorod/error.h>

#include "numerics/threads.h"

namespace vasorod {
namespace {

constexpr int between_looks = 100;                   // ms
constexpr std::chrono::milliseconds patience(2000);  // between SIGTERM and SIGKILL

// First byte of an answer.
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

// False: nobody reads. No signal says so.
bool send_all(int to, const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = send(to, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

// False: there is no more to come.
bool receive(int from, int& number) {
  std::array<char, sizeof(int)> bytes{};
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t got = recv(from, bytes.data() + at, bytes.size() - at, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += static_cast<std::size_t>(got);
  }
  std::memcpy(&number, bytes.data(), bytes.size());
  return true;
}

// In a process: asks for the number of a job and answers with the length of its answer and the
// answer, until no number comes or a job fails: what a failed one leaves behind, another does not
// meet.
int answer_all(int socket, const std::function<std::string(int)>& job) {
  for (int k = 0; receive(socket, k);) {
    const std::string answer = work(job, k);
    const std::size_t length = answer.size();
    if (!send_all(socket, &length, sizeof length) || !send_all(socket, answer.data(), length))
      return 1;
    if (answer.front() != answered) break;
  }
  return 0;
}

struct Child {
  pid_t process = 0;
  int socket = -1;
  int job = -1;      // -1: idle
  std::string said;  // since it was given the job

  // The answer, once it is all there.
  std::optional<std::string> answer() const {
    std::size_t length = 0;
    if (said.size() < sizeof length) return {};
    std::memcpy(&length, said.data(), sizeof length);
    if (said.size() < sizeof length + length) return {};
    return said.substr(sizeof length);
  }
};

ApartEnding ending_of(const std::string& answer) {
  ApartEnding ending;
  if (answer.front() == answered)
    ending.answer = answer.substr(1);
  else if (answer.front() == refused_by_file_system)
    ending.file_error = answer.substr(1);
  else
    ending.failure = answer.substr(1);
  return ending;
}

ApartEnding ending_without_answer(int status) {
  ApartEnding ending;
  if (WIFSIGNALED(status))
    ending.failure = "its process was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                     strsignal(WTERMSIG(status)) + ")" +  // NOLINT(concurrency-mt-unsafe)
                     (WTERMSIG(status) == SIGKILL ? ", as where the memory does not suffice" : "");
  else
    ending.failure = "its process ended with exit code " + std::to_string(WEXITSTATUS(status)) +
                     " and no answer";
  return ending;
}

// A number that this process and those that it forks see.
class SharedNumber {
 public:
  SharedNumber() {
    void* memory =
        mmap(nullptr, sizeof *number_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    number_ = new (memory) std::atomic<int>(1);
  }
  ~SharedNumber() { munmap(number_, sizeof *number_); }
  SharedNumber(const SharedNumber&) = delete;
  SharedNumber& operator=(const SharedNumber&) = delete;

  std::atomic<int>* get() const { return number_; }

 private:
  static_assert(std::atomic<int>::is_always_lock_free);
  std::atomic<int>* number_;
};

class Children {
 public:
  Children(const std::function<std::string(int)>& job, const ApartOptions& options)
      : job_(job), options_(options) {}
  ~Children() { end_all(); }
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  int working() const {
    return static_cast<int>(std::count_if(children_.begin(), children_.end(),
                                          [](const Child& child) { return child.job >= 0; }));
  }

  void start(int k) {
    auto idle = std::find_if(children_.begin(), children_.end(),
                             [](const Child& child) { return child.job < 0; });
    if (idle == children_.end()) {
      children_.push_back(fork_one());
      idle = children_.end() - 1;
    }
    idle->job = k;
    idle->said.clear();
    send_all(idle->socket, &k, sizeof k);  // wait() finds one that is not there any more
  }

  // Gives those that work the threads of all.
  void share_threads(int working) { *threads_each_.get() = options_.at_once / working; }

  // Waits until one has something to say, at most for `between_looks`, and returns those that have
  // ended their jobs.
  std::vector<std::pair<int, ApartEnding>> wait() {
    std::vector<pollfd> sockets;
    for (const Child& child : children_) sockets.push_back({child.socket, POLLIN, 0});
    std::vector<std::pair<int, ApartEnding>> ended;
    if (poll(sockets.data(), sockets.size(), between_looks) <= 0) return ended;
    for (std::size_t i = sockets.size(); i-- > 0;) {
      if (sockets[i].revents == 0) continue;
      Child& child = children_[i];
      std::array<char, 65536> block{};
      const ssize_t got = recv(child.socket, block.data(), block.size(), 0);
      if (got < 0 && errno == EINTR) continue;
      if (got > 0) {
        child.said.append(block.data(), static_cast<std::size_t>(got));
        const std::optional<std::string> answer = child.answer();
        if (!answer) continue;
        ended.emplace_back(child.job, ending_of(*answer));
        child.job = -1;
        if (ended.back().second.answer) continue;
      }
      const int job = child.job, status = leave(i);
      if (job >= 0) ended.emplace_back(job, ending_without_answer(status));
    }
    return ended;
  }

  // Ends those that have no job.
  void end_idle() {
    for (std::size_t i = children_.size(); i-- > 0;)
      if (children_[i].job < 0) leave(i);
  }

 private:
  Child fork_one() const {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
      throw FileError(std::string("no socket can be made: ") + std::strerror(errno));
    std::cout.flush();
    std::cerr.flush();
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process == 0) {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (options_.begin) options_.begin();
      if (getppid() != parent) _exit(1);  // it ended before it was asked to say so
      close(ends[0]);
      follow_threads(threads_each_.get());
      for (const Child& sibling : children_) close(sibling.socket);
      // Not exit(): it would run what the parent's ending runs.
      _exit(answer_all(ends[1], job_));
    }
    close(ends[1]);
    if (process < 0) {
      close(ends[0]);
      throw FileError(std::string("no process can be started: ") + std::strerror(errno));
    }
    return {process, ends[0], -1, {}};
  }

  // Closes the socket of a child that has ended or waits for a job, which it takes as its end.
  // Returns how it ended.
  int leave(std::size_t i) {
    close(children_[i].socket);
    int status = 0;
    while (waitpid(children_[i].process, &status, 0) < 0 && errno == EINTR) {
    }
    children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(i));
    return status;
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
      close(child.socket);
    }
    children_.clear();
  }

  const std::function<std::string(int)>& job_;
  const ApartOptions& options_;
  SharedNumber threads_each_;
  std::vector<Child> children_;
};

}  // namespace

bool run_apart(int count, const std::function<std::string(int)>& job,
               const std::function<void(int, const ApartEnding&)>& take,
               const ApartOptions& options) {
  Children children(job, options);
  int next = 0;
  while (next < count || children.working() > 0) {
    if (options.stop && options.stop()) return false;
    children.share_threads(std::min(options.at_once, children.working() + count - next));
    while (next < count && children.working() < options.at_once) children.start(next++);
    if (next == count) children.end_idle();  // its memory is another's
    for (const auto& [k, ending] : children.wait()) take(k, ending);
  }
  return true;
}

}  // namespace vasorod
