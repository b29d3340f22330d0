#include "vessel/prepared_vessel.h"

#include "vessel/fitted_wall.h"
#include "vessel/name_ends.h"

namespace vasorod {

double PreparedVessel::outer_offset() const {
  if (spec.surface_is == SurfaceIs::outer) return 0;
  return spec.surface_is == SurfaceIs::mid ? thickness() / 2 : thickness();
}

double PreparedVessel::mid_offset() const {
  return outer_offset() - thickness() / 2;
}

PreparedVessel read_vessel(const VesselSpec& spec, const Scene& scene) {
  PreparedVessel prepared;
  prepared.spec = spec;
  prepared.loaded = load_surface(spec, scene);
  prepared.vessel.surface = std::move(prepared.loaded.surface);
  return prepared;
}

void fit(PreparedVessel& prepared) {
  prepared.vessel = fit_vessel(prepared.spec.name, prepared.vessel.surface);
  name_ends(prepared.vessel, prepared.loaded.lids);
  add_wall(prepared);
}

}  // namespace vasorod
