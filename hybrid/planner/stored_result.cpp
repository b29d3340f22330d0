#include "planner/stored_result.h"

#include <cmath>
#include <limits>

#include "data/index.h"
#include "data/part_names.h"
#include "data/sentence.h"
#include "report/report_pictures.h"

namespace vasorod::planner {
namespace {

std::string map_name(ColourMap map) {
  return map == ColourMap::diverging    ? "diverging"
         : map == ColourMap::sequential ? "sequential"
                                        : "grey";
}

// The page has the unit in a column of its own.
std::string without_unit(const std::string& title) {
  return title.substr(0, title.find(','));
}

std::vector<ShownField> fields_of(const Result& result) {
  std::vector<ShownField> fields;
  for (const DrawnField& drawn : drawn_fields(result)) {
    ShownField field;
    field.name = drawn.array;
    field.title = without_unit(drawn.scale.title);
    field.unit = drawn.file == "contact_pressure" ? "mmHg" : "";
    field.map = map_name(drawn.scale.map);
    field.shown_per = drawn.scale.shown_per;
    field.neutral = drawn.at_rest * field.shown_per;
    field.low = drawn.scale.low * field.shown_per;
    field.high = drawn.scale.high * field.shown_per;
    field.values = drawn.values;
    fields.push_back(field);
  }
  return fields;
}

// Values at the nodes of one line; null where the result has none.
template <class Value>
Json along(const std::vector<int>& nodes, bool there, Value&& value) {
  if (!there) return nullptr;
  Json list = Json::array();
  for (const int node : nodes) list.push_back(value(index(node)));
  return list;
}

void add_lines(const VesselResult& vessel, Json& lines) {
  const CenterlineResult& rod = *vessel.centerline;
  const std::size_t count = index(rod.current.rows());
  const bool strains = rod.u.size() == count && rod.v.size() == count && rod.u0.size() == count &&
                       rod.v0.size() == count;
  for (std::size_t branch = 0; branch < rod.lines.size(); ++branch) {
    const std::vector<int>& nodes = rod.lines[branch];
    Json line;
    line["vessel"] = vessel.name;
    line["branch"] = branch;
    line["arc"] =
        along(nodes, rod.abscissa.size() == count, [&](std::size_t k) { return rod.abscissa[k]; });
    const auto row = [](const Points& points, std::size_t k) {
      return json_of(Vec3(points.row(static_cast<Eigen::Index>(k))));
    };
    line["point"] = along(nodes, true, [&](std::size_t k) { return row(rod.current, k); });
    line["rest"] = along(nodes, true, [&](std::size_t k) { return row(rod.rest, k); });
    line["lumen_area"] = along(nodes, rod.lumen_area.size() == count,
                               [&](std::size_t k) { return rod.lumen_area[k]; });
    line["flattening"] = along(nodes, rod.flattening.size() == count,
                               [&](std::size_t k) { return rod.flattening[k]; });
    line["stretch"] =
        along(nodes, strains, [&](std::size_t k) { return rod.v[k].z() / rod.v0[k].z(); });
    line["twist_deg_per_length"] = along(nodes, strains, [&](std::size_t k) {
      return (rod.u[k].z() - rod.u0[k].z()) * (180 / M_PI);
    });
    line["curvature"] = along(
        nodes, strains, [&](std::size_t k) { return std::hypot(rod.u[k].x(), rod.u[k].y()); });
    line["radius"] =
        along(nodes, rod.radius.size() == count, [&](std::size_t k) { return rod.radius[k]; });
    lines.push_back(std::move(line));
  }
}

}  // namespace

StoredResult::StoredResult(std::string result_id, Result&& solved, std::optional<Plan> solved_plan,
                           std::string json_text)
    : id(std::move(result_id)),
      result(std::move(solved)),
      plan(std::move(solved_plan)),
      json(std::move(json_text)),
      fields(fields_of(result)),
      to_lumen(result.vessels.size()) {}

std::size_t StoredResult::vessel(const std::string& name) const {
  for (std::size_t k = 0; k < result.vessels.size(); ++k)
    if (result.vessels[k].name == name) return k;
  throw Refusal(404, "found no vessel " + in_quotes(name) + ", expected one of the result");
}

const std::vector<std::optional<RayHits>>& StoredResult::walls() const {
  std::call_once(built_, [&] {
    std::vector<std::optional<RayHits>> walls;
    for (const VesselResult& vessel : result.vessels)
      walls.push_back(vessel.current.rows() > 0
                          ? std::optional<RayHits>(
                                std::in_place, TriangleSurface{vessel.current, vessel.triangles})
                          : std::nullopt);
    walls_ = std::move(walls);
  });
  return walls_;
}

Json json_of(const StoredResult& stored) {
  Json answer;
  answer["id"] = stored.id;
  answer["plan"] = stored.plan ? json_of(*stored.plan) : Json();
  answer["fidelity"] = stored.result.fidelity;
  answer["json"] = Json::parse(stored.json);
  answer["vessels"] = Json::array();
  answer["lines"] = Json::array();
  for (const VesselResult& vessel : stored.result.vessels) {
    Json one{{"name", vessel.name},
             {"role", vessel.obstacle ? "obstacle" : "deformable"},
             {"fields", Json::array()}};
    for (const ShownField& field : stored.fields) {
      const Eigen::VectorXd& values = vessel.*field.values;
      if (values.size() == 0 || values.size() != vessel.current.rows()) continue;
      one["fields"].push_back({{"name", field.name},
                               {"title", field.title},
                               {"unit", field.unit},
                               {"map", field.map},
                               {"neutral", field.neutral},
                               {"range", {field.low, field.high}}});
    }
    answer["vessels"].push_back(std::move(one));
    if (vessel.stump)
      answer["vessels"].push_back(
          {{"name", stump_name(vessel.name)}, {"role", "stump"}, {"fields", Json::array()}});
    if (vessel.centerline) add_lines(vessel, answer["lines"]);
  }
  return answer;
}

}  // namespace vasorod::planner
