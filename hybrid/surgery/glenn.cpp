#include "surgery/glenn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "rod/split_rod.h"
#include "surgery/cut.h"
#include "surgery/edited_vessel.h"
#include "surgery/ellipse.h"
#include "surgery/incision.h"
#include "surgery/incision_place.h"
#include "surgery/join.h"
#include "surgery/mouth_place.h"
#include "surgery/pick_place.h"
#include "surgery/tilted_cut.h"

namespace vasorod {
namespace {

// Adds the place in the scene to the error of a part that does not know the scene.
template <class Work>
auto placed(const std::string& where, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(where + ": " + error.what());
  }
}

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

// The conditions of the kept rod: those at remaining nodes, and a clamp at the kept far end if the
// scene has no entry for it.
RodConditions kept_conditions(const RodConditions& before, const RodPart& kept, int kept_node) {
  RodConditions now;
  for (RodSupport support : before.supports) {
    support.node = kept.node_of[index(support.node)];
    if (support.node >= 0) now.supports.push_back(support);
  }
  for (RodLoad load : before.loads) {
    load.node = kept.node_of[index(load.node)];
    if (load.node >= 0) now.loads.push_back(load);
  }
  const bool held =
      std::any_of(now.supports.begin(), now.supports.end(),
                  [&](const RodSupport& support) { return support.node == kept_node; });
  if (!held) now.supports.push_back(clamp(kept_node));
  return now;
}

Stage stage(const std::string& title, const PreparedVessel& svc, const PreparedVessel& rpa) {
  return {title, {svc.vessel.surface, rpa.vessel.surface}, {svc.spec.name, rpa.spec.name}};
}

// The vein's rod and wall, cut at the pick's section.
struct VeinCut {
  PickPlace pick;
  int kept_node = 0;                // node of the kept end in the kept rod
  Vec3 kept_center = Vec3::Zero();  // of the kept end
  RodSide side = RodSide::towards_root;
  RodPart kept;
  double fraction = 0;  // kept length over that of the way along the vein
  CutOutcome wall;
};

VeinCut cut_straight(const std::string& where, const GlennSpec& spec, const PreparedVessel& svc) {
  VeinCut cut;
  const int kept_end = find_end(svc.vessel, spec.keep, where + ": keep");
  cut.pick = place_cut(where + ": cut", spec.cut, svc, kept_end);
  cut.kept_center = svc.vessel.ends[index(kept_end)].center;
  cut.wall = placed(where, [&] {
    return cut_vessel(svc.vessel.surface, cut.pick.section, cut.pick.point, cut.kept_center);
  });
  const RodTree& rod = svc.vessel.rod;
  const int far_node = svc.vessel.ends[index(kept_end)].node;
  const AxisPlace& at = cut.pick.at;
  cut.side = side_of(rod, at.element, at.s, far_node);
  cut.kept = cut_rod(rod, at.element, at.s, cut.side);
  cut.kept_node = cut.kept.node_of[index(far_node)];
  cut.fraction = path_length(cut.kept.tree, cut.kept_node, cut.kept.cut_node) /
                 pick_route(where + ": cut", spec.cut, svc.vessel, kept_end).length();
  return cut;
}

// Step 1: the section's plane cuts the surface; the part with the kept end remains.
void take_cut(VeinCut&& cut, const MouthPlace& place, PreparedVessel& svc,
              VesselConditions& conditions, GlennOperation& operation) {
  operation.report.cut.pick = cut.pick.point;
  operation.report.cut.fraction = cut.fraction;
  operation.report.cut.tilt_deg = place.tilt.degrees;
  operation.report.cut.perimeter = cut.wall.perimeter;
  operation.report.cut.point = cut.wall.center;
  operation.report.cut.normal = cut.wall.normal;
  operation.report.join.rotation_deg = place.rotation * (180 / M_PI);
  operation.report.join.axis_turn_deg = place.axis_turn * (180 / M_PI);
  operation.mouth_node = cut.kept.cut_node;
  operation.mouth_is_branch_end = cut.side == RodSide::towards_root;
  operation.stump = std::move(cut.wall.stump);
  operation.vein = place.vein;

  const auto end_now = follow_edit(svc, cut.wall.kept, cut.wall.kept_sources);
  for (VesselEnd& end : svc.vessel.ends) end.node = cut.kept.node_of[index(end.node)];
  svc.vessel.ends.push_back({cut.wall.mouth, cut.wall.center, cut.wall.normal, cut.kept.cut_node});
  VesselConditions now;
  now.acts = true;
  now.rod = place.conditions;
  for (ConditionedEnd end : conditions.ends) {
    end.end = end_now[index(end.end)];
    if (end.end >= 0) now.ends.push_back(end);
  }
  conditions = std::move(now);
  svc.vessel.rod = cut.kept.tree;
  svc.vessel.branch_of.clear();  // bind_again() finds the remaining branches
  svc.node_thickness.assign(cut.kept.tree.rest.size(), svc.thickness());
  bind_again(svc);
}

// The ellipse that the scene asks for, on a vessel of that radius.
std::array<double, 2> ellipse_size(const GlennSpec& spec, double mouth_perimeter, double radius) {
  const IncisionEllipse& ellipse = *spec.ellipse;
  const double rim = spec.incision_length * mouth_perimeter;
  double length = 0, width = 0;
  if (ellipse.length) {
    length = *ellipse.length;
    width = ellipse.width ? *ellipse.width : ellipse.ratio * length;
  } else if (ellipse.width) {
    width = *ellipse.width;
    if (!(M_PI * width <= rim))
      throw InputError(joined_text("incision_shape: found an ellipse ", width,
                                   " wide whose rim is to be ", rim,
                                   " long, expected at most the circle's width of ",
                                   rounded_down(rim / M_PI), ", or a length beside the width"));
    length = ellipse_length(rim, width);
  } else {
    length = rim / ellipse_perimeter(1, ellipse.ratio);
    width = ellipse.ratio * length;
  }
  if (!(width <= 2 * radius))
    throw InputError(joined_text("incision_shape: found an ellipse ", width,
                                 " wide on the wall of ", spec.rpa, ", expected at most its ",
                                 "diameter there, ", rounded_down(2 * radius)));
  return {length, width};
}

IncisionOutcome opened(const GlennSpec& spec, const Vec3& point, double radius, double perimeter,
                       const Vessel& wall) {
  if (!spec.ellipse)
    return open_incision(wall.surface, wall.rod, wall.binding, wall.branch_of, point,
                         spec.incision_length * perimeter / 2, radius, perimeter / 2);
  const auto [length, width] = ellipse_size(spec, perimeter, radius);
  return open_ellipse(wall.surface, wall.rod, wall.binding, wall.branch_of, point, length, width,
                      radius);
}

// A way along the artery that leads past the pick: the scene's where it does, else one from
// `start`.
AxisRoute route_past(const std::string& where, const GlennSpec& spec, const PickPlace& pick,
                     const Vessel& wall) {
  AxisRoute route = pick_route(where, spec.incision, wall, 0);
  for (size_t k = 1; k < wall.ends.size() && !route.distance_to(pick.at); ++k)
    route = AxisRoute(wall.rod, wall.ends[0].node, wall.ends[k].node);
  return route;
}

// Where beside the pick the opening fits, as the end of a message; nothing where it fits nowhere.
std::string where_it_fits(const std::string& where, const GlennSpec& spec, const PickPlace& pick,
                          double perimeter, const Vessel& wall) {
  const AxisRoute route = route_past(where, spec, pick, wall);
  const double half = spec.incision_length * perimeter / 2;
  const auto moved = moved_pick(wall, pick, route, half + pick.radius, [&](const Vec3& point) {
    try {
      opened(spec, point, pick.radius, perimeter, wall);
    } catch (const InputError&) {
      return false;
    }
    return true;
  });
  if (!moved) return {};
  // Without the rounding errors of zero.
  const Vec3 to =
      moved->point.unaryExpr([&](double x) { return std::abs(x) < 1e-6 * pick.radius ? 0.0 : x; });
  return "; moved by " + number_text(moved->by, 3) + " along the vessel, to " +
         (spec.incision.along ? "along: " + number_text(moved->fraction, 4) + " at "
                              : std::string()) +
         place_text(to, 4) + ", it fits";
}

// Step 2: opens the recipient along its rod. A slit has half the mouth's perimeter, times the
// scene's factor.
IncisionOutcome incise(const std::string& where, const GlennSpec& spec, const PickPlace& pick,
                       PreparedVessel& rpa, GlennReport& report) {
  const double perimeter = report.cut.perimeter;
  IncisionOutcome incision = placed(where, [&] {
    try {
      return opened(spec, pick.point, pick.radius, perimeter, rpa.vessel);
    } catch (const InputError& error) {
      throw InputError(error.what() + where_it_fits(where, spec, pick, perimeter, rpa.vessel));
    }
  });
  report.incision.pick = incision.pick;
  report.incision.along = pick.fraction.value_or(std::numeric_limits<double>::quiet_NaN());
  report.incision.around_deg = pick.angle * (180 / M_PI);
  if (spec.ellipse) report.incision.shape = "ellipse";
  report.incision.length = incision.length;
  report.incision.width = incision.width;
  report.incision.perimeter = incision.perimeter;
  report.incision.perimeter_ratio = incision.perimeter / perimeter;
  report.incision.removed_area = incision.removed_area;
  report.incision.ends = {incision.surface.points.row(incision.rim.front()),
                          incision.surface.points.row(incision.rim[index(incision.other_tip)])};
  follow_edit(rpa, incision.surface, incision.sources);
  return incision;
}

}  // namespace

GlennOperation operate(const Scene& scene, const GlennSpec& spec, PreparedVessel& svc,
                       PreparedVessel& rpa, VesselConditions& svc_conditions,
                       const GlennOptions& options) {
  const std::string where = place_in(scene, spec.line);
  GlennOperation operation;
  operation.report.svc = svc.spec.name;
  operation.report.rpa = rpa.spec.name;
  const PickPlace pick =
      place_incision_pick(where + ": incision", spec.incision, rpa);  // before any change
  placed(where, [&] { check_tilt(spec.cut_tilt_deg); });

  options.progress("cut");
  VeinCut vein = cut_straight(where, spec, svc);
  options.progress("pose of the vein");
  const MouthPlace place = place_mouth(
      spec, pick.point, vein.kept, vein.side,
      kept_conditions(svc_conditions.rod, vein.kept, vein.kept_node),
      vein.wall.perimeter / (2 * M_PI), rpa.vessel.surface, pick.section.director(3), options.rod);
  if (place.tilt.degrees != 0)
    vein.wall = placed(where, [&] {
      return cut_obliquely(svc.vessel.surface, svc.vessel.branch_of, vein.pick.section, place.tilt,
                           vein.pick.point, vein.kept_center);
    });
  take_cut(std::move(vein), place, svc, svc_conditions, operation);
  operation.stages.push_back(stage("cut", svc, rpa));

  options.progress("incision");
  const IncisionOutcome incision = incise(where, spec, pick, rpa, operation.report);
  operation.stages.push_back(stage("incision", svc, rpa));

  // Step 3: the pairs of the seam.
  options.progress("seam");
  const std::vector<int> loop = svc.vessel.ends.back().loop;
  const Points carried = carried_points(svc.vessel.rod, operation.vein.poses, svc.vessel.carry);
  Points mouth_start(static_cast<Eigen::Index>(loop.size()), 3);
  for (size_t k = 0; k < loop.size(); ++k)
    mouth_start.row(static_cast<Eigen::Index>(k)) = carried.row(loop[k]);
  const JoinOutcome seam = placed(where, [&] {
    return match_seam(svc.vessel.surface, loop, mouth_start, rpa.vessel.surface, incision.rim,
                      incision.other_tip);
  });
  operation.pairs = seam.pairs;
  follow_edit(svc, seam.svc, seam.svc_sources);
  follow_edit(rpa, seam.rpa, seam.rpa_sources);
  bind_again(svc);
  bind_again(rpa);
  return operation;
}

}  // namespace vasorod
