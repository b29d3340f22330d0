// What the page can open: scenes and results, found on the command line and beside the first scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vasorod::planner {

struct Source {
  std::string id;  ///< "s1", "s2"...
  enum class Kind { scene, result } kind = Kind::scene;
  std::string name;            ///< for readers
  std::filesystem::path path;  ///< of the scene's file or of the result's folder
  std::string group;           ///< name of the exploration it belongs to; empty: none
};

/// What the command line named (scene files, result folders, folders of explorations), then scenes
/// and results in the folder of the first, or in `working` where it named nothing. Throws
/// InputError for a path that is neither.
std::vector<Source> find_sources(const std::vector<std::filesystem::path>& named,
                                 const std::filesystem::path& working);

/// Adds what has come into a folder since; the ids of the others stay.
void add_new(const std::filesystem::path& folder, std::vector<Source>& sources);

/// Where scenes and results are written beside: the folder of the first source, or `working`.
std::filesystem::path folder_of(const std::vector<Source>& sources,
                                const std::filesystem::path& working);

}  // namespace vasorod::planner
