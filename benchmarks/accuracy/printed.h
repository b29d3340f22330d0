// Output of the programs of this folder: Markdown tables, one per part.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vasorod::bench {

/// Prints a heading and the table's first line: "| one | two |".
void print_head(const std::string& title, const std::string& columns);

/// Text after the last number of a row.
inline const char* remark(bool settled) {
  return settled ? "" : " (not a certified minimum)";
}

/// A program's main: runs the parts named as arguments; without arguments, all of them. Exit code 2
/// for an unknown name.
using Parts = std::vector<std::pair<std::string, void (*)()>>;
int run_parts(const Parts& parts, int count, char** arguments);

}  // namespace vasorod::bench
