#include <cmath>

#include <vasorod/compare.h>

#include "data/sentence.h"
#include "result/json_text.h"

namespace vasorod {

namespace {

using Json = nlohmann::ordered_json;

Json row(const Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

Json distances(const std::optional<Distances>& value) {
  if (!value) return nullptr;
  return {{"rms", value->rms}, {"largest", value->largest}, {"largest_at", row(value->largest_at)}};
}

Json header(const ComparedResult& result) {
  return {{"folder", result.folder},
          {"program", result.program},
          {"fidelity", result.fidelity},
          {"status", result.status},
          {"seconds", result.seconds}};
}

std::string text(double value) {
  return std::isfinite(value) ? scientific_text(value, 3) : "-";
}

// Columns as wide as their widest cell; the first is aligned left, the others right.
std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& line : rows)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string result;
  for (const auto& line : rows) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::string gap(widths[k] - line[k].size(), ' ');
      result += k == 0 ? line[k] + gap : "  " + gap + line[k];
    }
    result += '\n';
  }
  return result;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json value = {{"schema", 1},
                {"scene", comparison.scene},
                {"units", {{"length", comparison.length_unit}, {"stress", comparison.stress_unit}}},
                {"a", header(comparison.a)},
                {"b", header(comparison.b)},
                {"seconds_ratio", comparison.b.seconds / comparison.a.seconds}};
  value["vessels"] = Json::array();
  for (const VesselComparison& vessel : comparison.vessels)
    value["vessels"].push_back({{"vessel", vessel.name},
                                {"radius", vessel.radius},
                                {"surface", distances(vessel.surface)},
                                {"centerline", distances(vessel.centerline)},
                                {"rest_distance", vessel.rest_distance}});
  value["ends"] = Json::array();
  for (const ReactionComparison& end : comparison.reactions)
    value["ends"].push_back({{"vessel", end.vessel},
                             {"end", end.end},
                             {"force_a", row(end.force_a)},
                             {"force_b", row(end.force_b)},
                             {"force_difference", end.force_difference},
                             {"moment_a", row(end.moment_a)},
                             {"moment_b", row(end.moment_b)},
                             {"moment_difference", end.moment_difference}});
  value["ends_of_one"] = Json::array();
  for (const LoneEnd& end : comparison.lone_ends)
    value["ends_of_one"].push_back(
        {{"vessel", end.vessel}, {"end", end.end}, {"in", end.in_a ? "a" : "b"}});
  return json_text(value);
}

std::string comparison_table(const Comparison& comparison) {
  const auto title = [](const std::string& name, const ComparedResult& result) {
    return name + ": " + result.folder + " (" + result.program + ", " + result.fidelity + ", " +
           result.status + ", " + text(result.seconds) + " s)\n";
  };
  std::string result =
      "scene " + comparison.scene + "\n" + title("A", comparison.a) + title("B", comparison.b);
  std::vector<std::vector<std::string>> rows{{"distance over R", "R, " + comparison.length_unit,
                                              "surface rms", "largest", "centerline rms", "largest",
                                              "at rest"}};
  for (const VesselComparison& vessel : comparison.vessels) {
    const double none = std::nan("");
    rows.push_back(
        {vessel.name, text(vessel.radius), text(vessel.surface ? vessel.surface->rms : none),
         text(vessel.surface ? vessel.surface->largest : none),
         text(vessel.centerline ? vessel.centerline->rms : none),
         text(vessel.centerline ? vessel.centerline->largest : none), text(vessel.rest_distance)});
  }
  result += "\n" + table(rows);
  // All of them are in one of the two.
  std::string lone;
  for (const LoneEnd& end : comparison.lone_ends)
    lone += (lone.empty() ? std::string("supported in ") + (end.in_a ? "A" : "B") + " only: "
                          : std::string(", ")) +
            end.vessel + " " + end.end;
  if (!lone.empty()) lone += '\n';
  if (comparison.reactions.empty()) return lone.empty() ? result : result + "\n" + lone;
  rows = {{"reaction", "|force A|", "|force B|", "difference", "|moment A|", "|moment B|",
           "difference"}};
  for (const ReactionComparison& end : comparison.reactions)
    rows.push_back({end.vessel + " " + end.end, text(end.force_a.norm()), text(end.force_b.norm()),
                    text(end.force_difference), text(end.moment_a.norm()),
                    text(end.moment_b.norm()), text(end.moment_difference)});
  return result + "\n" + table(rows) + "differences over the largest of A\n" + lone;
}

}  // namespace vasorod
