#include "app/program.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <unistd.h>

#include "app/ending.h"
#include "app/heap.h"
#include "app/streams.h"

namespace vasorod {

int as_program(const std::string& name, const std::function<int()>& run) {
  keep_freed_memory();
  keep_streams_apart();
  try {
    return run();
  } catch (...) {
    const int exit_code = say_failure(name);
    std::cout.flush();
    // Not exit(): it waits for OpenBLAS's threads, which never end if they find no memory.
    _exit(exit_code);
  }
}

std::optional<int> parsed(CLI::App& app, const std::string& name, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::cerr << name << ": " << error.what() << " (" << name << " --help says what there is)\n";
    return 2;
  }
}

}  // namespace vasorod
