#include "explore/row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include <vasorod/error.h>

#include "explore/ranking.h"
#include "result/unknown_validity.h"

namespace vasorod {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array endings{Ending::open, Ending::solved, Ending::not_built, Ending::failed};

// The limits at which Validity::in_range ends.
double share_of_range(const Validity& validity) {
  constexpr double ratio_limit = 0.9, strain_limit = 0.2;
  return std::max({validity.brazier_ratio / ratio_limit, validity.wrinkling_ratio / ratio_limit,
                   validity.twist_ratio / ratio_limit, validity.largest_strain / strain_limit});
}

Json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json json_of(const Look& look) {
  return {{"towards_eye", json_of(look.towards_eye)},
          {"up", json_of(look.up)},
          {"centre", json_of(look.centre)},
          {"height", look.height},
          {"ranges", look.ranges}};
}

Look look_of(const Json& json) {
  return {vector_of(json.at("towards_eye")), vector_of(json.at("up")), vector_of(json.at("centre")),
          json.at("height").get<double>(),
          json.at("ranges").get<std::map<std::string, std::array<double, 2>>>()};
}

bool unseen(const Criterion& criterion, const std::string& fidelity) {
  return fidelity == "skin" && (criterion.name == "lumen" || criterion.name == "mouth");
}

}  // namespace

std::string to_string(Ending ending) {
  switch (ending) {
    case Ending::open:
      return "open";
    case Ending::solved:
      return "solved";
    case Ending::not_built:
      return "not_built";
    case Ending::failed:
      return "failed";
  }
  return "open";
}

void take_result(const Result& result, Row& row) {
  row.ending = Ending::solved;
  row.status = result.status;
  row.in_range = known_range(result);
  row.criteria.clear();
  row.sentences = result.validity.warnings;
  if (!is_solution(result.status)) {
    row.sentences.insert(row.sentences.begin(), why_unknown(result.status));
    return;
  }
  for (const Criterion& criterion : result.criteria)
    if (is_ranked(criterion.name) && !unseen(criterion, result.fidelity) &&
        std::isfinite(criterion.value))
      row.criteria[criterion.name] = criterion.value;
  const double share = share_of_range(result.validity);
  if (row.in_range && std::isfinite(share))
    row.criteria["validity"] = *row.in_range ? share : std::max(share, 1.0);
}

std::string row_json(const Row& row) {
  Json json;
  json["fidelity"] = row.fidelity;
  json["ending"] = to_string(row.ending);
  json["status"] = to_string(row.status);
  json["in_range"] = row.in_range ? Json(*row.in_range) : Json();
  json["criteria"] = Json::object();
  for (const auto& [name, value] : row.criteria) json["criteria"][name] = value;
  json["sentences"] = row.sentences;
  json["seconds"] = row.seconds;
  json["folder"] = row.folder;
  if (row.look) json["look"] = json_of(*row.look);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void read_row(const std::string& text, Row& row) {
  try {
    const Json json = Json::parse(text);
    const auto ending = json.at("ending").get<std::string>();
    const auto known = std::find_if(endings.begin(), endings.end(),
                                    [&](Ending one) { return to_string(one) == ending; });
    const auto status = status_named(json.at("status").get<std::string>());
    if (known == endings.end() || !status) throw InputError("found an unknown status");
    row.fidelity = json.at("fidelity").get<std::string>();
    row.ending = *known;
    row.status = *status;
    row.in_range.reset();
    if (!json.at("in_range").is_null()) row.in_range = json.at("in_range").get<bool>();
    row.criteria = json.at("criteria").get<std::map<std::string, double>>();
    row.sentences = json.at("sentences").get<std::vector<std::string>>();
    row.seconds = json.at("seconds").get<double>();
    row.folder = json.at("folder").get<std::string>();
    row.look.reset();
    if (json.contains("look")) row.look = look_of(json.at("look"));
  } catch (const Json::exception& error) {
    throw InputError(std::string("found no row of an exploration: ") + error.what());
  }
}

}  // namespace vasorod
