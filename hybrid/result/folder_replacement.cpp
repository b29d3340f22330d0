#include "result/folder_replacement.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <random>
#include <string_view>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "result/read_json.h"

namespace vasorod {

namespace fs = std::filesystem;

namespace {

// Absolute, links resolved, no trailing slash, so that the folder itself is renamed and not a link
// to it.
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

// Whether a result has files of that name.
bool is_ours(const fs::path& file) {
  const std::string name = file.filename().string();
  return name == "result.json" || name == "scene.pvd" || name == "report.html" ||
         name.ends_with(".vtp") || (name.starts_with("picture_") && name.ends_with(".png"));
}

// The first entry of an earlier result that no result contains; empty if there is none.
fs::path foreign(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::file_status status = entry->symlink_status(error);
    if (!error && (!fs::is_regular_file(status) || !is_ours(entry->path()))) return entry->path();
  }
  if (error) throw FileError(folder.string() + ": cannot be read: " + error.message());
  return {};
}

std::size_t longest_name(const fs::path& existing) {
  const long most = pathconf(existing.c_str(), _PC_NAME_MAX);
  return most > 0 ? static_cast<std::size_t>(most) : NAME_MAX;
}

// Finds names and paths that the file system refuses before the folder is created.
void check_names(const fs::path& place, const fs::path& existing) {
  constexpr std::size_t longest_file = 128;  // a vessel's name has at most 100 letters
  const std::size_t most = longest_name(existing);
  for (const fs::path& part : place.lexically_relative(existing))
    if (part.string().size() > most)
      throw FileError("the result folder's name " + in_quotes(part.string()) + " has " +
                      std::to_string(part.string().size()) +
                      " bytes, expected at most the file system's " + std::to_string(most));
  if (place.string().size() + longest_file > PATH_MAX)
    throw FileError("the result folder's path " + in_quotes(place.string()) + " has " +
                    std::to_string(place.string().size()) + " bytes, expected at most " +
                    std::to_string(PATH_MAX - longest_file));
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
    if (const fs::path other = empty ? fs::path() : foreign(place); !other.empty())
      throw FileError(place.string() + ": holds " + in_quotes(other.filename().string()) +
                      ", which is no file of a result, expected a former result and nothing else");
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
  check_names(place, parent);
  if (access(parent.c_str(), W_OK | X_OK) != 0)
    throw FileError(parent.string() + ": cannot be written to: " + std::strerror(errno));
}

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path.string() + ": " + what + ": " + std::strerror(errno));
}

// A result is written to the hidden sibling .NAME.writing-PROCESS-XXXXXX. NAME is shortened if the
// whole would be too long.
std::string staging_start(const fs::path& place) {
  constexpr std::size_t rest = 40;
  return "." + place.filename().string().substr(0, longest_name(place.parent_path()) - rest) +
         ".writing-";
}

// As of mkdtemp(), which says the name only when the folder is there.
std::string random_letters() {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> which(0, letters.size() - 1);
  std::string six(6, ' ');
  for (char& letter : six) letter = letters[which(random)];
  return six;
}

// Whether the process that created the sibling has ended. Without a process in its name, a sibling
// counts as abandoned after a day.
bool is_left_over(const fs::path& sibling, const std::string& start) {
  const std::string rest = sibling.filename().string().substr(start.size());
  const auto dash = rest.find('-');
  if (dash == std::string::npos) {
    std::error_code error;
    const auto written = fs::last_write_time(sibling, error);
    return !error && fs::file_time_type::clock::now() - written > std::chrono::hours(24);
  }
  const std::string process = rest.substr(0, dash);
  if (process.empty() || process.size() > 9 ||
      process.find_first_not_of("0123456789") != std::string::npos)
    return false;
  return kill(std::stoi(process), 0) != 0 && errno == ESRCH;
}

void remove_left_overs(const fs::path& parent, const std::string& start) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().starts_with(start) &&
        fs::is_directory(entry->symlink_status(error)) && is_left_over(entry->path(), start))
      found.push_back(entry->path());
  for (const fs::path& sibling : found) fs::remove_all(sibling, error);
}

// Data of the active replacement for a signal handler, which may use plain data only.
std::array<char, PATH_MAX> unfinished{};
std::atomic<bool> has_unfinished{false}, putting_in_place{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note_unfinished(const fs::path& staging) {
  has_unfinished = false;
  const std::string& name = staging.native();
  if (name.empty() || name.size() >= unfinished.size()) return;
  std::memcpy(unfinished.data(), name.c_str(), name.size() + 1);
  has_unfinished = true;
}

// Removes the files of an open folder with system calls only, because the library's functions that
// list a folder allocate memory.
void remove_files(int folder) {
  constexpr long size_at = 16, name_at = 19;  // in the kernel's linux_dirent64
  alignas(8) std::array<char, 4096> block{};
  for (long got = 0; (got = syscall(SYS_getdents64, folder, block.data(), block.size())) > 0;)
    for (long at = 0; at < got;) {
      std::uint16_t size = 0;
      std::memcpy(&size, block.data() + at + size_at, sizeof size);
      unlinkat(folder, block.data() + at + name_at, 0);
      at += size;
    }
}

}  // namespace

bool remove_unfinished_folder() {
  if (putting_in_place) return false;
  constexpr int tries = 3;  // another thread may be adding a file
  for (int i = 0; has_unfinished && i < tries; ++i) {
    const int folder = open(unfinished.data(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) break;
    remove_files(folder);
    close(folder);
    if (rmdir(unfinished.data()) == 0) break;
  }
  return true;
}

FolderReplacement::FolderReplacement(const fs::path& folder) : folder_(place_of(folder)) {
  check(folder_);
  std::error_code error;
  fs::create_directories(folder_.parent_path(), error);
  if (error)
    throw FileError(folder_.parent_path().string() + ": cannot be made: " + error.message());
  const std::string start = staging_start(folder_);
  remove_left_overs(folder_.parent_path(), start);
  const fs::path staging =
      folder_.parent_path() / (start + std::to_string(getpid()) + "-" + random_letters());
  // Before it is there: a signal that comes while it is made is delivered when it is.
  note_unfinished(staging);
  if (mkdir(staging.c_str(), 0700) != 0) {
    const int cause = errno;
    note_unfinished({});
    errno = cause;
    fail(folder_.parent_path(), "no folder can be made in it");
  }
  staging_ = staging;
  const mode_t mask =
      umask(0);  // it was made for this user alone; a result has the permissions of any new folder
  umask(mask);
  chmod(staging_.c_str(), 0777 & ~mask);
}

FolderReplacement::~FolderReplacement() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
  note_unfinished({});
}

void FolderReplacement::write(const std::string& name, const std::string& bytes) {
  std::ofstream stream(staging_ / name, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) fail(folder_ / name, "cannot be written");
}

void FolderReplacement::commit() {
  check(folder_);  // the place may have changed during the computation
  struct Placing {
    Placing() { putting_in_place = true; }
    ~Placing() { putting_in_place = false; }
  } const placing;
  std::error_code error;
  if (!fs::exists(folder_, error)) {
    if (rename(staging_.c_str(), folder_.c_str()) == 0) {
      staging_.clear();
      note_unfinished({});
      return;
    }
    // Another process put its result there in this moment; ours replaces it.
    if (errno != ENOTEMPTY && errno != EEXIST) fail(folder_, "cannot be put in place");
    check(folder_);
  }
  // One step, so that there is a result at every moment. Afterwards staging_ is the old folder,
  // which the destructor removes.
  if (renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, folder_.c_str(), RENAME_EXCHANGE) == 0)
    return;
  if (errno != EINVAL && errno != ENOSYS) fail(folder_, "cannot be replaced");
  // A file system without exchange: the old folder is moved aside, and moved back if the new one
  // cannot be put in its place.
  const fs::path aside = staging_.string() + "-old";
  if (rename(folder_.c_str(), aside.c_str()) != 0) fail(folder_, "cannot be moved aside");
  if (rename(staging_.c_str(), folder_.c_str()) != 0) {
    const int cause = errno;
    rename(aside.c_str(), folder_.c_str());
    errno = cause;
    fail(folder_, "cannot be put in place");
  }
  staging_ = aside;
  note_unfinished(staging_);
}

void require_replaceable(const fs::path& folder) {
  check(place_of(folder));
}

void require_outside(const fs::path& folder, const std::vector<fs::path>& inputs) {
  const fs::path place = place_of(folder);
  for (const fs::path& input : inputs) {
    if (input.empty()) continue;
    // Both the place of its name and the place of its target: a link is lost with its folder, like
    // a file.
    std::error_code error;
    const fs::path name = fs::absolute(input, error).lexically_normal(),
                   link = fs::weakly_canonical(name.parent_path(), error) / name.filename(),
                   file = fs::weakly_canonical(name, error);
    for (const fs::path& inside : {link, file})
      if (inside != place && holds(place, inside))
        throw FileError(place.string() + ": holds the input " + in_quotes(input.string()) +
                        ", and the result's folder is replaced whole; expected another folder");
  }
}

}  // namespace vasorod
