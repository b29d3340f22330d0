// Replaces a result folder completely or not at all: the new folder is written beside the old one
// and then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vasorod {

/// Writes into a temporary sibling of `folder`; commit() puts it in place in one step of the file
/// system. Without commit() (an exception, or an interrupt that unwinds the stack) the sibling is
/// removed and the old folder is unchanged. A killed process leaves the old folder and the sibling
/// `.NAME.writing-PROCESS-XXXXXX`, which the next replacement of the folder removes.
///
/// The folder may be absent, empty, or an earlier result with its result.json and no foreign files.
/// Anything else is a FileError (one sentence), as are the current folder and folders above it.
/// Missing parents are created.
class FolderReplacement {
 public:
  explicit FolderReplacement(const std::filesystem::path& folder);
  ~FolderReplacement();
  FolderReplacement(const FolderReplacement&) = delete;
  FolderReplacement& operator=(const FolderReplacement&) = delete;

  /// Writes one file, `name` without a folder.
  void write(const std::string& name, const std::string& bytes);
  void commit();

 private:
  std::filesystem::path folder_, staging_;
};

/// Throws the same FileError as FolderReplacement, before a long computation. Creates nothing.
void require_replaceable(const std::filesystem::path& folder);

/// Throws FileError if an input lies inside `folder`, because the whole folder is replaced.
void require_outside(const std::filesystem::path& folder,
                     const std::vector<std::filesystem::path>& inputs);

/// For a signal handler that ends the process: removes the files that a FolderReplacement has
/// written so far. False during the renaming: the process must not end before it is done.
bool remove_unfinished_folder();

}  // namespace vasorod
