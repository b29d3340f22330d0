#include "surgery/glenn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "rod/split_rod.h"
#include "surgery/cut.h"
#include "surgery/edited_vessel.h"
#include "surgery/ellipse.h"
#include "surgery/incision.h"
#include "surgery/incision_place.h"
#include "surgery/join.h"
#include "surgery/pose.h"
#include "surgery/vein_rotation.h"

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

// A pick on a vessel: rod coordinates, rest frame of the section and mid-wall radius.
struct Pick {
  RodCoordinates at;
  Pose section;
  double radius = 0;
};

// A pick may lie up to one radius off its vessel's surface.
Pick locate(const std::string& where, const char* what, const PreparedVessel& vessel,
            const Vec3& point) {
  const RodTree& rod = vessel.vessel.rod;
  Pick pick;
  pick.at = project(rod, point);
  pick.section = frame_at(rod, rod.rest, pick.at.element, pick.at.s);
  pick.radius = rod.radius[index(rod.elements[index(pick.at.element)].first)];
  const double distance = (ClosestPoint(vessel.vessel.surface).query(point).point - point).norm();
  if (distance > pick.radius) {
    throw InputError(joined_text(where, ": ", what, ": found a point ", place_text(point),
                                 " that is ", distance, " off vessel ", vessel.spec.name,
                                 ", expected at most its radius there, ", pick.radius));
  }
  return pick;
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
VesselConditions kept_conditions(const VesselConditions& before, const RodPart& kept,
                                 const std::vector<int>& end_now, int kept_node) {
  VesselConditions now;
  now.acts = true;
  for (RodSupport support : before.rod.supports) {
    support.node = kept.node_of[index(support.node)];
    if (support.node >= 0) now.rod.supports.push_back(support);
  }
  for (RodLoad load : before.rod.loads) {
    load.node = kept.node_of[index(load.node)];
    if (load.node >= 0) now.rod.loads.push_back(load);
  }
  for (ConditionedEnd end : before.ends) {
    end.end = end_now[index(end.end)];
    if (end.end >= 0) now.ends.push_back(end);
  }
  const bool held =
      std::any_of(now.rod.supports.begin(), now.rod.supports.end(),
                  [&](const RodSupport& support) { return support.node == kept_node; });
  if (!held) now.rod.supports.push_back(clamp(kept_node));
  return now;
}

Stage stage(const std::string& title, const PreparedVessel& svc, const PreparedVessel& rpa) {
  return {title, {svc.vessel.surface, rpa.vessel.surface}, {svc.spec.name, rpa.spec.name}};
}

// Step 1: the section's plane cuts the surface and splits the rod; the part with the kept end
// remains.
void cut(const std::string& where, const GlennSpec& spec, PreparedVessel& svc,
         VesselConditions& conditions, GlennOperation& operation) {
  const Pick pick = locate(where, "cut", svc, spec.cut);
  const int kept_end =
      find_end(svc.vessel, {EndSelector::Kind::near, spec.keep_near, 0}, where + ": keep");
  CutOutcome outcome = placed(where, [&] {
    return cut_vessel(svc.vessel.surface, pick.section, spec.cut,
                      svc.vessel.ends[index(kept_end)].center);
  });
  const int far_node = svc.vessel.ends[index(kept_end)].node;
  const RodSide side = side_of(svc.vessel.rod, pick.at.element, pick.at.s, far_node);
  const RodPart kept = cut_rod(svc.vessel.rod, pick.at.element, pick.at.s, side);
  const int kept_node = kept.node_of[index(far_node)];
  const double total =
      std::accumulate(svc.vessel.rod.elements.begin(), svc.vessel.rod.elements.end(), 0.0,
                      [](double sum, const RodElement& element) { return sum + element.length; });
  operation.report.cut.fraction = path_length(kept.tree, kept_node, kept.cut_node) / total;
  operation.report.cut.perimeter = outcome.perimeter;
  operation.report.cut.point = outcome.center;
  operation.report.cut.normal = outcome.normal;
  operation.mouth_node = kept.cut_node;
  operation.mouth_is_branch_end = side == RodSide::towards_root;
  operation.stump = std::move(outcome.stump);

  const auto end_now = follow_edit(svc, outcome.kept, outcome.kept_sources);
  for (VesselEnd& end : svc.vessel.ends) end.node = kept.node_of[index(end.node)];
  svc.vessel.ends.push_back({outcome.mouth, outcome.center, outcome.normal, kept.cut_node});
  conditions = kept_conditions(conditions, kept, end_now, kept_node);
  svc.vessel.rod = kept.tree;
  svc.vessel.branch_of.clear();  // bind_again() finds the remaining branches
  svc.node_thickness.assign(kept.tree.rest.size(), svc.thickness());
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

// Step 2: opens the recipient along its rod. A slit has half the mouth's perimeter, times the
// scene's factor.
IncisionOutcome incise(const std::string& where, const GlennSpec& spec, const Pick& pick,
                       PreparedVessel& rpa, GlennReport& report) {
  const Vessel& wall = rpa.vessel;
  const double perimeter = report.cut.perimeter;
  const IncisionOutcome incision = placed(where, [&] {
    if (!spec.ellipse)
      return open_incision(wall.surface, wall.rod, wall.binding, wall.branch_of, spec.incision,
                           spec.incision_length * perimeter / 2, pick.radius, perimeter / 2);
    const auto [length, width] = ellipse_size(spec, perimeter, pick.radius);
    return open_ellipse(wall.surface, wall.rod, wall.binding, wall.branch_of, spec.incision, length,
                        width, pick.radius);
  });
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
  const Pick pick = locate(where, "incision", rpa, spec.incision);  // before any change

  options.progress("cut");
  cut(where, spec, svc, svc_conditions, operation);
  operation.stages.push_back(stage("cut", svc, rpa));

  options.progress("incision");
  const double mouth_radius = operation.report.cut.perimeter / (2 * M_PI);
  const Vec3 outward = outward_normal(rpa.vessel.surface, spec.incision, mouth_radius);
  const IncisionOutcome incision = incise(where, spec, pick, rpa, operation.report);
  operation.stages.push_back(stage("incision", svc, rpa));

  // Step 3: the mouth's pose, the rotation with the least twist, and the pairs of the seam.
  options.progress("pose of the vein");
  // At angle 0 the mouth's section has the smallest rotation from rest that aligns its axis.
  Pose mouth = mouth_pose(incision.pick, outward, pick.section.director(3), 0,
                          operation.mouth_is_branch_end);
  const Pose& at_rest = svc.vessel.rod.rest[index(operation.mouth_node)];
  operation.report.join.axis_turn_deg =
      std::acos(std::clamp(at_rest.director(3).dot(mouth.director(3)), -1.0, 1.0)) * (180 / M_PI);
  mouth.rotation = Eigen::Quaterniond::FromTwoVectors(at_rest.director(3), mouth.director(3))
                       .toRotationMatrix() *
                   at_rest.rotation;
  VeinRotation rotation(svc.vessel.rod, svc_conditions.rod, operation.mouth_node, mouth, outward,
                        options.rod);
  const double angle = rotation.find() + spec.rotation_deg.value_or(0) * (M_PI / 180);
  operation.vein = rotation.at(angle);
  operation.report.join.rotation_deg = angle * (180 / M_PI);
  svc_conditions.rod = rotation.conditions_at(angle);

  options.progress("seam");
  const std::vector<int> loop = svc.vessel.ends.back().loop;
  const Points carried = carried_points(svc.vessel.rod, operation.vein.poses, svc.vessel.binding);
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
