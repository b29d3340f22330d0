#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include <vasorod/error.h>
#include <vasorod/version.h>

#include "app/commands.h"
#include "data/sentence.h"
#include "data/whole_file.h"
#include "prepare/prepare.h"
#include "result/json_text.h"
#include "result/write_vtp.h"

namespace vasorod {
namespace {

using Json = nlohmann::ordered_json;

std::string shown(const std::filesystem::path& file) {
  return one_line(file.string());
}

void require_writable(const PrepareCommandOptions& options) {
  const std::filesystem::path& file = options.output;
  std::error_code ignored;
  if (file.extension() != ".vtp")
    throw InputError(shown(file) + ": expected the name of a surface that ends in .vtp");
  for (const auto& input : options.request.files)
    if (std::filesystem::equivalent(input, file, ignored))
      throw InputError(shown(file) + ": found the input itself, expected another name to write to");
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, ignored))
    throw FileError(shown(folder) + ": found no such folder, expected the one of the surface");
}

Json numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

std::string report_json(const PreparedSurface& prepared, const PrepareCommandOptions& options) {
  Json json;
  json["program"] = "vasorod " + version();
  for (const auto& file : options.request.files) json["files"].push_back(file.string());
  json["output"] = options.output.string();
  json["length_unit"] = "mm";
  json["space"] = prepared.space.empty() ? Json(nullptr) : Json(prepared.space);
  json["done"] = prepared.done;
  json["warnings"] = prepared.warnings;
  json["ends"] = Json::array();
  for (const PreparedEnd& end : prepared.ends)
    json["ends"].push_back(
        {{"center", numbers(end.center)}, {"normal", numbers(end.normal)}, {"radius", end.radius}});
  json["left_out"] = Json::array();
  for (const LeftOut& part : prepared.left_out)
    json["left_out"].push_back(
        {{"center", numbers(part.center)}, {"volume", part.volume}, {"inside", part.inside}});
  json["wall_moved"] = {{"largest", prepared.largest_distance}, {"mean", prepared.mean_distance}};
  json["volume"] = {{"before", prepared.volume_before}, {"after", prepared.volume_after}};
  json["fit"] = prepared.refusal.empty() ? "accepts it" : prepared.refusal;
  return json_text(json) + "\n";
}

std::string report_text(const PreparedSurface& prepared, const PrepareCommandOptions& options) {
  std::string text;
  for (const std::string& line : prepared.done) text += line + "\n";
  for (std::size_t k = 0; k < prepared.ends.size(); ++k) {
    const PreparedEnd& end = prepared.ends[k];
    text += "end " + std::to_string(k + 1) + ": centre " + place_text(end.center, 4) + ", radius " +
            number_text(end.radius, 4) + " mm\n";
  }
  text += "the wall moved " + number_text(prepared.largest_distance, 2) + " mm at most and " +
          number_text(prepared.mean_distance, 2) + " mm in the mean; volume " +
          number_text(prepared.volume_before, 5) + " mm^3 before and " +
          number_text(prepared.volume_after, 5) + " mm^3 after\n";
  text +=
      "coordinate system: " +
      (prepared.space.empty() ? std::string("unknown, the file does not say") : prepared.space) +
      "\n";
  for (const std::string& warning : prepared.warnings) text += "warning: " + warning + "\n";
  return text + shown(options.output) + "\n";
}

}  // namespace

int prepare_command(const PrepareCommandOptions& options) {
  require_writable(options);
  const PreparedSurface prepared = prepare(options.request);
  write_whole_file(
      options.output,
      surface_vtp(prepared.surface, {"length mm", "vasorod " + version(), "", prepared.space}));
  std::cout << (options.json ? report_json(prepared, options) : report_text(prepared, options));
  return prepared.refusal.empty() ? 0 : 1;
}

}  // namespace vasorod
