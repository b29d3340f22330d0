#include "surgery/end_to_end.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "geometry/loops.h"
#include "surgery/meeting.h"
#include "surgery/sewing.h"
#include "surgery/tilted_cut.h"
#include "surgery/vessel_cut.h"

namespace vasorod {
namespace {

// A rim before the join: of a cut, or an end of the vessel.
struct Rim {
  std::optional<VesselCut> cut;
  int end = -1;  // of a whole vessel
  RimRod rod;
  CutReport report;
};

// Orthonormal axes, the third along the normal.
Pose rim_pose(const Vec3& center, const Vec3& normal) {
  const Vec3 d3 = normal.normalized(), d1 = d3.unitOrthogonal();
  Pose pose;
  pose.position = center;
  pose.rotation << d1, d3.cross(d1), d3;
  return pose;
}

double loop_length(const TriangleSurface& surface, const std::vector<int>& loop) {
  Points points(static_cast<Eigen::Index>(loop.size()), 3);
  for (size_t k = 0; k < loop.size(); ++k)
    points.row(static_cast<Eigen::Index>(k)) = surface.points.row(loop[k]);
  return LoopCurve(points).length();
}

// The axis in the section about which the cut's normal turns away from the picked point.
Vec3 tilt_axis(const std::string& where, const VesselCut& cut) {
  const Vec3 normal = cut.wall.normal, point = cut.pick.point;
  Vec3 aside = point - cut.wall.center;
  aside -= aside.dot(normal) * normal;
  constexpr double least = 0.1;
  if (!(aside.norm() > least * cut.pick.radius))
    throw InputError(joined_text(where, ": cut: found a point ", place_text(point), " that is ",
                                 aside.norm(), " off the vessel's middle, expected at least ",
                                 least * cut.pick.radius,
                                 ", as cut_tilt_deg turns the cut away from that side"));
  return aside.normalized().cross(normal);
}

Rim cut_rim(const std::string& where, const RimSpec& spec, const VesselToJoin& mine) {
  const PreparedVessel& vessel = mine.vessel;
  Rim rim;
  placed(where, [&] { check_tilt(spec.cut_tilt_deg); });
  VesselCut& cut = rim.cut.emplace(cut_across(where, vessel, *spec.cut, spec.keep));
  if (spec.cut_tilt_deg != 0) {
    const CutTilt tilt{spec.cut_tilt_deg, tilt_axis(where, cut)};
    cut.wall = placed(where, [&] {
      return cut_obliquely(vessel.vessel.surface, vessel.vessel.branch_of, cut.pick.section, tilt,
                           cut.pick.point, cut.kept_center);
    });
  }
  rim.rod.rod = &cut.kept.tree;
  rim.rod.held = kept_conditions(mine.conditions.rod, cut);
  rim.rod.node = cut.kept.cut_node;
  rim.rod.rim = rim_pose(cut.wall.center, cut.wall.normal);
  rim.report = report_of(cut, spec.cut_tilt_deg);
  return rim;
}

Rim end_rim(const std::string& where, const RimSpec& spec, const VesselToJoin& mine) {
  const Vessel& vessel = mine.vessel.vessel;
  Rim rim;
  rim.end = find_end(vessel, spec.end, where);
  for (const ConditionedEnd& other : mine.conditions.ends)
    if (other.end == rim.end)
      throw InputError(where + ": end: found " + to_string(spec.end) + " of " + spec.vessel +
                       ", the end that ends names as " + other.label +
                       ", expected an end without a condition, as the seam holds it");
  const VesselEnd& end = vessel.ends[index(rim.end)];
  rim.rod.rod = &vessel.rod;
  rim.rod.held = mine.conditions.rod;
  rim.rod.node = end.node;
  rim.rod.rim = rim_pose(end.center, end.outward);
  if (rim.rod.held.supports.empty())
    for (const VesselEnd& other : vessel.ends)
      if (other.node != end.node) rim.rod.held.supports.push_back(clamp(other.node));
  rim.report = {end.center, 1, 0, loop_length(vessel.surface, end.loop), end.center, end.outward};
  return rim;
}

void require_like_perimeters(const std::string& where, const EndToEndSpec& spec,
                             const std::array<Rim, 2>& rims) {
  const double first = rims[0].report.perimeter, second = rims[1].report.perimeter;
  if (std::max(first, second) <= largest_perimeter_ratio * std::min(first, second)) return;
  const size_t narrow = first < second ? 0 : 1;
  throw InputError(joined_text(where, ": rims: found perimeters of ", first, " (",
                               spec.rims[0].vessel, ") and ", second, " (", spec.rims[1].vessel,
                               "), expected one at most ", largest_perimeter_ratio,
                               " times the other; an oblique cut of ", spec.rims[narrow].vessel,
                               " (cut_tilt_deg) has a longer rim"));
}

// Makes the vessel the part that is joined, and returns the rim's loop.
std::vector<int> take(Rim& rim, const RodConditions& conditions, const VesselToJoin& mine,
                      OperatedVessel& joined) {
  joined.rim_node = rim.rod.node;
  if (rim.cut) {
    keep_part(*rim.cut, conditions, mine.vessel, mine.conditions);
    joined.stump = std::move(rim.cut->wall.stump);
    return mine.vessel.vessel.ends.back().loop;
  }
  mine.conditions.rod = conditions;
  mine.conditions.acts = true;
  return mine.vessel.vessel.ends[index(rim.end)].loop;
}

// The radius of the lumen at the rim, by which one vessel is narrower than another.
double lumen_radius(const Rim& rim, const PreparedVessel& vessel) {
  return rim.rod.rod->radius[index(rim.rod.node)] - vessel.thickness() / 2;
}

}  // namespace

Operation join_end_to_end(const Scene& scene, const EndToEndSpec& spec,
                          const std::array<VesselToJoin, 2>& vessels,
                          const OperationOptions& options) {
  const std::string where = place_in(scene, spec.line);
  options.progress("rims");
  std::array<Rim, 2> rims;
  for (size_t k = 0; k < 2; ++k) {
    const std::string place = place_in(scene, spec.rims[k].line);
    rims[k] = spec.rims[k].cut ? cut_rim(place, spec.rims[k], vessels[k])
                               : end_rim(place, spec.rims[k], vessels[k]);
    rims[k].rod.radius = rims[k].report.perimeter / (2 * M_PI);
    if (rims[k].cut) rims[k].rod.rod = &rims[k].cut->kept.tree;  // where it is now
  }
  require_like_perimeters(where, spec, rims);

  options.progress("pose of the rims");
  std::optional<double> rotation;
  if (spec.rotation_deg) rotation = *spec.rotation_deg * (M_PI / 180);
  Meeting meeting = placed(where, [&] {
    return meet({rims[0].rod, rims[1].rod}, rotation, options.rod);
  });

  Operation operation;
  EndToEndReport& report = operation.end_to_end.emplace();
  report.join.rotation_deg = meeting.rotation * (180 / M_PI);
  report.join.axis_turn_deg = meeting.axis_turn * (180 / M_PI);
  constexpr double alike = 1 + 1e-9;
  report.narrower =
      lumen_radius(rims[0], vessels[0].vessel) <= alike * lumen_radius(rims[1], vessels[1].vessel)
          ? 0
          : 1;
  std::array<std::vector<int>, 2> loops;
  std::array<Points, 2> starts;
  for (size_t k = 0; k < 2; ++k) {
    report.rims[k] = {spec.rims[k].vessel, rims[k].report};
    operation.vessels[k].name = spec.rims[k].vessel;
    loops[k] = take(rims[k], meeting.conditions[k], vessels[k], operation.vessels[k]);
    starts[k] = carried_rim(vessels[k].vessel, meeting.rods[k].poses, loops[k]);
    operation.vessels[k].rod = std::move(meeting.rods[k]);
  }
  operation.stages.push_back(stage_of("rims", vessels[0].vessel, vessels[1].vessel));

  options.progress("seam");
  const JoinOutcome seam = placed(where, [&] {
    return match_seam(vessels[0].vessel.vessel.surface, loops[0], starts[0],
                      vessels[1].vessel.vessel.surface, loops[1], starts[1]);
  });
  operation.pairs = seam.pairs;
  sew(seam, vessels[0].vessel, vessels[1].vessel);
  return operation;
}

}  // namespace vasorod
