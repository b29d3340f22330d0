#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>

#include <vasorod/error.h>

#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

[[noreturn]] void damaged(const std::filesystem::path& file, int line, const std::string& found,
                          const std::string& expected) {
  throw InputError(file.string() + ":" + std::to_string(line) + ": found " + found + ", expected " +
                   expected);
}

// The index from 0 of "7", "7/1", "7//3" or "-1" (the last point so far); -1 if there is none.
int point_number(const std::string& word, int points_so_far) {
  long long number = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = error == std::errc() && (stop == word.data() + word.size() || *stop == '/');
  if (!whole) return -1;
  const long long index = number > 0 ? number - 1 : points_so_far + number;
  return number != 0 && index >= 0 && index < std::numeric_limits<int>::max()
             ? static_cast<int>(index)
             : -1;
}

double coordinate(const std::string& word) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, word.data() + word.size(), value);
  return error == std::errc() && stop == word.data() + word.size()
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

// Reads one line. A backslash at the end of a line continues it.
bool next_line(std::istream& in, std::string& line, int& number) {
  line.clear();
  std::string part;
  while (std::getline(in, part)) {
    ++number;
    if (!part.empty() && part.back() == '\r') part.pop_back();
    const bool goes_on = !part.empty() && part.back() == '\\';
    if (goes_on) part.back() = ' ';
    line += part;
    if (!goes_on) return true;
  }
  return !line.empty();
}

}  // namespace

SurfaceFile read_obj(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  SurfaceFile out;
  std::vector<Vec3> points;
  std::string line;
  for (int number = 0; next_line(in, line, number);) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "v") {
      Vec3 point;
      for (int k = 0; k < 3; ++k) {
        if (!(words >> word))
          damaged(file, number, "a point of " + std::to_string(k) + " coordinates", "three");
        point[k] = coordinate(word);
      }
      if (!point.allFinite())
        damaged(file, number, "a coordinate that is not a number", "finite coordinates");
      points.push_back(point);
    } else if (key == "f") {
      std::vector<int> polygon;
      while (words >> word) {
        polygon.push_back(point_number(word, static_cast<int>(points.size())));
        if (polygon.back() < 0)
          damaged(file, number, "a point that does not exist", "numbers of points");
      }
      out.polygons.push_back(std::move(polygon));
    } else if (key == "p" || key == "l") {
      ++out.skipped_cells;
    }
  }
  out.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (size_t i = 0; i < points.size(); ++i)
    out.points.row(static_cast<Eigen::Index>(i)) = points[i];
  return out;
}

}  // namespace vasorod
