#include "accuracy/printed.h"

#include <algorithm>
#include <cstdio>

namespace vasorod::bench {

void print_head(const std::string& title, const std::string& columns) {
  std::printf("\n### %s\n\n%s\n", title.c_str(), columns.c_str());
  for (auto bars = std::count(columns.begin(), columns.end(), '|'); bars > 1; --bars)
    std::printf("| --- ");
  std::printf("|\n");
}

int run_parts(const Parts& parts, int count, char** arguments) {
  const std::vector<std::string> asked(arguments + 1, arguments + count);
  for (const std::string& name : asked)
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const auto& part) { return part.first == name; })) {
      std::fprintf(stderr, "%s: no part is called %s\n", arguments[0], name.c_str());
      return 2;
    }
  for (const auto& [name, part] : parts)
    if (asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end()) part();
  return 0;
}

}  // namespace vasorod::bench
