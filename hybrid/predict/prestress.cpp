#include "predict/prestress.h"

#include <cmath>
#include <limits>
#include <utility>

#include <vasorod/error.h>

#include "data/prestress_sentence.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "judge/lumen_pressure.h"
#include "numerics/stress_free_search.h"
#include "predict/rod_lumen.h"
#include "predict/vessel_wall.h"

namespace vasorod {
namespace {

// Whether an operation opens the vessel across: at a cut, or at an end where it was held when it
// was seen.
bool is_opened(const Scene& scene, const std::string& name) {
  if (scene.glenn) return scene.glenn->svc == name;
  const auto joined = scene.joined();
  return joined && ((*joined)[0] == name || (*joined)[1] == name);
}

}  // namespace

void require_one_pressure(const Scene& scene) {
  const auto joined = scene.joined();
  if (!joined) return;
  const VesselSpec &first = scene.vessel((*joined)[0]), &second = scene.vessel((*joined)[1]);
  const auto after = [](const VesselSpec& vessel) {
    return vessel.pressure ? vessel.pressure->after : 0;
  };
  if (std::abs(after(first) - after(second)) <= 1e-9 * std::abs(after(second))) return;
  const auto text = [&](const VesselSpec& vessel) {
    return mmhg_text(after(vessel), scene.units) + " in " + vessel.name;
  };
  throw InputError(place_of(scene, first) + "pressure.after: found " + text(first) + " and " +
                   text(second) +
                   ", expected one pressure, as the operation joins them to one lumen");
}

double linear_prestrain_up_to(const Scene& scene, const PredictedVessel& vessel) {
  const VesselSpec& spec = vessel.prepared.spec;
  const auto joined = scene.joined();
  const bool changes = (joined && ((*joined)[0] == spec.name || (*joined)[1] == spec.name)) ||
                       (spec.pressure && spec.pressure->scan != spec.pressure->after) ||
                       vessel.conditions.acts;
  return changes ? largest_linear_prestrain : std::numeric_limits<double>::infinity();
}

namespace {

void prestress_wall(PredictedVessel& vessel, Prediction& prediction,
                    const std::function<bool()>& stop) {
  const Scene& scene = *prediction.scene;
  PreparedVessel& prepared = vessel.prepared;
  ScanDisplacement found;
  try {
    found = displacement_of_scan(prepared, vessel.conditions, is_opened(scene, prepared.spec.name),
                                 linear_prestrain_up_to(scene, vessel), stop);
  } catch (const InputError& error) {  // which names the vessel
    throw InputError(place_in(scene, prepared.spec.line) + ": " + error.what());
  }
  prepared.prestress_displacement = std::move(found.points);
  prepared.from_stress_free_shape = found.from_stress_free_shape;
  if (prepared.prestress_displacement.rows() == 0) return;
  const double share =
      prepared.prestress_displacement.rowwise().norm().maxCoeff() / prepared.vessel.mean_radius;
  if (const auto note = large_prestress(prepared.spec.name, share, found.steps))
    prediction.notes.push_back(*note);
}

void prestress_rod(PredictedVessel& vessel, bool cut, Prediction& prediction) {
  const std::string& name = vessel.prepared.spec.name;
  const double wider = press_rod(vessel.prepared, vessel.conditions, cut);
  const RodConditions& held = vessel.conditions.rod;
  vessel.conditions.acts |= !held.supports.empty() || !held.loads.empty();
  if (vessel.prepared.vessel.rod.branches.size() > 1 && vessel.prepared.spec.pressure)
    prediction.notes.push_back(
        "pressure in the lumen of " + name +
        ": it branches; the rods do not feel a trunk that becomes wider under its branches, and "
        "forces at their ends may differ much from those of fidelity coupled");
  if (wider != 0)
    prediction.left_out["radius of " + name] =
        "sections keep the radius they were seen with; the pressure changes it by " +
        number_text(100 * wider, 2) +
        " % away from held ends, which the rod's stiffness and the pressure's thrust count and the "
        "drawn sections do not";
}

}  // namespace

void prestress(Prediction& prediction, LumenOf lumen, const std::function<bool()>& stop,
               const std::function<void(const std::string&)>& begin) {
  const Scene& scene = *prediction.scene;
  if (lumen == LumenOf::none) return;
  for (const PredictedVessel& vessel : prediction.vessels)
    if (!vessel.prepared.obstacle() && vessel.prepared.spec.pressure)
      require_bearable(vessel.prepared, scene);
  for (PredictedVessel& vessel : prediction.vessels) {
    const VesselSpec& spec = vessel.prepared.spec;
    if (vessel.prepared.obstacle() || (!spec.pressure && spec.axial_prestretch == 1)) continue;
    begin("prestress of " + spec.name);
    if (spec.pressure) prediction.notes.push_back(lumen_note(spec, scene.units));
    if (lumen == LumenOf::wall)
      prestress_wall(vessel, prediction, stop);
    else if (lumen == LumenOf::rod)
      prestress_rod(vessel, is_opened(scene, spec.name), prediction);
  }
}

}  // namespace vasorod
