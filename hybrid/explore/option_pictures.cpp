#include "explore/option_pictures.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "report/base64.h"
#include "report/draw_result.h"
#include "report/report_pictures.h"
#include "result/read_folder.h"

namespace vasorod {
namespace {

constexpr std::array size{480, 400};

}  // namespace

Look look_of(const Result& result) {
  const std::vector<DrawnBody> bodies = drawn_bodies(result);
  const Camera camera = report_camera(result, bodies, double(size[0]) / size[1]);
  Look look;
  look.towards_eye = camera.axes.row(2);
  look.up = camera.axes.row(1);
  look.centre = camera.centre;
  look.height = 2 * camera.half_height;
  for (const DrawnField& field : drawn_fields(result))
    look.ranges[field.file] = {field.scale.low, field.scale.high};
  return look;
}

Look common_look(const std::vector<Look>& looks) {
  Look common = looks.empty() ? Look() : looks.front();
  for (const Look& look : looks) {
    common.height = std::max(common.height, look.height + 2 * (look.centre - common.centre).norm());
    for (const auto& [name, range] : look.ranges) {
      auto& widest = common.ranges.emplace(name, range).first->second;
      widest = {std::min(widest[0], range[0]), std::max(widest[1], range[1])};
    }
  }
  return common;
}

std::vector<std::pair<std::string, std::string>> option_colours(const std::vector<Row>& rows) {
  std::vector<std::pair<std::string, std::string>> colours{
      {"vessel", "Vessels"}, {"twist_shear", "Twist shear"}, {"axial_stretch", "Axial stretch"}};
  if (std::any_of(rows.begin(), rows.end(),
                  [](const Row& row) { return row.criteria.contains("contact_pressure"); }))
    colours.emplace_back("contact_pressure", "Contact pressure");
  return colours;
}

std::string option_pictures(const std::filesystem::path& folder, const Look& look,
                            const std::vector<std::pair<std::string, std::string>>& colours) {
  const Result result = read_result_folder(folder);
  nlohmann::ordered_json pictures = nlohmann::ordered_json::object();
  for (const auto& [colour, title] : colours) {
    DrawOptions options;
    options.colour = colour;
    options.from = look.towards_eye;
    options.up = look.up;
    options.centre = look.centre;
    options.height = look.height;
    options.size = size;
    if (const auto range = look.ranges.find(colour);
        range != look.ranges.end() && range->second[0] < range->second[1])
      options.range = range->second;
    pictures[colour] = base64(draw_result(result, options));
  }
  return pictures.dump();
}

}  // namespace vasorod
