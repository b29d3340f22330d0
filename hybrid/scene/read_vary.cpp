#include <algorithm>
#include <array>
#include <utility>

#include "scene/read_parts.h"

namespace vasorod {
namespace {

using What = Uncertain::What;

constexpr std::array quantities{What::young,    What::poisson, What::thickness,
                                What::pressure, What::cut,     What::incision};
constexpr double least_factor = 0.1, largest_factor = 10, largest_offset = 1e6;
// Four of it leave a factor above 0.
constexpr double largest_sd = 0.2;
constexpr int most_samples = 1000, most_best = 100;

void read_distribution(const Field& field, Uncertain& uncertain) {
  const std::string range = uncertain.scales() ? "factor" : "offset";
  const std::string other = uncertain.scales() ? "offset" : "factor";
  const std::string expected = range + ": [low, high] or sd: number";
  if (field.has(other))
    field.at(other, "").refuse("it with " + to_string(uncertain.what), expected);
  if (field.has(range) == field.has("sd"))
    field.refuse(field.has("sd") ? "both " + range + " and sd" : "neither " + range + " nor sd",
                 expected);
  if (const auto sd = field.find("sd")) {
    uncertain.sd = sd->number_in(1e-6, largest_offset);
    if (uncertain.scales() && uncertain.sd > largest_sd)
      sd->refuse(number_text(uncertain.sd), "at most " + number_text(largest_sd) + " of a factor");
    return;
  }
  const auto ends = field.at(range, expected).list("[low, high]");
  if (ends.size() != 2)
    field.at(range, "").refuse(std::to_string(ends.size()) + " numbers", "two: [low, high]");
  const auto end = [&](const Field& number) {
    return uncertain.scales() ? number.number_in(least_factor, largest_factor)
                              : number.number_in(-largest_offset, largest_offset);
  };
  uncertain.low = end(ends[0]);
  uncertain.high = end(ends[1]);
  if (!(uncertain.low < uncertain.high))
    field.at(range, "").refuse("a low end that is not below the high one", "[low, high]");
}

Uncertain read_uncertain(const Field& field, const std::vector<VesselSpec>& vessels) {
  field.check_keys({"what", "vessel", "factor", "offset", "sd"});
  const std::string what =
      field.at("what", "young, poisson, thickness, pressure, cut or incision")
          .one_of({"young", "poisson", "thickness", "pressure", "cut", "incision"});
  Uncertain uncertain;
  for (const What one : quantities)
    if (to_string(one) == what) uncertain.what = one;
  const bool of_wall = uncertain.what == What::young || uncertain.what == What::poisson ||
                       uncertain.what == What::thickness;
  if (const auto vessel = field.find("vessel")) {
    if (!of_wall)
      vessel->refuse("it with " + what, "young, poisson or thickness, which belong to one vessel");
    const VesselSpec& named = named_vessel(*vessel, vessels);
    if (!named.wall) vessel->refuse("a vessel without a wall", "a deformable vessel");
    uncertain.vessel = named.name;
  }
  if (uncertain.what == What::pressure &&
      std::none_of(vessels.begin(), vessels.end(),
                   [](const VesselSpec& vessel) { return vessel.pressure.has_value(); }))
    field.at("what", "").refuse("pressure in a scene without one", "a vessel with pressure");
  read_distribution(field, uncertain);
  return uncertain;
}

}  // namespace

VarySpec read_vary(const Field& field, const std::vector<VesselSpec>& vessels) {
  field.check_keys({"uncertain", "samples", "best", "seed", "fidelity"});
  const std::string expected = "a list of uncertain quantities";
  VarySpec spec;
  const Field uncertain = field.at("uncertain", expected);
  for (const Field& item : uncertain.list(expected))
    spec.uncertain.push_back(read_uncertain(item, vessels));
  if (spec.uncertain.empty()) uncertain.refuse("an empty list", expected);
  if (const auto samples = field.find("samples"))
    spec.samples = samples->integer_in(2, most_samples);
  if (const auto best = field.find("best")) spec.best = best->integer_in(1, most_best);
  if (const auto seed = field.find("seed")) spec.seed = seed->integer_in(0, 1000000);
  if (const auto fidelity = field.find("fidelity"))
    spec.fidelity = fidelity->one_of({"rod", "skin", "paper", "coupled"});
  return spec;
}

}  // namespace vasorod
