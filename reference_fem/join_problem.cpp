#include "reference_fem/join_problem.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <vasorod/error.h>

namespace vasorod::fem {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double equal = 1e-9;  // dimensionless lengths and directions of a symmetric scene

[[noreturn]] void refuse(const Scene& scene, const std::string& found) {
  throw InputError(scene.file.string() + ": found " + found +
                   "; the finite-element reference joins two straight generated tubes (`tube:`), " +
                   (scene.glenn ? "the vein's axis on the incision's normal, "
                                : "cut across or by an end, with a number as `rotation_deg`, ") +
                   "without contact (`contact: []`)");
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string in_quotes(const std::string& text) {
  return "\"" + text + "\"";
}

void require_tube(const Scene& scene, const VesselSpec& vessel) {
  const std::string name = in_quotes(vessel.name);
  if (vessel.role == Role::obstacle) refuse(scene, "the obstacle " + name);
  if (!vessel.tube) refuse(scene, "the surface of " + name);
  if (vessel.tube->bend_deg != 0) refuse(scene, "the bent tube " + name);
}

/// Held when the vessel was seen: the ends with a condition; both where an operation opens the
/// vessel across, or no end has one.
std::vector<EndProblem> held_when_seen(const std::vector<EndProblem>& ends, bool opened) {
  std::vector<EndProblem> held = ends;
  for (const int side : {0, 1}) {
    const bool named = std::any_of(ends.begin(), ends.end(),
                                   [&](const EndProblem& end) { return end.side == side; });
    if (named || !(opened || ends.empty())) continue;
    held.emplace_back();
    held.back().side = side;
  }
  return held;
}

/// `opened`: across, by a cut or at an end that is joined.
JoinWall wall_of(const Scene& scene, const VesselSpec& vessel, const ProblemUnits& units,
                 std::optional<LawKind> law, bool opened) {
  JoinWall wall;
  wall.name = vessel.name;
  wall.shape = shape_of(vessel, units);
  wall.moduli = moduli_of(vessel.wall->material, units.stress);
  wall.law = law.value_or(law_of(vessel.wall->material));
  if (wall.law == LawKind::split_neo_hookean) refuse(scene, "the law split-neo-hookean");
  require_admissible(scene, wall.name, wall.law, wall.moduli);
  wall.ends = ends_of(scene, wall.name, wall.shape, units);
  wall.seen = seen_state(scene, vessel, units);
  wall.whole = wall.shape;
  wall.ends_when_seen = held_when_seen(wall.ends, opened);
  return wall;
}

void require_point(const Scene& scene, const PickSpec& pick) {
  if (pick.along) refuse(scene, "a pick by `along` where it takes points [x, y, z]");
}

/// Parameters of a pick on a tube, which may be at most a radius off its wall.
Vec3 locate(const Scene& scene, const char* what, const JoinWall& wall, const Vec3& pick,
            double unit) {
  Vec3 at = wall.shape.parameters(pick / unit);
  const double radius = wall.shape.radius_at(at[1]),
               off = std::abs(at[2] - 0.5) * wall.shape.thickness_at(at[1]);
  const double beyond = std::max({0.0, -at[1], at[1] - 1}) * wall.shape.length;
  if (std::hypot(off, beyond) > radius)
    throw InputError(scene.file.string() + (scene.glenn ? ": glenn: " : ": end_to_end: ") + what +
                     ": found a point " + number(unit * std::hypot(off, beyond)) + " off vessel " +
                     wall.name + ", expected at most its radius there, " + number(unit * radius));
  return at;
}

/// The part of a tube between two fractions of its axis.
TubeShape part(const TubeShape& tube, double from, double to) {
  TubeShape out = tube;
  out.length = (to - from) * tube.length;
  out.radius = tube.radius_at(from);
  out.end_radius = tube.radius_at(to);
  out.thickness = tube.thickness_at(from);
  out.end_thickness = tube.thickness_at(to);
  out.placement = tube.section(from);
  return out;
}

/// Keeps the part of a tube beyond the cut at a fraction of its axis, on the side of `keep`. Its
/// conditions at the stump's end go with the stump. The side of the rim is returned.
int cut_tube(const Scene& scene, double at, const EndSelector& keep, double unit, JoinWall& tube) {
  if (!(at > equal && at < 1 - equal)) refuse(scene, "a cut at an end of " + in_quotes(tube.name));
  const int kept_side = side_of(scene, tube.shape, keep, unit);
  tube.kept_from = kept_side == 0 ? 0 : at;
  tube.kept_to = kept_side == 0 ? at : 1;
  tube.shape = part(tube.shape, tube.kept_from, tube.kept_to);
  std::erase_if(tube.ends, [&](const EndProblem& end) { return end.side != kept_side; });
  return 1 - kept_side;
}

/// A kept end without a condition is held.
void hold_far_end(int rim_side, JoinWall& tube) {
  if (!tube.ends.empty()) return;
  EndProblem held;
  held.side = 1 - rim_side;
  held.fixed.fill(true);
  tube.ends.push_back(held);
}

/// Cuts the vein.
void cut(const Scene& scene, const GlennSpec& spec, JoinProblem& problem) {
  JoinWall& vein = problem.vein;
  const double unit = problem.units.length;
  const double at = locate(scene, "cut", vein, spec.cut.point, unit)[1];
  problem.seam_side = cut_tube(scene, at, spec.keep, unit, vein);
  problem.cut_fraction = problem.seam_side == 1 ? at : 1 - at;
  hold_far_end(problem.seam_side, vein);
}

void to_frame(const Pose& frame, JoinWall& wall) {
  wall.shape.placement = frame.inverse() * wall.shape.placement;
  wall.whole.placement = frame.inverse() * wall.whole.placement;
  const Mat3 turn = frame.rotation.transpose();
  for (EndProblem& end : wall.ends)
    for (Vec3 EndProblem::*vector :
         {&EndProblem::move, &EndProblem::rotation, &EndProblem::force, &EndProblem::moment})
      end.*vector = turn * end.*vector;
}

/// The angle of the tube's line in a direction at right angles to its axis, and the sense of the
/// angle that turns from it towards `next`.
void unroll_from(const Vec3& direction, const Vec3& next, JoinWall& wall) {
  const Mat3& d = wall.shape.placement.rotation;
  wall.first_angle = std::atan2(direction.dot(d.col(1)), direction.dot(d.col(0)));
  wall.turn = d.col(2).cross(direction).dot(next) > 0 ? 1 : -1;
}

double ellipse_perimeter(double length, double width) {
  const double longer = std::max(length, width), shorter = std::min(length, width);
  return 2 * longer * std::comp_ellint_2(std::sqrt(1 - std::pow(shorter / longer, 2)));
}

/// The scene's ellipse, {length, width} over the cut's radius. Its rim is `incision_length` times
/// the cut's unless the scene gives both axes.
std::array<double, 2> ellipse_of(const Scene& scene, const GlennSpec& spec, double unit) {
  const IncisionEllipse& ellipse = *spec.ellipse;
  const double rim = spec.incision_length * 2 * pi;
  if (ellipse.length) {
    const double length = *ellipse.length / unit;
    return {length, ellipse.width ? *ellipse.width / unit : ellipse.ratio * length};
  }
  if (!ellipse.width) {
    const double length = rim / ellipse_perimeter(1, ellipse.ratio);
    return {length, ellipse.ratio * length};
  }
  const double width = *ellipse.width / unit;
  if (!(pi * width <= rim))
    refuse(scene, "an ellipse " + number(width * unit) + " wide with a rim " + number(rim * unit) +
                      " long, which a circle exceeds");
  double least = width, most = rim / 2;  // of the length; the perimeter grows with it
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (least + most);
    (ellipse_perimeter(middle, width) < rim ? least : most) = middle;
  }
  return {0.5 * (least + most), width};
}

bool all_held(const JoinWall& wall) {
  return std::all_of(wall.ends.begin(), wall.ends.end(),
                     [](const EndProblem& end) { return end.held(); });
}

std::array<bool, 2> planes_of(const JoinProblem& problem) {
  const TubeShape &vein = problem.vein.shape, &artery = problem.artery.shape;
  const Vec3 axis = vein.placement.rotation.col(2), at = vein.placement.position;
  if (problem.rotation != 0 || !all_held(problem.vein) || !all_held(problem.artery))
    return {false, false};
  const bool even = std::abs(artery.end_radius - artery.radius) < equal &&
                    std::abs(artery.end_thickness - artery.thickness) < equal &&
                    std::abs(problem.incision.from + problem.incision.to - 1) < equal &&
                    problem.artery.ends.size() != 1;
  return {even && std::abs(axis[0]) < equal && std::abs(at[0]) < equal,
          std::abs(axis[1]) < equal && std::abs(at[1]) < equal};
}

JoinProblem read_glenn_join(const Scene& scene, std::optional<LawKind> law) {
  const GlennSpec& spec = *scene.glenn;
  const VesselSpec &vein = scene.vessel(spec.svc), &artery = scene.vessel(spec.rpa);
  if (spec.cut_tilt_deg != 0) refuse(scene, "an oblique cut (`cut_tilt_deg`)");
  require_point(scene, spec.cut);
  require_point(scene, spec.incision);

  JoinProblem problem;
  problem.cut_pick = spec.cut.point;
  problem.vein_first = scene.vessels.front().name == spec.svc;
  problem.units = {vein.tube->radius, vein.wall->material.young_axial};
  problem.vein = wall_of(scene, vein, problem.units, law, true);
  const Vec3 cut_at = locate(scene, "cut", problem.vein, spec.cut.point, problem.units.length);
  problem.units.length *= problem.vein.shape.radius_at(cut_at[1]);
  problem.vein = wall_of(scene, vein, problem.units, law, true);
  problem.artery = wall_of(scene, artery, problem.units, law, false);
  cut(scene, spec, problem);

  const Vec3 pick =
      locate(scene, "incision", problem.artery, spec.incision.point, problem.units.length);
  const TubeShape& wall = problem.artery.shape;
  problem.incision.length = spec.incision_length * pi;  // half the perimeter of the cut, radius 1
  problem.incision.perimeter = 2 * problem.incision.length;
  const double half =
      0.5 * problem.incision.length / std::hypot(wall.length, wall.end_radius - wall.radius);
  problem.incision.from = pick[1] - half;
  problem.incision.to = pick[1] + half;
  if (spec.ellipse) {
    const auto [length, width] = ellipse_of(scene, spec, problem.units.length);
    if (!(width <= 2 * wall.radius_at(pick[1])) || !open_ellipse(problem, length, width))
      refuse(scene, "an ellipse " + number(length * problem.units.length) + " long and " +
                        number(width * problem.units.length) +
                        " wide, which does not fit on the artery");
  } else if (problem.incision.from < equal || problem.incision.to > 1 - equal) {
    refuse(scene, "an incision of length " +
                      number(problem.incision.length * problem.units.length) +
                      " that runs into an end of the artery");
  }

  const Mat3 axes = wall.axes(pick);
  const Vec3 out = axes.col(0), along = axes.col(2);
  problem.frame.position = wall.point({pick[0], pick[1], 0.5});
  problem.frame.rotation << along, out.cross(along), out;
  const Vec3 axis =
      (problem.seam_side == 1 ? 1.0 : -1.0) * Vec3(problem.vein.shape.placement.rotation.col(2));
  problem.axis_turn = std::atan2(axis.cross(-out).norm(), -axis.dot(out));
  if (problem.axis_turn > 1e-3)
    refuse(scene, "an axis of the vein at " + number(problem.axis_turn * 180 / pi) +
                      " degrees to the incision's normal");
  to_frame(problem.frame, problem.vein);
  to_frame(problem.frame, problem.artery);
  std::vector<EndProblem> ends = problem.vein.ends;
  ends.insert(ends.end(), problem.artery.ends.begin(), problem.artery.ends.end());
  require_held(scene, ends, "the join");

  problem.rotation = spec.rotation_deg.value_or(0) * pi / 180;
  unroll_from(Vec3::UnitZ(), Vec3::UnitY(), problem.artery);
  // the rim's point that the rotation brings to the tip
  unroll_from({std::cos(problem.rotation), -std::sin(problem.rotation), 0},
              {std::sin(problem.rotation), std::cos(problem.rotation), 0}, problem.vein);
  problem.mirror = planes_of(problem);
  return problem;
}

/// The rim of a vessel that is joined end to end.
struct TubeRim {
  int side = 0;
  double fraction = 1;       // kept length over the tube's
  std::optional<Vec3> pick;  // of a cut, the scene's
};

TubeRim take_rim(const Scene& scene, const RimSpec& spec, double unit, JoinWall& tube) {
  TubeRim rim;
  if (spec.cut) {
    if (spec.cut_tilt_deg != 0) refuse(scene, "an oblique cut (`cut_tilt_deg`)");
    require_point(scene, *spec.cut);
    rim.pick = spec.cut->point;
    const double at = locate(scene, "cut", tube, spec.cut->point, unit)[1];
    rim.side = cut_tube(scene, at, spec.keep, unit, tube);
    rim.fraction = rim.side == 1 ? at : 1 - at;
  } else {
    rim.side = side_of(scene, tube.shape, spec.end, unit);
    for (const EndProblem& end : tube.ends)
      if (end.side == rim.side)
        refuse(scene, "a condition at the joined end of " + in_quotes(tube.name));
  }
  hold_far_end(rim.side, tube);
  return rim;
}

/// The axis out of a tube at its rim.
Vec3 out_of(const JoinWall& tube, int side) {
  return (side == 1 ? 1.0 : -1.0) * Vec3(tube.shape.placement.rotation.col(2));
}

double rim_radius(const TubeShape& tube, int side) {
  return tube.radius_at(side);
}

JoinProblem read_end_to_end(const Scene& scene, std::optional<LawKind> law) {
  const EndToEndSpec& spec = *scene.end_to_end;
  if (!spec.rotation_deg) refuse(scene, "`rotation_deg: auto`");
  const VesselSpec &first = scene.vessel(spec.rims[0].vessel),
                   &second = scene.vessel(spec.rims[1].vessel);
  JoinProblem problem;
  problem.vein_first = scene.vessels.front().name == first.name;
  problem.units = {first.tube->radius, first.wall->material.young_axial};
  // The unit of length is the radius of the first rim.
  problem.vein = wall_of(scene, first, problem.units, law, true);
  const int side = take_rim(scene, spec.rims[0], problem.units.length, problem.vein).side;
  problem.units.length *= rim_radius(problem.vein.shape, side);
  const double unit = problem.units.length;
  problem.vein = wall_of(scene, first, problem.units, law, true);
  problem.artery = wall_of(scene, second, problem.units, law, true);
  const TubeRim one = take_rim(scene, spec.rims[0], unit, problem.vein),
                other = take_rim(scene, spec.rims[1], unit, problem.artery);
  problem.seam_side = one.side;
  problem.cut_fraction = one.fraction;
  problem.cut_pick = one.pick;
  problem.other_rim = OtherRim{other.side, other.fraction, other.pick};
  const double ratio = rim_radius(problem.artery.shape, other.side);
  if (std::max(ratio, 1 / ratio) > 2)
    refuse(scene,
           "rims whose perimeters differ by a factor of " + number(std::max(ratio, 1 / ratio)));

  // Out of the first vessel at its rim.
  const Pose rim = problem.vein.shape.section(one.side);
  const Vec3 out = out_of(problem.vein, one.side);
  problem.frame.position = rim.position;
  problem.frame.rotation << rim.director(1), out.cross(rim.director(1)), out;
  to_frame(problem.frame, problem.vein);
  to_frame(problem.frame, problem.artery);
  std::vector<EndProblem> ends = problem.vein.ends;
  ends.insert(ends.end(), problem.artery.ends.begin(), problem.artery.ends.end());
  require_held(scene, ends, "the join");

  problem.rotation = *spec.rotation_deg * pi / 180;
  const Vec3 facing = out_of(problem.artery, other.side);
  problem.axis_turn = std::atan2(facing.cross(-Vec3::UnitZ()).norm(), -facing.z());
  if (problem.axis_turn > pi / 2)
    refuse(scene, "rims that have to turn by " + number(problem.axis_turn * 180 / pi) +
                      " degrees to face each other");
  // The directions at rest that the smallest turn and the rotation bring to +x and +y.
  const Mat3 turn = (Eigen::AngleAxisd(problem.rotation, Vec3::UnitZ()) *
                     Eigen::Quaterniond::FromTwoVectors(facing, -Vec3::UnitZ()))
                        .toRotationMatrix();
  unroll_from(Vec3::UnitX(), Vec3::UnitY(), problem.vein);
  unroll_from(turn.transpose() * Vec3::UnitX(), turn.transpose() * Vec3::UnitY(), problem.artery);
  return problem;
}

}  // namespace

JoinWall as_seen(const JoinWall& wall) {
  JoinWall seen = wall;
  seen.shape = wall.whole;
  seen.kept_from = 0;
  seen.kept_to = 1;
  seen.hole.reset();
  seen.ends = wall.ends_when_seen;
  return seen;
}

Vec3 JoinWall::parameters(double share, double fraction, double depth) const {
  const Vec2 at = hole ? hole->place(share, fraction) : Vec2(share, fraction);
  return {first_angle / (2 * pi) + turn * at[0], at[1], turn > 0 ? depth : 1 - depth};
}

double Incision::rim_share(const Vec3& parameter) const {
  const double along = (parameter[1] - from) / (to - from);
  const double share = parameter[0] < 0.5 ? 0.5 * (1 - along) : 0.5 * (1 + along);
  return share - std::floor(share + equal);
}

Vec3 Incision::rim_parameter(double share) const {
  const bool first_lip = share <= 0.5;
  const double along = first_lip ? 1 - 2 * share : 2 * share - 1;
  return {first_lip ? 0.0 : 1.0, from + along * (to - from), 0.5};
}

bool open_ellipse(JoinProblem& problem, double length, double width) {
  Incision& incision = problem.incision;
  const TubeShape& artery = problem.artery.shape;
  HoleChart hole;
  hole.half_length = length / 2;
  hole.half_width = width / 2;
  hole.middle = 0.5 * (incision.from + incision.to);
  hole.line = std::hypot(artery.length, artery.end_radius - artery.radius);
  hole.half_around = pi * artery.radius_at(hole.middle);
  incision.length = length;
  incision.perimeter = hole.perimeter();
  incision.from = hole.middle - hole.half_length / hole.line;
  incision.to = hole.middle + hole.half_length / hole.line;
  problem.artery.hole = hole;
  return incision.from > equal && incision.to < 1 - equal && hole.half_width < hole.half_around;
}

JoinProblem read_join(const Scene& scene, std::optional<LawKind> law) {
  if (scene.vessels.size() != 2)
    refuse(scene, std::to_string(scene.vessels.size()) + " vessels beside a surgery");
  for (const VesselSpec& vessel : scene.vessels) require_tube(scene, vessel);
  if (!scene.contact || !scene.contact->empty())
    refuse(scene, scene.contact ? "a pair in `contact`" : "no `contact: []`");
  JoinProblem problem = scene.glenn ? read_glenn_join(scene, law) : read_end_to_end(scene, law);
  const double first = problem.vein.seen.pressure.after,
               second = problem.artery.seen.pressure.after;
  if (std::abs(first - second) > 1e-9 * std::abs(second))
    throw InputError(scene.file.string() + ": pressure.after: found " +
                     number(first * problem.units.stress) + " and " +
                     number(second * problem.units.stress) + ' ' + scene.units.stress + " in " +
                     problem.vein.name + " and " + problem.artery.name +
                     ", expected one pressure, as the operation joins them to one lumen");
  return problem;
}

}  // namespace vasorod::fem
