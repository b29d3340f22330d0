#include "surface_file/space.h"

#include <fstream>

namespace vasorod {

std::string known_space(const std::string& text) {
  return text == "LPS" || text == "RAS" ? text : std::string();
}

std::string space_in_head(const std::filesystem::path& file) {
  // The comment stands in the first 80 bytes of STL and among the first lines of PLY and OBJ.
  std::string head(1024, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  const std::string key = "SPACE=";
  const std::size_t at = head.find(key);
  return at == std::string::npos ? std::string() : known_space(head.substr(at + key.size(), 3));
}

}  // namespace vasorod
