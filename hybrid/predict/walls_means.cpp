#include "predict/walls_means.h"

#include "data/index.h"
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
    vessel.rod.poses = section_means(mine, vessel.positions, vessel.rod.poses, known,
                                     nodes_beside(mine.rod, mouth_of(prediction, vessel)));
  }
}

}  // namespace vasorod
