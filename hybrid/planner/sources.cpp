#include "planner/sources.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "result/read_json.h"

namespace vasorod::planner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_sources = 1000;

bool is_scene_name(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

// Whether a file looks like a scene; it is read whole only when it is opened.
bool has_vessels(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  for (int k = 0; k < 10000 && std::getline(stream, line); ++k)
    if (line.rfind("vessels:", 0) == 0) return true;
  return false;
}

bool is_exploration(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "options.csv", error) &&
         fs::is_directory(folder / "options", error);
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(entry->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

class Finder {
 public:
  explicit Finder(std::vector<Source> known = {}) : sources_(std::move(known)) {}

  void add(const fs::path& path, Source::Kind kind, const std::string& group = "") {
    const fs::path whole = fs::absolute(path).lexically_normal();
    const bool known = std::any_of(sources_.begin(), sources_.end(),
                                   [&](const Source& one) { return one.path == whole; });
    if (known || sources_.size() >= most_sources) return;
    sources_.push_back(
        {"s" + std::to_string(sources_.size() + 1), kind,
         kind == Source::Kind::scene ? whole.stem().string() : whole.filename().string(), whole,
         group});
  }

  // False: it is neither a result nor an exploration.
  bool add_folder(const fs::path& given) {
    fs::path folder = fs::absolute(given).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    if (holds_our_result(folder)) {
      add(folder, Source::Kind::result);
      return true;
    }
    if (!is_exploration(folder)) return false;
    for (const fs::path& option : entries_of(folder / "options"))
      if (holds_our_result(option)) add(option, Source::Kind::result, folder.filename().string());
    return true;
  }

  void add_beside(const fs::path& folder) {
    std::error_code error;
    for (const fs::path& entry : entries_of(folder)) {
      if (fs::is_directory(entry, error))
        add_folder(entry);
      else if (is_scene_name(entry) && fs::is_regular_file(entry, error) && has_vessels(entry))
        add(entry, Source::Kind::scene);
    }
  }

  std::vector<Source> sources_;
};

}  // namespace

std::vector<Source> find_sources(const std::vector<fs::path>& named, const fs::path& working) {
  Finder finder;
  for (const fs::path& path : named) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      if (!finder.add_folder(path))
        throw InputError(one_line(path.string()) +
                         ": found a folder without result.json and without options.csv, expected "
                         "a result folder or one of vasorod explore");
    } else if (fs::is_regular_file(path, error)) {
      finder.add(path, Source::Kind::scene);
    } else {
      throw InputError(one_line(path.string()) +
                       ": there is no such file, expected a scene file or a result folder");
    }
  }
  finder.add_beside(folder_of(finder.sources_, working));
  return finder.sources_;
}

void add_new(const fs::path& folder, std::vector<Source>& sources) {
  Finder finder(std::move(sources));
  finder.add_beside(folder);
  sources = std::move(finder.sources_);
}

fs::path folder_of(const std::vector<Source>& sources, const fs::path& working) {
  for (const Source& source : sources)
    if (source.kind == Source::Kind::scene) return source.path.parent_path();
  return sources.empty() ? fs::absolute(working).lexically_normal()
                         : sources.front().path.parent_path();
}

}  // namespace vasorod::planner
