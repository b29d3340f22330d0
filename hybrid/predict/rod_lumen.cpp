#include "predict/rod_lumen.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "rod/lumen_section.h"
#include "rod/scan_stress.h"

namespace vasorod {
namespace {

LumenSection lumen_in(const PreparedVessel& prepared, const RodElement& element, double scan,
                      double pressure) {
  const std::vector<double>&radius = prepared.vessel.rod.radius, &t = prepared.node_thickness;
  const auto a = index(element.first), b = index(element.second);
  return lumen_section({(radius[a] + radius[b]) / 2, (t[a] + t[b]) / 2},
                       prepared.spec.wall->material, scan, pressure);
}

// The ends that were held when the vessel was seen; all of them if the scene names none.
RodConditions held_as_seen(const Vessel& vessel, const VesselConditions& conditions, bool whole) {
  RodConditions held;
  const auto named = [&](int node) {
    const auto at_node = [node](const auto& condition) { return condition.node == node; };
    const RodConditions& rod = conditions.rod;
    return std::any_of(rod.supports.begin(), rod.supports.end(), at_node) ||
           std::any_of(rod.loads.begin(), rod.loads.end(), at_node);
  };
  for (const VesselEnd& end : vessel.ends)
    if (whole || named(end.node)) held.supports.push_back(clamp(end.node));
  if (held.supports.empty())
    for (const VesselEnd& end : vessel.ends) held.supports.push_back(clamp(end.node));
  return held;
}

}  // namespace

double press_rod(PreparedVessel& prepared, const VesselConditions& conditions, bool whole) {
  RodTree& rod = prepared.vessel.rod;
  const LumenPressure pressure = prepared.spec.pressure.value_or(LumenPressure{});
  const double stretch = prepared.spec.axial_prestretch - 1;
  std::vector<Vec6> unit, scan;
  const std::vector<char> at_fork = leaves_fork(rod);
  for (std::size_t e = 0; e < rod.elements.size(); ++e) {
    RodElement& element = rod.elements[e];
    unit.push_back(unit_thrust(element, at_fork[e]));
    const LumenSection seen = lumen_in(prepared, element, pressure.scan, pressure.scan);
    scan.emplace_back(seen.thrust * unit[e]);
    element.lumen = scan[e] - element.stiffness(2, 2) * stretch * unit[e];
  }
  const std::vector<Vec6> stress =
      scan_stress(rod, held_as_seen(prepared.vessel, conditions, whole));
  double widest = 0;
  for (std::size_t e = 0; e < rod.elements.size(); ++e) {
    RodElement& element = rod.elements[e];
    const LumenSection after = lumen_in(prepared, element, pressure.scan, pressure.after);
    // The wall's material stays: it moves outwards, so that E A is constant and I grows.
    const double wider = (1 + after.mid_strain) * (1 + after.mid_strain);
    element.stiffness.bottomRightCorner<3, 3>() *= wider;
    const Vec6 of_wall = stress[e] + scan[e];
    element.natural_strain =
        element.rest_strain - of_wall.cwiseQuotient(element.stiffness.diagonal());
    element.lumen = after.thrust * unit[e];
    if (std::abs(after.mid_strain) > std::abs(widest)) widest = after.mid_strain;
  }
  return widest;
}

Vec3 carried_lid(const PredictedVessel& vessel, int node) {
  const PreparedVessel& prepared = vessel.prepared;
  const auto& pressure = prepared.spec.pressure;
  const std::vector<VesselEnd>& ends = prepared.vessel.ends;
  const auto end = std::find_if(ends.begin(), ends.end(),
                                [&](const VesselEnd& other) { return other.node == node; });
  const std::vector<RodSupport>& supports = vessel.conditions.rod.supports;
  const bool carried = std::any_of(supports.begin(), supports.end(), [&](const RodSupport& s) {
    return s.node == node && (s.fixed[0] || s.fixed[1] || s.fixed[2]);
  });
  if (!pressure || end == ends.end() || !carried) return Vec3::Zero();
  const auto n = index(node);
  const AnnularSection section{prepared.vessel.rod.radius[n], prepared.node_thickness[n]};
  // A rigid end keeps the radius it was seen with.
  const bool rigid = std::any_of(
      vessel.conditions.ends.begin(), vessel.conditions.ends.end(),
      [&](const ConditionedEnd& named) { return named.rigid && named.end == end - ends.begin(); });
  const double area = lumen_section(section, prepared.spec.wall->material,
                                    rigid ? pressure->after : pressure->scan, pressure->after)
                          .area;
  return (node == 0 ? -1 : 1) * pressure->after * area * vessel.rod.poses[n].director(3);
}

// The rod's resultant is that of the wall less the lumen's pressure times area.
Vec3 force_on_wall(const PredictedVessel& vessel, const RodReaction& reaction) {
  if (!vessel.prepared.spec.pressure) return reaction.force;
  return reaction.force + carried_lid(vessel, reaction.node);
}

}  // namespace vasorod
