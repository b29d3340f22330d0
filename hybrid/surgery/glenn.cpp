#include "surgery/glenn.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "surgery/edited_vessel.h"
#include "surgery/ellipse.h"
#include "surgery/incision.h"
#include "surgery/incision_place.h"
#include "surgery/mouth_place.h"
#include "surgery/pick_place.h"
#include "surgery/sewing.h"
#include "surgery/tilted_cut.h"
#include "surgery/vessel_cut.h"

namespace vasorod {
namespace {

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

Operation operate(const Scene& scene, const GlennSpec& spec, PreparedVessel& svc,
                  PreparedVessel& rpa, VesselConditions& svc_conditions,
                  const OperationOptions& options) {
  const std::string where = place_in(scene, spec.line);
  Operation operation;
  GlennReport& report = operation.glenn.emplace();
  report.svc = operation.vessels[0].name = svc.spec.name;
  report.rpa = operation.vessels[1].name = rpa.spec.name;
  const PickPlace pick =
      place_incision_pick(where + ": incision", spec.incision, rpa);  // before any change
  placed(where, [&] { check_tilt(spec.cut_tilt_deg); });

  // Step 1: the section's plane cuts the vein; the part with the kept end remains.
  options.progress("cut");
  VesselCut vein = cut_across(where, svc, spec.cut, spec.keep);
  options.progress("pose of the vein");
  const MouthPlace place = place_mouth(
      spec, pick.point, vein.kept, vein.side, kept_conditions(svc_conditions.rod, vein),
      vein.wall.perimeter / (2 * M_PI), rpa.vessel.surface, pick.section.director(3), options.rod);
  if (place.tilt.degrees != 0)
    vein.wall = placed(where, [&] {
      return cut_obliquely(svc.vessel.surface, svc.vessel.branch_of, vein.pick.section, place.tilt,
                           vein.pick.point, vein.kept_center);
    });
  report.cut = report_of(vein, place.tilt.degrees);
  report.join.rotation_deg = place.rotation * (180 / M_PI);
  report.join.axis_turn_deg = place.axis_turn * (180 / M_PI);
  keep_part(vein, place.conditions, svc, svc_conditions);
  operation.vessels[0].rod = place.vein;
  operation.vessels[0].rim_node = vein.kept.cut_node;
  operation.vessels[0].stump = std::move(vein.wall.stump);
  operation.stages.push_back(stage_of("cut", svc, rpa));

  options.progress("incision");
  const IncisionOutcome incision = incise(where, spec, pick, rpa, report);
  operation.stages.push_back(stage_of("incision", svc, rpa));

  // Step 3: the pairs of the seam.
  options.progress("seam");
  const std::vector<int> loop = svc.vessel.ends.back().loop;
  const JoinOutcome seam = placed(where, [&] {
    return match_seam(svc.vessel.surface, loop, carried_rim(svc, place.vein.poses, loop),
                      rpa.vessel.surface, incision.rim, incision.other_tip);
  });
  operation.pairs = seam.pairs;
  sew(seam, svc, rpa);
  return operation;
}

}  // namespace vasorod
