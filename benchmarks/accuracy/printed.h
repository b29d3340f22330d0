// What the programs of this folder print: Markdown tables, part by part.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace vasorod::bench {

/// A heading and the head of its table: "| one | two |".
void print_head(const std::string& title, const std::string& columns);

/// Behind the last number of a row.
inline const char* remark(bool settled) {
  return settled ? "" : " (not a certified minimum)";
}

/// A program's main: runs the parts named as arguments, without arguments all of them. Exit code 2
/// where a name is not known.
using Parts = std::vector<std::pair<std::string, void (*)()>>;
int run_parts(const Parts& parts, int count, char** arguments);

}  // namespace vasorod::bench
