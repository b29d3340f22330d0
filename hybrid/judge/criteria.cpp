#include "judge/criteria.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "data/mmhg.h"

namespace vasorod {
namespace {

constexpr const char* none_known = "no threshold is known";
constexpr const char* of_lumen =
    "a convention of this program to draw the eye; no clinical threshold is known";
// Both studies are of veins. Their lengths and radii are not those of a vena cava.
constexpr const char* of_twist =
    "animal veins joined with a twist: in rats 100, 85, 28.5 and 25 % were open after 3 days at 0, "
    "90, 180 and 270 degrees (Salgarello et al., Ann Plast Surg 47, 2001, 643-646); in dogs 18 of "
    "20 grafts twisted by at most 135 degrees were open after 6 months and none of 5 twisted by "
    "200 (Endean et al., J Vasc Surg 9, 1989, 651-655)";

struct Worst {
  double value = 0;
  std::string vessel;
};

// The metrics' value with the largest `badness`, of the vessels that `counts` accepts.
template <class Value, class Badness, class Counts>
std::optional<Worst> worst_of(const Result& result, Value&& value, Badness&& badness,
                              Counts&& counts) {
  std::optional<Worst> worst;
  for (const VesselMetrics& metrics : result.metrics) {
    if (!counts(metrics.vessel)) continue;
    const double candidate = value(metrics);
    if (!worst || !(badness(candidate) <= badness(worst->value)))
      worst = Worst{candidate, metrics.vessel};
  }
  return worst;
}

const VesselResult* vessel_named(const Result& result, const std::string& name) {
  for (const VesselResult& vessel : result.vessels)
    if (vessel.name == name) return &vessel;
  return nullptr;
}

// The change of twist, summed along the lines of a centerline: largest minus smallest, degrees.
double twist_range(const CenterlineResult& line) {
  std::vector<double> angle(line.u.size(), 0);
  for (const std::vector<int>& nodes : line.lines)
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      const std::size_t a = index(nodes[k - 1]), b = index(nodes[k]);
      const double length = line.abscissa[b] - line.abscissa[a];
      angle[b] = angle[a] +
                 0.5 * length * (line.u[a].z() - line.u0[a].z() + line.u[b].z() - line.u0[b].z());
    }
  if (angle.empty()) return 0;
  const auto [low, high] = std::minmax_element(angle.begin(), angle.end());
  return (*high - *low) * 180 / M_PI;
}

// `sign` is 1 where large values are bad, -1 where small ones are.
Verdict judged(const Criterion& criterion, double sign) {
  if (!criterion.threshold) return Verdict::not_judged;
  const auto past = [&](const std::optional<double>& threshold) {
    if (!threshold) return false;
    return sign > 0 ? !(criterion.value < *threshold) : !(criterion.value >= *threshold);
  };
  return past(criterion.strong_threshold) ? Verdict::strong_warning
         : past(criterion.threshold)      ? Verdict::warning
                                          : Verdict::fine;
}

Criterion unjudged(const std::string& name, const Worst& worst, const std::string& unit) {
  return {name,         worst.vessel, worst.value,         unit,
          std::nullopt, std::nullopt, Verdict::not_judged, none_known};
}

// An area over its value at rest. Sections that are carried rigidly cannot narrow: that they did
// not says nothing.
Criterion of_area(const std::string& name, const Worst& worst, const std::string& fidelity) {
  Criterion area = unjudged(name, worst, "");
  area.threshold = 0.6;
  area.strong_threshold = 0.4;
  area.source = of_lumen;
  area.verdict = judged(area, -1);
  if (fidelity == "skin" && area.verdict == Verdict::fine) {
    area.verdict = Verdict::not_judged;
    area.source = "fidelity skin carries sections rigidly: they cannot narrow";
  }
  return area;
}

void add_lumen(const Result& result, std::vector<Criterion>& criteria) {
  const auto has_surface = [&](const std::string& name) {
    const VesselResult* vessel = vessel_named(result, name);
    return vessel != nullptr && vessel->rest.rows() > 0;
  };
  const auto worst = worst_of(
      result, [](const VesselMetrics& m) { return m.smallest_lumen_ratio; },
      [](double ratio) { return -ratio; }, has_surface);
  if (!worst) return;
  criteria.push_back(of_area("lumen", *worst, result.fidelity));
}

void add_mouth(const Result& result, std::vector<Criterion>& criteria) {
  const auto joined = joined_vessels(result);
  if (!joined || joined->mouth == nullptr) return;
  criteria.push_back(
      of_area("mouth", {joined->mouth->area_ratio, joined->mouth_of}, result.fidelity));
}

void add_twist(const Result& result, std::vector<Criterion>& criteria) {
  const auto has_line = [&](const std::string& name) {
    const VesselResult* vessel = vessel_named(result, name);
    return vessel != nullptr && vessel->centerline.has_value();
  };
  const auto angle = worst_of(
      result,
      [&](const VesselMetrics& m) {
        return twist_range(*vessel_named(result, m.vessel)->centerline);
      },
      [](double degrees) { return degrees; }, has_line);
  if (!angle) return;
  Criterion twist = unjudged("twist", *angle, "degrees");
  twist.threshold = 90;
  twist.strong_threshold = 180;
  twist.source = of_twist;
  twist.verdict = judged(twist, 1);
  criteria.push_back(twist);
}

void add_contact(const Result& result, std::vector<Criterion>& criteria) {
  Worst worst;
  const auto see = [&](double pressure, const std::string& vessel) {
    if (worst.vessel.empty() || !(pressure <= worst.value)) worst = {pressure, vessel};
  };
  for (const VesselMetrics& metrics : result.metrics)
    if (metrics.largest_pressure) see(*metrics.largest_pressure, metrics.vessel);
  for (const ContactReport& contact : result.contact) see(contact.largest_pressure, contact.a);
  if (worst.vessel.empty()) return;
  worst.value *= mmhg_per(result.stress_unit);
  criteria.push_back(unjudged("contact_pressure", worst, "mmHg"));
}

}  // namespace

std::vector<Criterion> criteria_of(const Result& result) {
  std::vector<Criterion> criteria;
  const auto every = [](const std::string&) { return true; };
  add_lumen(result, criteria);
  add_mouth(result, criteria);
  add_twist(result, criteria);
  if (const auto shear = worst_of(
          result, [](const VesselMetrics& m) { return m.largest_twist_shear; },
          [](double value) { return value; }, every))
    criteria.push_back(unjudged("twist_shear", *shear, ""));
  const auto distance = [](double stretch) { return std::abs(stretch - 1); };
  if (const auto stretch = worst_of(
          result,
          [&](const VesselMetrics& m) {
            return distance(m.stretch[0]) > distance(m.stretch[1]) ? m.stretch[0] : m.stretch[1];
          },
          distance, every))
    criteria.push_back(unjudged("stretch", *stretch, ""));
  add_contact(result, criteria);
  if (!is_solution(result.status))
    for (Criterion& criterion : criteria) criterion.verdict = Verdict::unknown;
  return criteria;
}

}  // namespace vasorod
