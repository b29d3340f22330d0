#include "predict/coarse_start.h"

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/moved_with.h"
#include "geometry/smooth_moved.h"
#include "geometry/triangle_surface.h"
#include "predict/coarse_vessels.h"
#include "predict/get_ready.h"
#include "vessel/end_conditions.h"

namespace vasorod {
namespace {

// A coarse wall folds along one edge at the tip of a slit, where a fine one bends over several; a
// start with that crease would end in a minimum of its own. Around the seam it is smoothed: within
// this many radii, so many times.
constexpr double crease_reach = 0.5;
constexpr int crease_rounds = 5;

// The vertices of one side of the seam's surroundings that are on no rim.
std::vector<int> around_seam(const Prediction& fine, size_t side) {
  const Vessel& vessel =
      fine.vessels[vessel_named(fine, fine.operation->vessels[side].name)].prepared.vessel;
  const Points& points = vessel.surface.points;
  std::vector<int> rim;
  for (const auto& pair : fine.operation->pairs) rim.push_back(pair[side]);
  const Points seam = points(rim, Eigen::all);
  std::vector<char> skipped(index(points.rows()), 0);
  for (const std::vector<int>& loop : boundary_loops(vessel.surface.triangles))
    for (const int v : loop) skipped[index(v)] = 1;
  const double reach = crease_reach * vessel.mean_radius;
  std::vector<int> around;
  for (int i = 0; i < points.rows(); ++i)
    if (!skipped[index(i)] &&
        (seam.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff() < reach * reach)
      around.push_back(i);
  return around;
}

// The two vertices of a pair come from two coarse meshes, and the fine seam starts closed.
void close_seam(const Prediction& fine, CoupledStart& start) {
  const auto points = [&](size_t side) -> Points& {
    return start.bodies[vessel_named(fine, fine.operation->vessels[side].name)].points;
  };
  Points &first = points(0), &second = points(1);
  for (const auto& [a, b] : fine.operation->pairs)
    first.row(a) = second.row(b) = ((first.row(a) + second.row(b)) / 2).eval();
}

}  // namespace

std::optional<Prediction> coarse_prediction(const Prediction& fine, const SolveOptions& options) {
  if (!fine.operation) return std::nullopt;
  std::vector<PreparedVessel> vessels = coarse_vessels(
      fine.whole, {fine.operation->vessels[0].name, fine.operation->vessels[1].name});
  if (vessels.empty()) return std::nullopt;
  Prediction coarse;
  coarse.scene = fine.scene;
  coarse.fidelity = fine.fidelity;
  for (PreparedVessel& prepared : vessels) {
    PredictedVessel& vessel = coarse.vessels.emplace_back();
    vessel.prepared = std::move(prepared);
    const std::string& name = vessel.prepared.spec.name;
    if (!vessel.prepared.obstacle())
      vessel.conditions = end_conditions(*fine.scene, name, vessel.prepared.vessel);
  }
  try {
    get_ready(coarse, LumenOf::wall, options,
              [&](const std::string& stage) { options.progress("coarse meshes: " + stage); });
  } catch (const InputError&) {  // the fine meshes took it
    return std::nullopt;
  }
  return coarse;
}

CoupledStart start_from_coarse(const Prediction& coarse, const CoupledSolution& solution,
                               const Prediction& fine) {
  CoupledStart start;
  start.roughness = Roughness::smooth;
  start.buckled = solution.status == Status::buckled;
  for (size_t v = 0; v < fine.vessels.size(); ++v) {
    const BodySolution& body = solution.surface.bodies[v];
    start.bodies.emplace_back();
    start.pressure.emplace_back();
    if (!body.modelled) continue;
    const TriangleSurface& rest = fine.vessels[v].prepared.vessel.surface;
    MovedSurface moved =
        moved_with(coarse.vessels[v].prepared.vessel.surface, body.positions, body.pressure, rest);
    for (size_t side = 0; side < 2; ++side)
      if (fine.vessels[v].prepared.spec.name == fine.operation->vessels[side].name)
        smooth_moved(rest, around_seam(fine, side), crease_rounds, moved);
    CarriedBody& mine = start.bodies.back();
    mine.points = std::move(moved.points);
    mine.rotations = std::move(moved.rotations);
    for (const SectionSolution& section : solution.sections[v])
      mine.sections.push_back({section.rotation, section.center});
    start.pressure.back() = std::move(moved.values);
  }
  close_seam(fine, start);
  return start;
}

}  // namespace vasorod
