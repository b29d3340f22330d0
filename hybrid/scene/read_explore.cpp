#include <cmath>

#include "data/limits.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

constexpr int most_steps = 1000, most_best = 1000;
constexpr int most_starts = 100, most_evaluations = 1000;  // of a search

// `steps` numbers from `from` to `to`, both included; one alone is `from`.
std::vector<double> read_span(const Field& field, double lowest, double highest) {
  field.check_keys({"from", "to", "steps"});
  const std::string expected = "{from: number, to: number, steps: number}";
  const double from = field.at("from", expected).number_in(lowest, highest),
               to = field.at("to", expected).number_in(lowest, highest);
  const int steps = field.at("steps", expected).integer_in(1, most_steps);
  std::vector<double> values;
  for (int k = 0; k < steps; ++k) {
    const double share = steps == 1 ? 0 : static_cast<double>(k) / (steps - 1);
    values.push_back((1 - share) * from + share * to);
  }
  return values;
}

// What `read` makes of one value or of each value of a list.
template <class Read>
auto each(const Field& field, const std::string& expected, Read&& read) {
  std::vector<decltype(read(field))> values;
  if (!field.is_list()) {
    values.push_back(read(field));
    return values;
  }
  for (const Field& item : field.list(expected)) values.push_back(read(item));
  if (values.empty()) field.refuse("an empty list", expected);
  return values;
}

// A number, a list of numbers or a span, all from `lowest` to `highest`; nothing where it is
// absent.
std::vector<double> read_numbers(const Field& explore, const std::string& key, double lowest,
                                 double highest) {
  const auto field = explore.find(key);
  if (!field) return {};
  if (field->is_map()) return read_span(*field, lowest, highest);
  return each(*field, "a number, a list of numbers or {from: number, to: number, steps: number}",
              [&](const Field& item) { return item.number_in(lowest, highest); });
}

std::vector<std::optional<double>> read_rotations(const Field& explore) {
  const auto field = explore.find("rotation_deg");
  if (!field) return {};
  if (field->is_map()) {
    const std::vector<double> span = read_span(*field, -360, 360);
    return {span.begin(), span.end()};
  }
  return each(*field, "auto, a number or a list of them", [](const Field& item) {
    return item.is("auto") ? std::nullopt : std::optional(item.number_in(-360, 360));
  });
}

std::map<std::string, double> read_weights(const Field& field) {
  field.check_keys(
      {"twist_shear", "twist", "stretch", "mouth", "lumen", "contact_pressure", "validity"});
  std::map<std::string, double> weights;
  for (const char* name :
       {"twist_shear", "twist", "stretch", "mouth", "lumen", "contact_pressure", "validity"})
    if (const auto weight = field.find(name)) weights[name] = weight->number_in(0, 1000);
  return weights;
}

std::map<std::string, double> read_thresholds(const Field& field) {
  field.check_keys(
      {"twist_shear", "twist", "stretch", "mouth", "lumen", "contact_pressure", "validity"});
  std::map<std::string, double> thresholds;
  for (const char* name : {"twist_shear", "twist", "stretch", "contact_pressure", "validity"})
    if (const auto threshold = field.find(name)) thresholds[name] = threshold->number_in(1e-6, 1e6);
  // Shares that are 1 at best.
  for (const char* name : {"mouth", "lumen"})
    if (const auto threshold = field.find(name)) thresholds[name] = threshold->number_in(0, 0.99);
  return thresholds;
}

RefineSpec read_refine(const Field& field) {
  field.check_keys({"evaluations", "best"});
  RefineSpec spec;
  if (const auto evaluations = field.find("evaluations"))
    spec.evaluations = evaluations->integer_in(1, most_evaluations);
  if (const auto best = field.find("best")) spec.best = best->integer_in(1, most_starts);
  return spec;
}

}  // namespace

ExploreSpec read_explore(const Field& field, const std::vector<VesselSpec>& vessels) {
  field.check_keys({"cut_along", "cut_tilt_deg", "incision_along", "around_deg", "incision_length",
                    "incision_shape", "rotation_deg", "stages", "best", "weights", "thresholds",
                    "vary", "refine"});
  ExploreSpec spec;
  spec.line = field.line();
  spec.cut_along = read_numbers(field, "cut_along", 0, 1);
  spec.cut_tilt_deg = read_numbers(field, "cut_tilt_deg", cut_tilts_deg[0], cut_tilts_deg[1]);
  spec.incision_along = read_numbers(field, "incision_along", 0, 1);
  spec.around_deg = read_numbers(field, "around_deg", -360, 360);
  spec.incision_length =
      read_numbers(field, "incision_length", incision_lengths[0], incision_lengths[1]);
  if (const auto shape = field.find("incision_shape"))
    spec.incision_shape = each(*shape, "slit, {ellipse: ...} or a list of them", read_shape);
  spec.rotation_deg = read_rotations(field);
  if (const auto stages = field.find("stages"))
    spec.stages = each(*stages, "fidelities: rod, skin, paper or coupled", [](const Field& item) {
      return item.one_of({"rod", "skin", "paper", "coupled"});
    });
  if (const auto best = field.find("best")) spec.best = best->integer_in(1, most_best);
  if (const auto weights = field.find("weights")) spec.weights = read_weights(*weights);
  if (const auto thresholds = field.find("thresholds"))
    spec.thresholds = read_thresholds(*thresholds);
  if (const auto vary = field.find("vary")) spec.vary = read_vary(*vary, vessels);
  if (const auto refine = field.find("refine")) spec.refine = read_refine(*refine);
  return spec;
}

}  // namespace vasorod
