// A result folder is replaced whole or not at all: written beside its place, then renamed into it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vasorod {

/// Writes into a temporary sibling of `folder`; commit() puts that in its place in one step of the
/// file system. Without commit() (an exception, an interrupt that unwinds) the temporary is removed
/// and the old folder is as it was; a killed process leaves the old folder, and a
/// `.NAME.writing-PROCESS-XXXXXX` beside it, which the next one to write there removes.
///
/// Only a place that is absent, an empty folder, or a folder with our result.json and nothing but
/// files that a result has may be replaced, and never the current folder or one above it; else
/// FileError, one sentence. Parents are made as needed.
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

/// Throws the FileError that FolderReplacement would, before a long computation; creates nothing.
void require_replaceable(const std::filesystem::path& folder);

/// Throws FileError where one of the inputs lies inside `folder`, which is replaced whole.
void require_outside(const std::filesystem::path& folder,
                     const std::vector<std::filesystem::path>& inputs);

/// For a signal handler that ends the process: removes what a FolderReplacement has written so far.
/// False while one is being put in its place: the process may end a moment later, not now.
bool remove_unfinished_folder();

}  // namespace vasorod
