#include "data/whole_file.h"

#include <array>
#include <fstream>

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

}  // namespace vasorod
