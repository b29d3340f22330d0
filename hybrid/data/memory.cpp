#include "data/memory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace vasorod {
namespace {

namespace fs = std::filesystem;

void lower(std::optional<double>& limit, double bytes) {
  limit = std::min(limit.value_or(bytes), bytes);
}

// A file with one number of bytes; "max" or no file: no limit.
void lower_to_number_in(const fs::path& file, std::optional<double>& limit) {
  std::ifstream stream(file);
  if (double bytes = 0; stream >> bytes && bytes > 0) lower(limit, bytes);
}

// The limits of the groups that /proc/self/cgroup names ("ID:CONTROLLERS:PATH") and of those above
// them. Version 2 has no controllers there, version 1 a hierarchy for the memory alone.
void lower_to_groups(std::optional<double>& limit) {
  std::ifstream stream("/proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    std::istringstream parts(line);
    std::string id, controllers, path;
    if (!std::getline(parts, id, ':') || !std::getline(parts, controllers, ':') ||
        !std::getline(parts, path))
      continue;
    const bool version_2 = controllers.empty();
    if (!version_2 && controllers != "memory") continue;
    const fs::path root = version_2 ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    const char* file = version_2 ? "memory.max" : "memory.limit_in_bytes";
    lower_to_number_in(root / file, limit);
    fs::path group = root;
    for (const fs::path& part : fs::path(path).relative_path())
      lower_to_number_in((group /= part) / file, limit);
  }
}

}  // namespace

std::optional<double> memory_limit() {
  std::optional<double> limit;
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages > 0 && page > 0) lower(limit, static_cast<double>(pages) * static_cast<double>(page));
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    lower(limit, static_cast<double>(space.rlim_cur));
  lower_to_groups(limit);
  return limit;
}

}  // namespace vasorod
