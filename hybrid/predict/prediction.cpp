#include "predict/prediction.h"

#include <vasorod/error.h>

#include "rod/binding.h"

namespace vasorod {

size_t vessel_named(const Prediction& prediction, const std::string& name) {
  for (size_t v = 0; v < prediction.vessels.size(); ++v)
    if (prediction.vessels[v].prepared.spec.name == name) return v;
  throw InputError("no vessel " + name);
}

Points carried_surface(const PredictedVessel& vessel) {
  const Vessel& mine = vessel.prepared.vessel;
  return vessel.rod_solved ? carried_points(mine.rod, vessel.rod.poses, mine.carry)
                           : mine.surface.points;
}

int mouth_of(const Prediction& prediction, const PredictedVessel& vessel) {
  if (!prediction.operation) return -1;
  for (const OperatedVessel& joined : prediction.operation->vessels)
    if (joined.name == vessel.prepared.spec.name) return joined.rim_node;
  return -1;
}

std::vector<int> rigid_nodes(const Prediction& prediction, const PredictedVessel& vessel) {
  const int mouth = mouth_of(prediction, vessel);
  std::vector<int> nodes;
  for (const RodSupport& support : vessel.conditions.rod.supports)
    if (support.node != mouth) nodes.push_back(support.node);
  return nodes;
}

}  // namespace vasorod
