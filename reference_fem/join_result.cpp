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
  if (wall.pressure == 0 && largest > 0)
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

GlennReport operation_of(const JoinProblem& problem, const JoinSolution& solution) {
  const double unit = problem.units.length;
  GlennReport glenn;
  glenn.svc = problem.vein.name;
  glenn.rpa = problem.artery.name;
  const Pose cut = problem.frame * problem.vein.shape.section(problem.seam_side);
  glenn.cut.pick = problem.cut_pick;
  glenn.cut.fraction = problem.cut_fraction;
  glenn.cut.perimeter = 2 * std::numbers::pi * unit;
  glenn.cut.point = unit * cut.position;
  glenn.cut.normal = (problem.seam_side == 1 ? 1.0 : -1.0) * cut.director(3);
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
  glenn.join.pairs = solution.pairs;
  glenn.join.rotation_deg = problem.rotation * 180 / std::numbers::pi;
  glenn.join.axis_turn_deg = problem.axis_turn * 180 / std::numbers::pi;
  const Eigen::VectorXd gap = unit * (solution.rim - solution.lips).rowwise().norm();
  glenn.join.largest_gap = gap.maxCoeff();
  glenn.join.rms_gap = std::sqrt(gap.squaredNorm() / static_cast<double>(gap.size()));
  glenn.mouth = join_mouth(problem, solution);
  return glenn;
}

}  // namespace

MouthReport join_mouth(const JoinProblem& problem, const JoinSolution& solution) {
  const double unit = problem.units.length;
  const Points seam = in_scene(problem.frame, 0.5 * (solution.rim + solution.lips));
  return mouth_of(unit * seam, unit * in_scene(problem.frame, solution.rim_rest),
                  unit * problem.vein.shape.thickness_at(problem.seam_side));
}

void report_join(const JoinProblem& problem, const JoinSolution& solution, Result& result) {
  const bool vein_first = problem.vein_first;
  for (const bool vein : {vein_first, !vein_first}) {
    const JoinWall& wall = vein ? problem.vein : problem.artery;
    report_forces(problem, wall, vein ? solution.on_vein : solution.on_artery, result);
    report_vessel(problem, wall, vein ? solution.vein : solution.artery, result);
  }
  result.glenn = operation_of(problem, solution);
  // as in vasorod, the mouth counts among the vein's sections
  const MouthReport& mouth = *result.glenn->mouth;
  for (VesselMetrics& metrics : result.metrics)
    if (metrics.vessel == problem.vein.name && mouth.area_ratio < metrics.smallest_lumen_ratio) {
      metrics.smallest_lumen_ratio = mouth.area_ratio;
      metrics.where["smallest_lumen_ratio"] = mouth.center;
    }
}

}  // namespace vasorod::fem
