#include "scene/read_markup.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include <vasorod/error.h>

#include "data/limits.h"
#include "data/sentence.h"
#include "data/whole_file.h"

namespace vasorod {
namespace {

using Json = nlohmann::json;

// A file with thousands of points is far below.
constexpr std::uintmax_t most_bytes = 16'000'000;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(one_line(file.string())) {}

  std::vector<MarkupPoint> read(const Json& root) const {
    const std::string expected = "a markups file of 3D Slicer (.mrk.json) with a list \"markups\"";
    if (!root.is_object() || !root.contains("markups") || !root["markups"].is_array())
      refuse("", "other JSON", expected);
    std::vector<MarkupPoint> points;
    for (std::size_t m = 0; m < root["markups"].size(); ++m)
      add_points(root["markups"][m], "markups[" + std::to_string(m) + "]", points);
    return points;
  }

  [[noreturn]] void refuse(const std::string& place, const std::string& found,
                           const std::string& expected) const {
    throw InputError(file_ + ": " + (place.empty() ? "" : place + ": ") + "found " + found +
                     ", expected " + expected);
  }

 private:
  static std::string shown(const Json& value) {
    return shortened(value.dump(-1, ' ', true, Json::error_handler_t::replace));
  }

  std::string space_of(const Json& markup, const std::string& place) const {
    if (!markup.contains("coordinateSystem")) return "LPS";
    const Json& system = markup["coordinateSystem"];
    if (system == "LPS" || system == "RAS") return system.get<std::string>();
    if (system == 0 || system == "0") return "RAS";
    if (system == 1 || system == "1") return "LPS";
    refuse(place + ".coordinateSystem", shown(system), "LPS or RAS");
  }

  // Slicer writes mm; micrometres, or a length in DICOM's three words, are not taken for them.
  void check_unit(const Json& markup, const std::string& place) const {
    if (!markup.contains("coordinateUnits")) return;
    const Json& unit = markup["coordinateUnits"];
    if (unit == "mm" || (unit.is_array() && !unit.empty() && unit[0] == "mm")) return;
    refuse(place + ".coordinateUnits", shown(unit), "mm");
  }

  Vec3 position_of(const Json& point, const std::string& place) const {
    const std::string expected = "a position of three numbers";
    if (!point.contains("position")) refuse(place, "no position", expected);
    const Json& position = point["position"];
    if (!position.is_array() || position.size() != 3)
      refuse(place + ".position", shown(position), expected);
    Vec3 out;
    for (int k = 0; k < 3; ++k) {
      const Json& x = position[static_cast<std::size_t>(k)];
      if (!x.is_number() || !(std::abs(x.get<double>()) <= largest_length))
        refuse(place + ".position", shown(position), expected);
      out[k] = x.get<double>();
    }
    return out;
  }

  void add_points(const Json& markup, const std::string& place,
                  std::vector<MarkupPoint>& points) const {
    if (!markup.is_object()) refuse(place, shown(markup), "a markup");
    if (!markup.contains("controlPoints")) return;
    const Json& all = markup["controlPoints"];
    if (!all.is_array()) refuse(place + ".controlPoints", shown(all), "a list of points");
    const std::string space = space_of(markup, place);
    check_unit(markup, place);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::string here = place + ".controlPoints[" + std::to_string(k) + "]";
      const Json& point = all[k];
      if (!point.is_object()) refuse(here, shown(point), "a point");
      // A point that was not placed yet ("undefined", "preview", "missing") has no position.
      if (point.contains("positionStatus") && point["positionStatus"] != "defined") continue;
      MarkupPoint out;
      if (point.contains("label")) {
        if (!point["label"].is_string()) refuse(here + ".label", shown(point["label"]), "a text");
        out.label = point["label"].get<std::string>();
      }
      out.point = position_of(point, here);
      out.space = space;
      points.push_back(std::move(out));
    }
  }

  std::string file_;
};

}  // namespace

std::vector<MarkupPoint> read_markups(const std::filesystem::path& file) {
  const Reader reader(file);
  const std::string expected = "a markups file of 3D Slicer (.mrk.json)";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) reader.refuse("", "no such file", expected);
  if (!std::filesystem::is_regular_file(file, error))
    reader.refuse("", "a folder or device", expected);
  if (const auto bytes = std::filesystem::file_size(file, error); !error && bytes > most_bytes)
    reader.refuse("", "a file of " + std::to_string(bytes) + " bytes",
                  "at most " + std::to_string(most_bytes));
  // Without exceptions: the parser's messages quote the file.
  const Json root = Json::parse(whole_file(file), nullptr, false);
  if (root.is_discarded()) reader.refuse("", "no JSON", expected);
  return reader.read(root);
}

}  // namespace vasorod
