// What the mains of the programs share.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace vasorod {

/// Runs a program with its heap and streams set up; returns its exit code. What it throws is said
/// in one sentence and ends the process at once.
int as_program(const std::string& name, const std::function<int()>& run);

/// Parses the command line. The exit code where that ends the program: 0 after --help and
/// --version, 2 after wrong usage, which is said in one sentence.
std::optional<int> parsed(CLI::App& app, const std::string& name, int argc, char** argv);

}  // namespace vasorod
