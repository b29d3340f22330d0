#include "predict/walls_means.h"

#include <cmath>
#include <numbers>
#include <string>

#include "data/index.h"
#include "rod/strain_change.h"
#include "vessel/section_means.h"

namespace vasorod {
namespace {

// Nodes within a radius of a mouth: its section belongs to the seam, not to a tube.
std::vector<char> nodes_beside(const RodTree& rod, int mouth) {
  std::vector<char> beside(rod.rest.size(), 0);
  if (mouth < 0) return beside;
  for (size_t n = 0; n < beside.size(); ++n)
    beside[n] =
        (rod.rest[n].position - rod.rest[index(mouth)].position).norm() <= rod.radius[index(mouth)];
  return beside;
}

// Turn about the axis from end to end beyond that at rest, degrees.
double twist(const RodTree& rod, const RodPoses& poses) {
  double turn = 0;
  const std::vector<ElementChange> changes = element_changes(rod, poses);
  for (size_t e = 0; e < changes.size(); ++e)
    if (!changes[e].at_fork) turn += changes[e].twist() * rod.elements[e].length;
  return turn * 180 / std::numbers::pi;
}

// A whole turn changes no end's pose, so that a rod or a wall that passes through itself may lose
// it.
void name_lost_turns(const PredictedVessel& vessel, double of_rod, Prediction& prediction) {
  SolvedSurfaces& surfaces = *prediction.surfaces;
  const RodSummary& rod = vessel.rod.summary;
  if (vessel.rod_solved && rod.status == Status::buckled) {
    surfaces.solution.status = worse(surfaces.solution.status, Status::buckled);
    surfaces.notes.push_back("rod of " + vessel.prepared.spec.name + ": " + rod.message);
  }
  const double of_wall = twist(vessel.prepared.vessel.rod, vessel.rod.poses);
  if (std::abs(of_wall - of_rod) < 180 || is_unfinished(surfaces.solution.status)) return;
  surfaces.solution.status = worse(surfaces.solution.status, Status::buckled);
  surfaces.notes.push_back("vessel " + vessel.prepared.spec.name + " is twisted by " +
                           std::to_string(std::lround(of_wall)) + " degrees and not by " +
                           std::to_string(std::lround(of_rod)) +
                           " as its rod: turns were lost on the way, as a wall may pass through "
                           "itself or coil, and the result is not that of the motion");
}

}  // namespace

void give_rods_the_walls_means(Prediction& prediction, const std::vector<VesselSections>& sections,
                               const std::vector<std::vector<SectionSolution>>& solutions) {
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    PredictedVessel& vessel = prediction.vessels[v];
    if (!prediction.surfaces->solution.bodies[v].modelled) continue;
    const Vessel& mine = vessel.prepared.vessel;
    std::vector<std::optional<Pose>> known(mine.rod.rest.size());
    for (size_t k = 0; k < sections[v].nodes.size(); ++k) {
      const SectionSolution& solved = solutions[v][k];
      const auto node = index(sections[v].nodes[k]);
      known[node] = Pose{solved.rotation * mine.rod.rest[node].rotation, solved.center};
    }
    const double of_rod = twist(mine.rod, vessel.rod.poses);
    vessel.rod.poses = section_means(mine, vessel.positions, vessel.rod.poses, known,
                                     nodes_beside(mine.rod, mouth_of(prediction, vessel)));
    if (!prediction.operation) name_lost_turns(vessel, of_rod, prediction);
  }
}

}  // namespace vasorod
