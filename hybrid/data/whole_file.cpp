#include "data/whole_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

#include <vasorod/error.h>

#include "data/sentence.h"

namespace vasorod {

std::string whole_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  if (!stream.eof())  // not opened, or a read that failed
    throw FileError(one_line(file.string()) + ": cannot be read, expected a readable file");
  return bytes;
}

namespace {

// Writes beside the file's place, then `put` takes it there: false, with errno, where it cannot.
// Returns 0, or the cause for which the file was not written.
template <class Put>
int written(const std::filesystem::path& file, const std::string& bytes, Put&& put) {
  const std::filesystem::path beside =
      file.parent_path() /
      ("." + file.filename().string() + half_written_file + std::to_string(getpid()));
  std::ofstream stream(beside, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream && put(beside.c_str(), file.c_str())) return 0;
  const int cause = errno;
  unlink(beside.c_str());
  return cause;
}

[[noreturn]] void refuse_to_write(const std::filesystem::path& file, int cause) {
  throw FileError(one_line(file.string()) + ": cannot be written: " + std::strerror(cause));
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, const std::string& bytes) {
  const int cause = written(
      file, bytes, [](const char* from, const char* to) { return std::rename(from, to) == 0; });
  if (cause != 0) refuse_to_write(file, cause);
}

bool write_new_file(const std::filesystem::path& file, const std::string& bytes) {
  const int cause = written(file, bytes, [](const char* from, const char* to) {
    if (renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    // A file system without that, as NFS: a second name, then without the first.
    return link(from, to) == 0 && unlink(from) == 0;
  });
  if (cause != 0 && cause != EEXIST) refuse_to_write(file, cause);
  return cause == 0;
}

}  // namespace vasorod
