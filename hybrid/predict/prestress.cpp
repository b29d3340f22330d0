#include "predict/prestress.h"

#include <cmath>

#include <vasorod/error.h>

#include "data/scene_place.h"
#include "data/sentence.h"
#include "judge/lumen_pressure.h"
#include "predict/vessel_wall.h"

namespace vasorod {
namespace {

// Beyond this, over the radius, the first linear step is a rough prestress.
constexpr double largest_displacement = 0.1;

}  // namespace

void require_one_pressure(const Scene& scene) {
  if (!scene.glenn) return;
  const VesselSpec &svc = scene.vessel(scene.glenn->svc), &rpa = scene.vessel(scene.glenn->rpa);
  const auto after = [](const VesselSpec& vessel) {
    return vessel.pressure ? vessel.pressure->after : 0;
  };
  if (std::abs(after(svc) - after(rpa)) <= 1e-9 * std::abs(after(rpa))) return;
  const auto text = [&](const VesselSpec& vessel) {
    return mmhg_text(after(vessel), scene.units) + " in " + vessel.name;
  };
  throw InputError(place_of(scene, svc) + "pressure.after: found " + text(svc) + " and " +
                   text(rpa) + ", expected one pressure, as the operation joins them to one lumen");
}

void prestress(Prediction& prediction, const std::function<void(const std::string&)>& begin) {
  const Scene& scene = *prediction.scene;
  for (PredictedVessel& vessel : prediction.vessels) {
    PreparedVessel& prepared = vessel.prepared;
    const VesselSpec& spec = prepared.spec;
    if (prepared.obstacle() || (!spec.pressure && spec.axial_prestretch == 1)) continue;
    begin("prestress of " + spec.name);
    if (spec.pressure) {
      require_bearable(prepared, scene);
      prediction.notes.push_back(lumen_note(spec, scene.units));
    }
    const bool cut = scene.glenn && scene.glenn->svc == spec.name;
    try {
      prepared.prestress_displacement = displacement_of_scan(prepared, vessel.conditions, cut);
    } catch (const InputError& error) {  // which names the vessel
      throw InputError(place_in(scene, spec.line) + ": " + error.what());
    }
    if (prepared.prestress_displacement.rows() == 0) continue;
    const double share =
        prepared.prestress_displacement.rowwise().norm().maxCoeff() / prepared.vessel.mean_radius;
    if (share > largest_displacement)
      prediction.notes.push_back(
          "prestress of " + spec.name + ": it is that of a linear displacement of up to " +
          number_text(100 * share, 2) +
          " % of the radius; beyond 10 % this first step is rough, though the shape as seen is in "
          "equilibrium with it");
  }
}

}  // namespace vasorod
