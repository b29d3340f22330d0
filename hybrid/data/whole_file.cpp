#include "data/whole_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
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

void write_whole_file(const std::filesystem::path& file, const std::string& bytes) {
  const std::filesystem::path beside =
      file.parent_path() /
      ("." + file.filename().string() + half_written_file + std::to_string(getpid()));
  std::ofstream stream(beside, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream && std::rename(beside.c_str(), file.c_str()) == 0) return;
  const int cause = errno;
  unlink(beside.c_str());
  throw FileError(one_line(file.string()) + ": cannot be written: " + std::strerror(cause));
}

}  // namespace vasorod
