// The program `vasorod-plan`: options, signals and exit codes.
#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <vasorod/error.h>
#include <vasorod/version.h>

#include "app/kernels.h"
#include "app/program.h"
#include "numerics/blas.h"
#include "planner/http_server.h"
#include "planner/open_browser.h"
#include "planner/save.h"
#include "result/folder_replacement.h"

namespace {

using namespace vasorod;

std::array<int, 2> ends_of_pipe{-1, -1};

// May run in any thread: OpenBLAS has some of its own.
extern "C" void tell_main(int signal) {
  const char byte = static_cast<char>(signal);
  [[maybe_unused]] const ssize_t written = write(ends_of_pipe[1], &byte, 1);
}

// From now on the first of the signals that end a program is told to wait_for_signal().
void catch_signals() {
  if (pipe2(ends_of_pipe.data(), O_CLOEXEC) != 0)
    throw FileError("found no free file descriptors, expected two");
  struct sigaction action {};
  action.sa_handler = tell_main;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (signal == SIGHUP && before.sa_handler == SIG_IGN) continue;  // nohup
    sigaction(signal, &action, nullptr);
  }
}

void wait_for_signal() {
  char byte = 0;
  while (read(ends_of_pipe[0], &byte, 1) < 1) {
  }
}

// Ends the process at once: what is being solved is of no interest any more, what is being written
// is finished or taken away.
[[noreturn]] void close_now() {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (!planner::writing().try_lock() && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  while (!remove_unfinished_folder() && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::cout << "closed" << std::endl;
  _exit(0);
}

int run(int argc, char** argv) {
  CLI::App app{
      "Vasorod: plans a re-joining of vessels in the browser; the prediction follows the hand.\n"
      "Serves a page to this machine alone, at an address that only this terminal shows.\n"
      "Research software, not for clinical use."};
  app.set_version_flag("--version", "vasorod-plan " + version());
  std::vector<std::filesystem::path> named;
  int port = 0;
  bool open = false;
  app.add_option("sources", named,
                 "Scene files, result folders, folders of vasorod explore; by default those of "
                 "the working folder");
  app.add_option("--port", port, "Port of 127.0.0.1; by default a free one")
      ->check(CLI::Range(1, 65535));
  app.add_flag("--open", open, "Open the page in the browser (xdg-open)");
  if (const auto ended = parsed(app, "vasorod-plan", argc, argv)) return *ended;

  catch_signals();
  planner::Session session(named, std::filesystem::current_path());
  planner::HttpServer server(session);
  server.bind(port);
  std::thread([&server] { server.run(); }).detach();
  std::cout << server.url() << std::endl;
  if (!std::cout) throw FileError("standard output: cannot be written");
  if (open) planner::open_browser(server.url());
  wait_for_signal();
  close_now();
}

}  // namespace

int main(int argc, char** argv) {
  vasorod::choose_blas_kernels(argv);
  vasorod::end_blas_threads();
  return vasorod::as_program("vasorod-plan", [&] { return run(argc, argv); });
}
