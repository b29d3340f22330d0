#include "predict/vessel_wall.h"

#include <algorithm>

#include "data/index.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
WallInput wall_of(const PreparedVessel& prepared) {
  const Vessel& vessel = prepared.vessel;
  WallInput wall;
  wall.name = "vessel " + prepared.spec.name;
  wall.rest = vessel.surface;
  wall.mid_offset = prepared.mid_offset();
  wall.material = prepared.spec.wall->material;
  wall.prestress_displacement = prepared.prestress_displacement;
  wall.from_stress_free_shape = prepared.from_stress_free_shape;
  wall.axial_prestretch = prepared.spec.axial_prestretch;
  const auto vertices = vessel.surface.points.rows();
  wall.thickness.resize(vertices);
  std::vector<Vec3> tangent;
  for (Eigen::Index i = 0; i < vertices; ++i) {
    const RodCoordinates& at = vessel.binding[index(i)];
    const RodElement& element = vessel.rod.elements[index(at.element)];
    const double share = std::clamp(at.s / element.length, 0.0, 1.0);
    wall.thickness[i] = (1 - share) * prepared.node_thickness[index(element.first)] +
                        share * prepared.node_thickness[index(element.second)];
    tangent.push_back(frame_at(vessel.rod, vessel.rod.rest, at.element, at.s).director(3));
  }
  const Triangles& triangles = vessel.surface.triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    wall.axis.push_back(tangent[index(triangles(t, 0))] + tangent[index(triangles(t, 1))] +
                        tangent[index(triangles(t, 2))]);
  return wall;
}

VesselSections sections_of(const Vessel& vessel, const VesselConditions& conditions, int left_out) {
  VesselSections all;
  for (size_t e = 0; e < vessel.ends.size(); ++e) {
    const VesselEnd& end = vessel.ends[e];
    if (end.node == left_out) continue;
    HeldSection section;
    section.fixed.fill(false);
    bool named = false;
    for (const RodSupport& support : conditions.rod.supports) {
      if (support.node != end.node) continue;
      section.fixed = support.fixed;
      section.frame = support.frame;
      section.motion = support.motion;
      named = true;
    }
    for (const RodLoad& load : conditions.rod.loads) {
      if (load.node != end.node) continue;
      section.force += load.force;
      (load.moment_in_body ? section.body_moment : section.moment) += load.moment;
      named = true;
    }
    if (!named) continue;
    section.ring = end.loop;
    section.rest = vessel.rod.rest[index(end.node)];
    for (const ConditionedEnd& conditioned : conditions.ends)
      if (conditioned.end == static_cast<int>(e)) {
        section.label = conditioned.label;
        section.rigid = conditioned.rigid;
      }
    all.sections.push_back(std::move(section));
    all.nodes.push_back(end.node);
  }
  return all;
}

ScanDisplacement displacement_of_scan(const PreparedVessel& prepared,
                                      const VesselConditions& conditions, bool whole,
                                      double largest_linear, const std::function<bool()>& stop) {
  const double pressure = prepared.spec.pressure ? prepared.spec.pressure->scan : 0;
  if (pressure == 0 && prepared.spec.axial_prestretch == 1) return {};
  const Vessel& vessel = prepared.vessel;
  std::vector<HeldSection> sections = sections_of(vessel, conditions, -1).sections;
  const bool none = sections.empty();
  for (const VesselEnd& end : vessel.ends) {
    const bool named =
        std::any_of(sections.begin(), sections.end(),
                    [&](const HeldSection& section) { return section.ring == end.loop; });
    if (named || !(whole || none)) continue;
    HeldSection section;
    section.ring = end.loop;
    section.rest = vessel.rod.rest[index(end.node)];
    sections.push_back(std::move(section));
  }
  return scan_displacement(wall_of(prepared), std::move(sections), pressure, largest_linear, stop);
}

RodPoses share_of_strain(const RodTree& rod, const RodPoses& poses, double share) {
  RodPoses partly = rod.rest;
  partly[0] = interpolate(rod.rest[0], poses[0], share);
  for (const RodBranch& branch : rod.branches)
    for (const int e : branch.elements) {
      const RodElement& element = rod.elements[index(e)];
      const auto first = index(element.first), second = index(element.second);
      const Vec6 rest = log_motion(rod.rest[first].inverse() * rod.rest[second]),
                 now = log_motion(poses[first].inverse() * poses[second]);
      partly[second] = partly[first] * exp_motion(rest + share * (now - rest));
    }
  return partly;
}

}  // namespace vasorod
