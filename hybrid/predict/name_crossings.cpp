#include "predict/name_crossings.h"

#include <algorithm>

#include "data/index.h"
#include "data/sentence.h"
#include "judge/crossings.h"
#include "predict/sharp_vein.h"

namespace vasorod {

namespace {

std::string sentence(const std::string& a, const std::string& b, const Crossing& crossing,
                     const std::string& length_unit, const std::string& why) {
  return a + (a == b ? " passes through itself" : " and " + b + " pass through each other") +
         " at " + place_text(crossing.where) + ", " + number_text(crossing.depth, 3) + " " +
         length_unit + " deep in " + std::to_string(crossing.pairs) + " pairs of triangles: " + why;
}

// Why nothing kept the walls apart.
std::string why_crossed(const Prediction& prediction, const std::string& fidelity,
                        const NamedCrossing& crossing) {
  if (!prediction.surfaces) return "fidelity " + fidelity + " models no contact";
  const auto name = [&](int body) { return prediction.vessels[index(body)].prepared.spec.name; };
  const auto& contacts = prediction.surfaces->solution.contacts;
  if (std::any_of(contacts.begin(), contacts.end(), [&](const ContactSolution& pair) {
        return pair.within_reach && ((name(pair.a) == crossing.a && name(pair.b) == crossing.b) ||
                                     (name(pair.a) == crossing.b && name(pair.b) == crossing.a));
      }))
    return "the contact did not part them";
  return crossing.a == crossing.b ? "the wall did not feel itself" : "they did not feel each other";
}

}  // namespace

std::vector<NamedCrossing> named_crossings(const Prediction& prediction) {
  std::vector<CheckedBody> bodies;
  std::vector<std::string> names;
  CheckedSeam seam;
  std::vector<Points> carried(prediction.vessels.size());  // in fidelity rod
  bool joined = prediction.operation.has_value();
  for (size_t v = 0; v < carried.size(); ++v) {
    const PredictedVessel& vessel = prediction.vessels[v];
    if (vessel.prepared.vessel.surface.triangles.rows() == 0) continue;  // a bare rod
    const bool has_wall = vessel.positions.rows() > 0;
    if (!has_wall) carried[v] = carried_surface(vessel);
    joined &= has_wall;
    const std::string& name = vessel.prepared.spec.name;
    if (prediction.operation && prediction.operation->vessels[0].name == name)
      seam.a = static_cast<int>(bodies.size());
    if (prediction.operation && prediction.operation->vessels[1].name == name)
      seam.b = static_cast<int>(bodies.size());
    bodies.push_back({&vessel.prepared.vessel.surface, has_wall ? &vessel.positions : &carried[v],
                      vessel.prepared.obstacle() ? 0 : vessel.prepared.vessel.mean_radius});
    names.push_back(name);
  }
  if (joined) seam.pairs = prediction.operation->pairs;
  std::vector<NamedCrossing> named;
  for (const Crossing& crossing : crossings(bodies, seam)) {
    const bool at_seam = std::minmax(crossing.a, crossing.b) == std::minmax(seam.a, seam.b);
    if (at_seam && !joined) continue;  // nothing closed the seam
    named.push_back({names[index(crossing.a)], names[index(crossing.b)], crossing});
  }
  return named;
}

double deepest_crossing(Prediction& prediction) {
  if (!prediction.crossings) prediction.crossings = named_crossings(prediction);
  double depth = 0;
  for (const NamedCrossing& found : *prediction.crossings)
    depth = std::max(depth, found.crossing.depth);
  return depth;
}

void name_crossings(const Prediction& prediction, Result& result) {
  if (result.status == Status::interrupted) return;
  const auto found = prediction.crossings ? *prediction.crossings : named_crossings(prediction);
  for (const NamedCrossing& named : found) {
    const auto& [a, b, crossing] = named;
    result.self_intersections.push_back({a, b, crossing.pairs, crossing.depth, crossing.where});
    result.validity.warnings.push_back(sentence(a, b, crossing, prediction.scene->units.length,
                                                why_crossed(prediction, result.fidelity, named)));
    result.validity.in_range = false;
  }
  if (result.self_intersections.empty() || !prediction.surfaces) return;
  result.status = worse(result.status, Status::self_intersecting);
  const std::optional<SharpVein> vein = sharp_vein(prediction);
  const bool folds =
      vein && std::any_of(result.self_intersections.begin(), result.self_intersections.end(),
                          [&](const SelfIntersection& crossing) {
                            return crossing.a == vein->name || crossing.b == vein->name;
                          });
  if (!folds) return;
  if (const auto sentence = sharp_vein_sentence(*vein))
    result.certificate.notes.push_back(*sentence);
}

}  // namespace vasorod
