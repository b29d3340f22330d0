#include "app/solve_coupled.h"

#include <algorithm>
#include <cmath>

#include "app/solve_surfaces.h"
#include "surface/binding.h"
#include "surface/joined_skin.h"
#include "vessel/section_means.h"
#include "vessel/validity.h"
#include "vessel/vessel_wall.h"

namespace vasorod {
namespace {

// From this share of a limit (Brazier's, a wrinkle's) on a smooth and a kinked minimum coexist: follow the
// path.
// At half the limit one minimum is left; from there in small steps, each extrapolated from the two before.
constexpr double follow_from = 0.7, first_shares[] = {0.25, 0.5}, share_step = 0.05;
constexpr int most_steps = 40;
// A section free to flatten kinks first: with t / R 0.1 and L / R 10 between 0.40 and 0.45 of the limit.
constexpr double soft_share = 0.5;

size_t index(int i) {
  return static_cast<size_t>(i);
}

// How near the rods come to the walls' limits, where the smooth branch may end: of Brazier's curvature
// (whatever the vessel's length: k R^2 / (0.605 t) in its terms) and of the twist that wrinkles.
double share_of_limit(const Prediction& prediction) {
  double share = 0;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (!vessel.rod_solved) continue;
    Validity validity;
    add_validity(vessel.prepared, vessel.rod.poses, rigid_nodes(prediction, vessel), validity);
    const double nu = vessel.prepared.spec.wall->poisson;
    const double own =
        std::max(validity.twist_ratio, validity.wrinkling_ratio * 0.605 / 0.471 * std::sqrt(1 - nu * nu));
    const auto& ends = vessel.conditions.ends;
    const bool soft =
        std::any_of(ends.begin(), ends.end(), [](const ConditionedEnd& end) { return !end.rigid; });
    share = std::max(share, soft ? own / soft_share : own);
  }
  return share;
}

std::vector<double> path_times(const Prediction& prediction) {
  if (prediction.glenn) return {1};  // the pose is no more than a start: no path leads from rest to it
  const double share = share_of_limit(prediction);
  if (share < follow_from) return {1};
  std::vector<double> times;
  for (const double early : first_shares) times.push_back(early / share);
  const double first = times.back();
  const int steps = std::min(most_steps, static_cast<int>(std::ceil((share - first_shares[1]) / share_step)));
  for (int k = 1; k <= steps; ++k) times.push_back(first + (1 - first) * k / steps);
  times.back() = 1;
  return times;
}

CarriedBody carried_by(const PredictedVessel& vessel, const RodPoses& poses, const VesselSections& sections) {
  const Vessel& v = vessel.prepared.vessel;
  CarriedBody body;
  body.points = carried_points(v.rod, poses, v.binding);
  body.rotations = carried_rotations(v.rod, poses, v.binding);
  for (const int node : sections.nodes)
    body.sections.push_back({poses[index(node)].rotation * v.rod.rest[index(node)].rotation.transpose(),
                             poses[index(node)].position});
  return body;
}

CoupledProblem problem_of(Prediction& prediction, std::vector<VesselSections>& sections) {
  CoupledProblem problem;
  problem.surfaces = surface_problem(prediction);
  for (const PredictedVessel& vessel : prediction.vessels) {
    sections.emplace_back();
    problem.vessels.emplace_back();
    if (vessel.prepared.obstacle()) continue;
    sections.back() = sections_of(vessel.prepared.vessel, vessel.conditions, mouth_of(prediction, vessel));
    problem.vessels.back() =
        std::make_unique<CoupledVessel>(CoupledVessel{wall_of(vessel.prepared), sections.back().sections});
  }
  // A seam starts closed: sections carried rigidly give way as little as the paper's quadratic energies ask.
  std::vector<Points> joined;
  if (prediction.glenn) joined = joined_skin(problem.surfaces);
  problem.carried = [&prediction, &sections, joined](double t) {
    std::vector<CarriedBody> bodies;
    for (size_t v = 0; v < prediction.vessels.size(); ++v) {
      const PredictedVessel& vessel = prediction.vessels[v];
      bodies.emplace_back();
      if (!vessel.rod_solved) {
        if (!joined.empty() && !vessel.prepared.obstacle()) bodies.back().points = joined[v];
        continue;
      }
      const RodPoses poses =
          t == 1 ? vessel.rod.poses : share_of_strain(vessel.prepared.vessel.rod, vessel.rod.poses, t);
      bodies.back() = carried_by(vessel, poses, sections[v]);
      if (!joined.empty()) bodies.back().points = joined[v];
    }
    return bodies;
  };
  return problem;
}

// Nodes within a radius of a mouth: its section is a seam's, no tube's.
std::vector<char> nodes_beside(const RodTree& rod, int mouth) {
  std::vector<char> beside(rod.rest.size(), 0);
  if (mouth < 0) return beside;
  for (size_t n = 0; n < beside.size(); ++n)
    beside[n] = (rod.rest[n].position - rod.rest[index(mouth)].position).norm() <= rod.radius[index(mouth)];
  return beside;
}

// What is reported of a vessel along its axis is its wall's: the mean poses of its sections.
void give_rods_the_walls_means(Prediction& prediction, const std::vector<VesselSections>& sections) {
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    PredictedVessel& vessel = prediction.vessels[v];
    if (!prediction.surface->bodies[v].modelled) continue;
    const Vessel& mine = vessel.prepared.vessel;
    std::vector<std::optional<Pose>> known(mine.rod.rest.size());
    for (size_t k = 0; k < sections[v].nodes.size(); ++k) {
      const SectionSolution& solved = prediction.coupled->sections[v][k];
      const auto node = index(sections[v].nodes[k]);
      known[node] = Pose{solved.rotation * mine.rod.rest[node].rotation, solved.center};
    }
    vessel.rod.poses = section_means(mine, vessel.positions, vessel.rod.poses, known,
                                     nodes_beside(mine.rod, mouth_of(prediction, vessel)));
  }
}

}  // namespace

void solve_coupled(Prediction& prediction, const SolveOptions& options) {
  std::vector<VesselSections> sections;
  CoupledOptions coupled;
  coupled.times = path_times(prediction);
  coupled.keep_going = [&](const PaperProgress& at) {
    if (at.iterations % 10 == 0)
      options.progress("walls: update " + std::to_string(at.outer) + ", iteration " +
                       std::to_string(at.iterations));
    return !options.stop();
  };
  CoupledSolver solver(problem_of(prediction, sections), coupled);
  prediction.coupled = solver.solve();
  take_surfaces(std::move(prediction.coupled->surface), "wall", prediction);
  prediction.left_out["energy of the rods"] =
      "fidelity coupled: the walls carry all of it; the rods are start, frames and report";
  give_rods_the_walls_means(prediction, sections);
}

}  // namespace vasorod
