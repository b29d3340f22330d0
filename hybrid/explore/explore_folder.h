// The folder of an exploration: locked while one works in it, and what it holds of finished
// options.
#pragma once

#include <filesystem>
#include <string>

#include "explore/row.h"

namespace vasorod {

/// DIR/explore.lock, DIR/options.csv, DIR/index.html, DIR/finished/NAME.json of each finished
/// option, DIR/options/NAME of each kept one.
class ExploreFolder {
 public:
  /// Who else may work in the folder.
  enum class Sharing {
    alone,    ///< nobody
    together  ///< others that share it, each on options of its own
  };

  /// Takes the folder, which must be absent, empty, or that of an earlier exploration; makes it,
  /// and, alone, removes what a killed exploration left half written. Throws FileError, also where
  /// another exploration is at work in it. The lock ends with this process, however that ends.
  explicit ExploreFolder(const std::filesystem::path& folder, Sharing sharing = Sharing::alone);
  ~ExploreFolder();
  ExploreFolder(const ExploreFolder&) = delete;
  ExploreFolder& operator=(const ExploreFolder&) = delete;

  /// In a forked process: gives up its share of the lock, which its parent keeps.
  void leave_lock() const;

  const std::filesystem::path& path() const { return folder_; }
  /// "options/NAME", below path().
  static std::string kept(const Row& row) { return "options/" + row.name(); }
  /// Fills a row by its name; false: it is not finished, or its file or folder was lost. `keeps`:
  /// its result folder belongs to it; without, the row names none.
  bool find(Row& row, bool keeps) const;
  void finish(const Row& row) const;

 private:
  std::filesystem::path file_of(const Row& row) const;

  std::filesystem::path folder_;
  int lock_ = -1;
};

}  // namespace vasorod
