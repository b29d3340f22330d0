#include "predict/carried_bodies.h"

#include "data/index.h"
#include "predict/path_rule.h"
#include "rod/binding.h"

namespace vasorod {
namespace {

CarriedBody carried_by(const PredictedVessel& vessel, const RodPoses& poses,
                       const VesselSections& sections) {
  const Vessel& v = vessel.prepared.vessel;
  CarriedBody body;
  body.points = carried_points(v.rod, poses, v.carry);
  body.rotations = carried_rotations(v.rod, poses, v.carry);
  for (const int node : sections.nodes)
    body.sections.push_back(
        {poses[index(node)].rotation * v.rod.rest[index(node)].rotation.transpose(),
         poses[index(node)].position});
  return body;
}

}  // namespace

std::vector<CarriedBody> carried_by_rods(const Prediction& prediction,
                                         const std::vector<VesselSections>& sections, double t,
                                         const JoiningPath* way) {
  std::vector<CarriedBody> bodies;
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    const PredictedVessel& vessel = prediction.vessels[v];
    bodies.emplace_back();
    if (!vessel.rod_solved) continue;
    const RodPoses poses = way && way->is_vein(v) ? way->vein(t)
                           : t == 1
                               ? vessel.rod.poses
                               : share_of_strain(vessel.prepared.vessel.rod, vessel.rod.poses, t);
    bodies.back() = carried_by(vessel, poses, sections[v]);
  }
  return bodies;
}

void feel_themselves(const Prediction& prediction, BodyProblem& problem) {
  for (const OperatedVessel& joined : prediction.operation->vessels) {
    const auto body = static_cast<int>(vessel_named(prediction, joined.name));
    problem.contacts.emplace_back(body, body);
  }
}

SeamWay start_at_rest(const Prediction& prediction, const std::shared_ptr<const JoiningPath>& way,
                      BodyProblem& problem) {
  const auto vein = vessel_named(prediction, prediction.operation->vessels[0].name);
  problem.bodies[vein].open_mouth = true;
  feel_themselves(prediction, problem);
  return {[way](double t) { return way->offsets(t); }, way->step()};
}

}  // namespace vasorod
