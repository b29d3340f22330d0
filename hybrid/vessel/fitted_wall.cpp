#include "vessel/fitted_wall.h"

#include <vasorod/error.h>

#include "rod/section.h"
#include "vessel/check_fit.h"

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

void add_wall(PreparedVessel& prepared) {
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

void change_wall(PreparedVessel& prepared, const VesselSpec& spec) {
  for (double& radius : prepared.vessel.rod.radius) radius -= prepared.mid_offset();
  prepared.vessel.mean_radius -= prepared.mid_offset();
  prepared.spec = spec;
  add_wall(prepared);
}

}  // namespace vasorod
