#include "reference_fem/join_result.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference_fem/mouth.h"
#include "reference_fem/tube_result.h"

namespace vasorod::fem {
namespace {

Points in_scene(const Pose& frame, const Points& points) {
  return (points * frame.rotation.transpose()).rowwise() + frame.position.transpose();
}

MidWall in_scene(const Pose& frame, const MidWall& wall) {
  MidWall out = wall;
  for (Points MidWall::*points :
       {&MidWall::rest, &MidWall::current, &MidWall::other_lip_rest, &MidWall::other_lip_current})
    out.*points = in_scene(frame, wall.*points);
  return out;
}

/// Reactions of the ends and the balance of one vessel. The forces named here balance only where
/// there is no pressure.
void report_forces(const JoinProblem& problem, const JoinWall& wall, const JoinForces& forces,
                   Result& result) {
  const std::string& vessel = wall.name;
  const ProblemUnits& units = problem.units;
  Balance balance;
  balance.vessel = vessel;
  double largest = units.force() * std::max(forces.load.norm(), forces.seam.norm());
  for (const JoinForces::End& end : forces.ends) {
    EndReaction reaction;
    reaction.vessel = vessel;
    reaction.end = end.name;
    reaction.force = units.force() * problem.in_scene(end.force);
    reaction.moment = units.moment() * problem.in_scene(end.moment);
    reaction.center = units.length * (problem.frame * end.center);
    balance.support += reaction.force;
    largest = std::max({largest, reaction.force.norm(), reaction.moment.norm() / units.length});
    if (!end.name.empty()) result.ends.push_back(reaction);
  }
  balance.load = units.force() * problem.in_scene(forces.load);
  balance.join = units.force() * problem.in_scene(forces.seam);
  if (!wall.seen.pressed() && largest > 0)
    balance.residual = (balance.support + balance.load + balance.join).norm() / largest;
  result.balance.push_back(balance);
}

void report_vessel(const JoinProblem& problem, const JoinWall& wall, const MidWall& mid_wall,
                   Result& result) {
  TubeShape shape = wall.shape;
  shape.placement = problem.frame * shape.placement;
  const MidWall placed = in_scene(problem.frame, mid_wall);
  VesselResult vessel = vessel_result(wall.name, shape, problem.units.length, placed);
  result.metrics.push_back(vessel_metrics(shape, problem.units.length, placed, vessel));
  result.model.vertices += static_cast<int>(vessel.rest.rows());
  result.model.triangles += static_cast<int>(vessel.triangles.rows());
  result.vessels.push_back(std::move(vessel));
}

CutReport cut_of(const JoinProblem& problem, const JoinWall& wall, int side, double fraction,
                 const std::optional<Vec3>& pick) {
  const double unit = problem.units.length;
  const Pose rim = problem.frame * wall.shape.section(side);
  CutReport cut;
  cut.fraction = fraction;
  cut.perimeter = 2 * std::numbers::pi * unit * wall.shape.radius_at(side);
  cut.point = unit * rim.position;
  cut.pick = pick.value_or(cut.point);
  cut.normal = (side == 1 ? 1.0 : -1.0) * rim.director(3);
  return cut;
}

SeamReport seam_of(const JoinProblem& problem, const JoinSolution& solution) {
  SeamReport seam;
  seam.pairs = solution.pairs;
  seam.rotation_deg = problem.rotation * 180 / std::numbers::pi;
  seam.axis_turn_deg = problem.axis_turn * 180 / std::numbers::pi;
  const Eigen::VectorXd gap =
      problem.units.length * (solution.rim - solution.lips).rowwise().norm();
  seam.largest_gap = gap.maxCoeff();
  seam.rms_gap = std::sqrt(gap.squaredNorm() / static_cast<double>(gap.size()));
  return seam;
}

/// End to end: whether the second vessel has the smaller lumen at its rim.
bool second_is_narrower(const JoinProblem& problem) {
  const auto lumen = [](const TubeShape& tube, int side) {
    return tube.radius_at(side) - tube.thickness_at(side) / 2;
  };
  return problem.other_rim && lumen(problem.artery.shape, problem.other_rim->side) <
                                  (1 - 1e-9) * lumen(problem.vein.shape, problem.seam_side);
}

EndToEndReport end_to_end_of(const JoinProblem& problem, const JoinSolution& solution) {
  EndToEndReport report;
  report.rims[0] = {problem.vein.name, cut_of(problem, problem.vein, problem.seam_side,
                                              problem.cut_fraction, problem.cut_pick)};
  const OtherRim& other = *problem.other_rim;
  report.rims[1] = {problem.artery.name,
                    cut_of(problem, problem.artery, other.side, other.fraction, other.pick)};
  report.join = seam_of(problem, solution);
  report.narrower = second_is_narrower(problem) ? 1 : 0;
  report.mouth = join_mouth(problem, solution);
  return report;
}

GlennReport operation_of(const JoinProblem& problem, const JoinSolution& solution) {
  const double unit = problem.units.length;
  GlennReport glenn;
  glenn.svc = problem.vein.name;
  glenn.rpa = problem.artery.name;
  glenn.cut =
      cut_of(problem, problem.vein, problem.seam_side, problem.cut_fraction, problem.cut_pick);
  glenn.incision.length = problem.incision.length * unit;
  glenn.incision.perimeter = problem.incision.perimeter * unit;
  glenn.incision.perimeter_ratio = problem.incision.perimeter / (2 * std::numbers::pi);
  if (problem.artery.hole) {
    glenn.incision.shape = "ellipse";
    glenn.incision.width = 2 * problem.artery.hole->half_width * unit;
    glenn.incision.removed_area =
        std::numbers::pi / 4 * glenn.incision.length * glenn.incision.width;
  }
  const double fractions[] = {problem.incision.from, problem.incision.to};
  for (std::size_t k = 0; k < 2; ++k)
    glenn.incision.ends[k] =
        unit *
        (problem.frame * problem.artery.shape.point(problem.artery.parameters(0, fractions[k])));
  glenn.incision.along = 0.5 * (problem.incision.from + problem.incision.to);
  const TubeShape& tube = problem.artery.shape;
  const Vec3 pick = tube.point(problem.artery.parameters(0, glenn.incision.along)),
             out = tube.section(0).inverse() * pick;
  glenn.incision.pick = unit * (problem.frame * pick);
  glenn.incision.around_deg = std::atan2(out.y(), out.x()) * 180 / std::numbers::pi;
  // the area inside the lips, without an inset
  glenn.incision.opened_area = mouth_of(unit * solution.lips, unit * solution.rim_rest, 0).area;
  glenn.join = seam_of(problem, solution);
  glenn.mouth = join_mouth(problem, solution);
  return glenn;
}

}  // namespace

MouthReport join_mouth(const JoinProblem& problem, const JoinSolution& solution) {
  const double unit = problem.units.length;
  const bool second = second_is_narrower(problem);
  const Points seam = in_scene(problem.frame, 0.5 * (solution.rim + solution.lips));
  const double thickness = second ? problem.artery.shape.thickness_at(problem.other_rim->side)
                                  : problem.vein.shape.thickness_at(problem.seam_side);
  const Points& rest = second ? solution.lips_rest : solution.rim_rest;
  return mouth_of(unit * seam, unit * in_scene(problem.frame, rest), unit * thickness);
}

void report_join(const JoinProblem& problem, const JoinSolution& solution, Result& result) {
  const bool vein_first = problem.vein_first;
  for (const bool vein : {vein_first, !vein_first}) {
    const JoinWall& wall = vein ? problem.vein : problem.artery;
    report_forces(problem, wall, vein ? solution.on_vein : solution.on_artery, result);
    report_vessel(problem, wall, vein ? solution.vein : solution.artery, result);
  }
  if (problem.other_rim)
    result.end_to_end = end_to_end_of(problem, solution);
  else
    result.glenn = operation_of(problem, solution);
  // as in vasorod, the mouth counts among the sections of the vein, or of the narrower vessel
  const JoinedVessels joined = joined_vessels(result).value();
  for (VesselMetrics& metrics : result.metrics)
    if (metrics.vessel == joined.mouth_of &&
        joined.mouth->area_ratio < metrics.smallest_lumen_ratio) {
      metrics.smallest_lumen_ratio = joined.mouth->area_ratio;
      metrics.where["smallest_lumen_ratio"] = joined.mouth->center;
    }
}

}  // namespace vasorod::fem
