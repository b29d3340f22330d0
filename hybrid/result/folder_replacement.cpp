#include "result/folder_replacement.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include <vasorod/error.h>

#include "result/read_json.h"

namespace vasorod {

namespace fs = std::filesystem;

namespace {

// Absolute, links resolved, no trailing slash: what is renamed is the folder itself, not a link to
// it.
fs::path place_of(const fs::path& folder) {
  if (folder.empty()) throw FileError("the result folder's name is empty, expected a path");
  std::error_code error;
  fs::path place = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) throw FileError(folder.string() + ": " + error.message());
  return place.has_filename() ? place : place.parent_path();
}

bool holds(const fs::path& outer, const fs::path& inner) {
  const fs::path relative = inner.lexically_relative(outer);
  return !relative.empty() && *relative.begin() != "..";
}

fs::path nearest_existing(fs::path path) {
  std::error_code error;
  while (!fs::exists(path, error) && path.has_relative_path()) path = path.parent_path();
  return path;
}

void check(const fs::path& place) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (fs::exists(status)) {
    if (!fs::is_directory(status))
      throw FileError(place.string() + ": is a file, expected a folder or nothing");
    const bool empty = fs::is_empty(place, error);
    if (error) throw FileError(place.string() + ": cannot be read: " + error.message());
    if (!empty && !holds_our_result(place))
      throw FileError(place.string() +
                      ": holds files but no result.json of ours, expected an empty folder, a "
                      "former result or nothing");
    if (holds(place, fs::current_path(error)))
      throw FileError(
          place.string() +
          ": is or holds the current folder, which cannot be replaced; expected another");
  }
  if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(place, error)))
    throw FileError(place.string() +
                    ": is a link that leads nowhere, expected a folder or nothing");
  const fs::path parent = nearest_existing(place.parent_path());
  if (!fs::is_directory(parent, error))
    throw FileError(parent.string() + ": is a file, expected a folder");
  if (access(parent.c_str(), W_OK | X_OK) != 0)
    throw FileError(parent.string() + ": cannot be written to: " + std::strerror(errno));
}

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

FolderReplacement::FolderReplacement(const fs::path& folder) : folder_(place_of(folder)) {
  check(folder_);
  std::error_code error;
  fs::create_directories(folder_.parent_path(), error);
  if (error)
    throw FileError(folder_.parent_path().string() + ": cannot be made: " + error.message());
  std::string name =
      (folder_.parent_path() / ("." + folder_.filename().string() + ".writing-XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) fail(folder_.parent_path(), "no folder can be made in it");
  staging_ = name;
  const mode_t mask =
      umask(0);  // mkdtemp makes private folders; a result has the permissions of any new folder
  umask(mask);
  chmod(staging_.c_str(), 0777 & ~mask);
}

FolderReplacement::~FolderReplacement() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
}

void FolderReplacement::write(const std::string& name, const std::string& bytes) {
  std::ofstream stream(staging_ / name, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) fail(folder_ / name, "cannot be written");
}

void FolderReplacement::commit() {
  check(folder_);  // whatever came to be there while we computed
  std::error_code error;
  if (!fs::exists(folder_, error)) {
    if (rename(staging_.c_str(), folder_.c_str()) != 0) fail(folder_, "cannot be put in place");
    staging_.clear();
    return;
  }
  // One step: at no moment is there no result. Then staging_ is the old folder, which the
  // destructor removes.
  if (renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) == 0)
    return;
  if (errno != EINVAL && errno != ENOSYS) fail(folder_, "cannot be replaced");
  // A file system without exchange: the old folder steps aside, and comes back if the new one
  // cannot take its place.
  const fs::path aside = staging_.string() + "-old";
  if (rename(folder_.c_str(), aside.c_str()) != 0) fail(folder_, "cannot be moved aside");
  if (rename(staging_.c_str(), folder_.c_str()) != 0) {
    const int cause = errno;
    rename(aside.c_str(), folder_.c_str());
    errno = cause;
    fail(folder_, "cannot be put in place");
  }
  staging_ = aside;
}

void require_replaceable(const fs::path& folder) {
  check(place_of(folder));
}

}  // namespace vasorod
