// The program sends nothing anywhere: it runs under a filter of the kernel (seccomp) that ends it
// with SIGSYS where it asks for a socket or a connection.
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

#include "program/run_program.h"

namespace vasorod::testing {
namespace {

const std::string source = VASOROD_SOURCE_DIR;

bool forbid_sockets() {
  constexpr auto number = static_cast<unsigned>(offsetof(seccomp_data, nr));
  const std::array<sock_filter, 6> rules{{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
                                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_socket, 2, 0),
                                          BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_connect, 1, 0),
                                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
                                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
                                          BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog program{static_cast<unsigned short>(rules.size()),
                           const_cast<sock_filter*>(rules.data())};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

// The exit code of `arguments` without sockets, or minus the signal; 125 where there is no filter.
int without_sockets(const std::vector<std::string>& arguments) {
  const pid_t process = fork();
  if (process == 0) {
    std::vector<char*> words;
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stdout) == nullptr || !forbid_sockets()) _exit(125);
    if (words.size() == 1) _exit(socket(AF_UNIX, SOCK_STREAM, 0) < 0 ? 0 : 1);
    execv(words[0], words.data());
    _exit(126);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Network, NoCommandAsksForASocket) {
  const int filtered = without_sockets({});
  if (filtered == 125) GTEST_SKIP() << "this kernel has no filter of system calls";
  ASSERT_EQ(filtered, -SIGSYS) << "the filter lets a socket through";
  const ScratchFolder scratch;
  const std::string solved = (scratch / "solved").string(), fit = (scratch / "fit").string();
  EXPECT_EQ(
      without_sockets({VASOROD_PROGRAM, "solve", source + "/benchmarks/cases/glenn/infant.yaml",
                       "--fidelity", "skin", "-o", solved}),
      0);
  EXPECT_EQ(
      without_sockets({VASOROD_PROGRAM, "fit", source + "/meshes/infant/aorta.vtp", "-o", fit}), 0);
  EXPECT_EQ(without_sockets({VASOROD_PROGRAM, "compare", solved, solved}), 0);
}

}  // namespace
}  // namespace vasorod::testing
