#include "explore/explore_folder.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/file.h>
#include <unistd.h>
#include <vector>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "data/whole_file.h"

namespace vasorod {

namespace fs = std::filesystem;

namespace {

constexpr const char* lock_name = "explore.lock";

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path.string() + ": " + what + ": " + std::strerror(errno));
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be made: " + error.message());
}

void require_ours(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status))
    throw FileError(folder.string() + ": is a file, expected a folder or nothing");
  const bool empty = fs::is_empty(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be read: " + error.message());
  if (!empty && !fs::is_regular_file(fs::symlink_status(folder / lock_name, error)))
    throw FileError(folder.string() +
                    ": holds files but no exploration of ours, expected an empty folder, that of "
                    "an earlier vasorod explore, or nothing");
}

void remove_left_overs(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().find(half_written_file) != std::string::npos)
      found.push_back(entry->path());
  for (const fs::path& path : found) fs::remove_all(path, error);
}

}  // namespace

ExploreFolder::ExploreFolder(const fs::path& folder, Sharing sharing) {
  if (folder.empty()) throw FileError("the folder's name is empty, expected a path");
  std::error_code error;
  folder_ = fs::absolute(folder, error).lexically_normal();
  require_ours(folder_);
  make_folder(folder_);
  const fs::path lock = folder_ / lock_name;
  lock_ = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (lock_ < 0) fail(lock, "cannot be written");
  const bool alone = sharing == Sharing::alone;
  if (flock(lock_, (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
    const int cause = errno;
    std::ifstream stream(lock);
    std::string process;
    std::getline(stream, process);
    close(lock_);
    lock_ = -1;
    errno = cause;
    if (cause != EWOULDBLOCK) fail(lock, "cannot be locked");
    throw FileError(folder_.string() + ": another vasorod explore" +
                    (process.empty() ? "" : " (" + one_line(process) + ")") +
                    " is at work in it, expected to wait until it ends, or another folder");
  }
  for (const char* inside : {"finished", "options"}) make_folder(folder_ / inside);
  if (!alone) return;
  const std::string process = "process " + std::to_string(getpid()) + "\n";
  if (ftruncate(lock_, 0) != 0 ||
      write(lock_, process.data(), process.size()) != static_cast<ssize_t>(process.size())) {
    const int cause = errno;
    close(lock_);
    lock_ = -1;
    errno = cause;
    fail(lock, "cannot be written");
  }
  for (const char* inside : {"finished", "options"}) remove_left_overs(folder_ / inside);
  remove_left_overs(folder_);
}

ExploreFolder::~ExploreFolder() {
  if (lock_ >= 0) close(lock_);
}

void ExploreFolder::leave_lock() const {
  close(lock_);
}

fs::path ExploreFolder::file_of(const Row& row) const {
  return folder_ / "finished" / (row.name() + ".json");
}

bool ExploreFolder::find(Row& row, bool keeps) const {
  std::ifstream stream(file_of(row), std::ios::binary);
  if (!stream) return false;
  try {
    Row found = row;
    read_row({std::istreambuf_iterator<char>(stream), {}}, found);
    std::error_code error;
    const bool held = fs::is_regular_file(folder_ / kept(row) / "result.json", error);
    if (keeps && found.ending == Ending::solved && !held) return false;
    if (!keeps) {
      found.folder.clear();
      found.look.reset();
    }
    row = found;
    return true;
  } catch (const InputError&) {
    return false;  // a damaged file: the option is solved again
  }
}

void ExploreFolder::finish(const Row& row) const {
  write_whole_file(file_of(row), row_json(row));
}

}  // namespace vasorod
