#include "surgery/vessel_cut.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "surgery/edited_vessel.h"

namespace vasorod {
namespace {

// Arc length between two nodes of a tree, one of which is the root or the end of a branch.
double path_length(const RodTree& rod, int from, int to) {
  std::vector<double> along(rod.rest.size(), 0);
  for (const RodBranch& branch : rod.branches)
    for (const int e : branch.elements) {
      const RodElement& element = rod.elements[index(e)];
      along[index(element.second)] = along[index(element.first)] + element.length;
    }
  return std::abs(along[index(from)] - along[index(to)]);
}

}  // namespace

VesselCut cut_across(const std::string& where, const PreparedVessel& vessel, const PickSpec& pick,
                     const EndSelector& keep) {
  VesselCut cut;
  const int kept_end = find_end(vessel.vessel, keep, where + ": keep");
  cut.pick = place_cut(where + ": cut", pick, vessel, kept_end);
  cut.kept_center = vessel.vessel.ends[index(kept_end)].center;
  cut.wall = placed(where, [&] {
    return cut_vessel(vessel.vessel.surface, cut.pick.section, cut.pick.point, cut.kept_center);
  });
  const RodTree& rod = vessel.vessel.rod;
  const int far_node = vessel.vessel.ends[index(kept_end)].node;
  const AxisPlace& at = cut.pick.at;
  cut.side = side_of(rod, at.element, at.s, far_node);
  cut.kept = cut_rod(rod, at.element, at.s, cut.side);
  cut.kept_node = cut.kept.node_of[index(far_node)];
  cut.fraction = path_length(cut.kept.tree, cut.kept_node, cut.kept.cut_node) /
                 pick_route(where + ": cut", pick, vessel.vessel, kept_end).length();
  return cut;
}

RodConditions kept_conditions(const RodConditions& before, const VesselCut& cut) {
  RodConditions now;
  for (RodSupport support : before.supports) {
    support.node = cut.kept.node_of[index(support.node)];
    if (support.node >= 0) now.supports.push_back(support);
  }
  for (RodLoad load : before.loads) {
    load.node = cut.kept.node_of[index(load.node)];
    if (load.node >= 0) now.loads.push_back(load);
  }
  const bool held =
      std::any_of(now.supports.begin(), now.supports.end(),
                  [&](const RodSupport& support) { return support.node == cut.kept_node; });
  if (!held) now.supports.push_back(clamp(cut.kept_node));
  return now;
}

void keep_part(const VesselCut& cut, const RodConditions& rod, PreparedVessel& vessel,
               VesselConditions& conditions) {
  const auto end_now = follow_edit(vessel, cut.wall.kept, cut.wall.kept_sources);
  for (VesselEnd& end : vessel.vessel.ends) end.node = cut.kept.node_of[index(end.node)];
  vessel.vessel.ends.push_back(
      {cut.wall.mouth, cut.wall.center, cut.wall.normal, cut.kept.cut_node});
  VesselConditions now;
  now.acts = true;
  now.rod = rod;
  for (ConditionedEnd end : conditions.ends) {
    end.end = end_now[index(end.end)];
    if (end.end >= 0) now.ends.push_back(end);
  }
  conditions = std::move(now);
  vessel.vessel.rod = cut.kept.tree;
  vessel.vessel.branch_of.clear();  // bind_again() finds the remaining branches
  vessel.node_thickness.assign(cut.kept.tree.rest.size(), vessel.thickness());
  bind_again(vessel);
}

CutReport report_of(const VesselCut& cut, double tilt_deg) {
  return {cut.pick.point,     cut.fraction,    tilt_deg,
          cut.wall.perimeter, cut.wall.center, cut.wall.normal};
}

}  // namespace vasorod
