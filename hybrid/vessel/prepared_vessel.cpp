#include "vessel/prepared_vessel.h"

#include <algorithm>

#include <vasorod/error.h>

#include "rod/section.h"
#include "vessel/check_fit.h"
#include "vessel/name_ends.h"

namespace vasorod {
namespace {

// Thickness at the rod's nodes: the wall's, or, if a generated tube's wall tapers, linear in arc
// length.
std::vector<double> node_thickness(const PreparedVessel& prepared) {
  const RodTree& rod = prepared.vessel.rod;
  std::vector<double> thickness(rod.rest.size(), prepared.thickness());
  if (!prepared.spec.tube || !prepared.spec.tube->end_thickness) return thickness;
  double length = 0;
  for (const RodElement& element : rod.elements) length += element.length;
  double s = 0;
  for (const RodElement& element : rod.elements) {
    s += element.length;
    thickness[static_cast<size_t>(element.second)] =
        prepared.thickness() +
        (*prepared.spec.tube->end_thickness - prepared.thickness()) * s / length;
  }
  return thickness;
}

}  // namespace

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
  for (double& radius : prepared.vessel.rod.radius) radius += prepared.mid_offset();
  prepared.vessel.mean_radius += prepared.mid_offset();
  prepared.node_thickness = node_thickness(prepared);
  try {
    check_thickness(prepared.vessel.rod, prepared.node_thickness);
  } catch (const InputError& e) {
    throw InputError("vessel " + prepared.spec.name + ": " + e.what());
  }
  set_annular_stiffness(prepared.vessel.rod, prepared.node_thickness, prepared.spec.wall->material,
                        "vessel " + prepared.spec.name);
}

}  // namespace vasorod
