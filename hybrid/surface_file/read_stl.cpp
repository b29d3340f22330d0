#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "data/whole_file.h"
#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

// A binary file: 80 bytes of comment, the number of facets, and 50 bytes for each.
constexpr std::size_t head_size = 84, facet_size = 50;

template <class Number>
Number little_endian(const char* bytes) {
  std::array<char, sizeof(Number)> one;
  std::memcpy(one.data(), bytes, sizeof(Number));
  if (std::endian::native == std::endian::big) std::reverse(one.begin(), one.end());
  return std::bit_cast<Number>(one);
}

std::string lower(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

SurfaceFile of_corners(const std::vector<Vec3>& corners) {
  SurfaceFile out;
  out.points.resize(std::ssize(corners), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.points.row(static_cast<Eigen::Index>(i)) = corners[i].transpose();
  for (int i = 0; i + 2 < static_cast<int>(corners.size()); i += 3)
    out.polygons.push_back({i, i + 1, i + 2});
  return out;
}

SurfaceFile read_binary(const std::string& text, std::size_t facets) {
  std::vector<Vec3> corners;
  corners.reserve(3 * facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const char* at = text.data() + head_size + facet * facet_size + 12;  // behind the normal
    for (int corner = 0; corner < 3; ++corner, at += 12)
      corners.emplace_back(little_endian<float>(at), little_endian<float>(at + 4),
                           little_endian<float>(at + 8));
  }
  return of_corners(corners);
}

class Ascii {
 public:
  Ascii(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  SurfaceFile read() {
    std::vector<Vec3> corners;
    while (true) {
      const std::string key = word();
      if (key.empty() && solids_ > 0) return of_corners(corners);
      if (key != "solid") damaged("the word " + in_quotes(key) + " where solid belongs");
      ++solids_;
      skip_line();  // its name
      for (std::string next = word(); next != "endsolid"; next = word()) {
        if (next != "facet") unexpected(next, "facet or endsolid");
        expect("normal");
        read_vector();
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
          expect("vertex");
          corners.push_back(read_vector());
        }
        expect("endloop");
        expect("endfacet");
        if (corners.size() > std::numeric_limits<int>::max() - 3U) damaged("too many facets");
      }
      skip_line();
    }
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
    throw InputError(file_ + ":" + std::to_string(line) + ": found a damaged or truncated file (" +
                     what + "), expected a surface");
  }
  [[noreturn]] void unexpected(const std::string& found, const std::string& expected) const {
    damaged(found.empty() ? "it ends where " + expected + " belongs"
                          : "the word " + in_quotes(found) + " where " + expected + " belongs");
  }
  std::string word() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
    return lower(text_.substr(begin, at_ - begin));
  }
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }
  void expect(const std::string& key) {
    if (const std::string found = word(); found != key) unexpected(found, key);
  }
  Vec3 read_vector() {
    Vec3 out;
    for (int k = 0; k < 3; ++k) {
      const std::string found = word();
      const char *first = found.data() + (found.starts_with('+') ? 1 : 0),
                 *last = found.data() + found.size();
      const auto [stop, error] = std::from_chars(first, last, out[k]);
      if (error != std::errc() || stop != last) unexpected(found, "a number");
    }
    return out;
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  int solids_ = 0;
};

}  // namespace

SurfaceFile read_stl(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string text = whole_file(file);
  const auto facets = text.size() < head_size
                          ? std::size_t(0)
                          : std::size_t(little_endian<std::uint32_t>(text.data() + 80));
  // Binary files may begin with solid too, so their length decides; no ascii file holds a zero.
  if (text.size() >= head_size && text.size() == head_size + facet_size * facets)
    return read_binary(text, facets);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool ascii = first != std::string::npos && lower(text.substr(first, 5)) == "solid" &&
                     text.find('\0') == std::string::npos;
  if (ascii) return Ascii(name, text).read();
  if (text.size() < head_size)
    throw InputError(name + ": found a damaged or truncated file (" + std::to_string(text.size()) +
                     " bytes), expected a surface in STL");
  throw InputError(name + ": found a damaged or truncated file (" + std::to_string(text.size()) +
                   " bytes), expected " + std::to_string(head_size + facet_size * facets) +
                   " for the " + std::to_string(facets) + " facets of its head");
}

}  // namespace vasorod
