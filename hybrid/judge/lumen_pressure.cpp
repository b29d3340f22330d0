#include "judge/lumen_pressure.h"

#include <cmath>

#include <vasorod/error.h>

#include "data/mmhg.h"
#include "data/scene_place.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

constexpr double largest_stretch = 0.5;
constexpr double collapse_share = 0.9;

}  // namespace

double collapse_pressure(const Material& material, double thickness, double radius) {
  const double ratio = thickness / radius, nu = material.poisson_tt;
  return material.young_transverse * ratio * ratio * ratio / (4 * (1 - nu * nu));
}

std::string mmhg_text(double pressure, const Units& units) {
  return number_text(pressure * mmhg_per(units.stress), 4) + " mmHg (" + number_text(pressure, 4) +
         " " + units.stress + ")";
}

void require_bearable(const PreparedVessel& vessel, const Scene& scene) {
  const Units& units = scene.units;
  const Wall& wall = *vessel.spec.wall;
  const double inner = vessel.vessel.mean_radius - wall.thickness / 2,
               per_stretch = wall.material.young_transverse * wall.thickness / inner;
  for (const auto& [key, pressure] :
       {std::pair("scan", vessel.spec.pressure->scan), {"after", vessel.spec.pressure->after}}) {
    const double stretch = pressure / per_stretch;
    if (std::abs(stretch) <= largest_stretch) continue;
    const bool inflates = stretch > 0;
    throw InputError(place_of(scene, vessel.spec) + "pressure." + key + ": found " +
                     mmhg_text(pressure, units) + ", which would " +
                     (inflates ? "stretch" : "shorten") + " the wall by " +
                     number_text(100 * std::abs(stretch), 3) + " %, expected at " +
                     (inflates ? "most " : "least ") +
                     mmhg_text(std::copysign(largest_stretch * per_stretch, stretch), units) +
                     ": are its unit (units.pressure) and the wall's right?");
  }
}

std::string lumen_note(const VesselSpec& vessel, const Units& units) {
  return "pressure in the lumen of " + vessel.name + ": " +
         mmhg_text(vessel.pressure->scan, units) + " as scanned, " +
         mmhg_text(vessel.pressure->after, units) + " after";
}

void warn_of_collapse(const PreparedVessel& vessel, const Units& units, Validity& validity) {
  if (!vessel.spec.pressure || !vessel.spec.wall) return;
  const double pressure = vessel.spec.pressure->after,
               critical = collapse_pressure(vessel.spec.wall->material, vessel.spec.wall->thickness,
                                            vessel.vessel.mean_radius);
  if (pressure > -collapse_share * critical) return;
  validity.in_range = false;
  validity.warnings.push_back(
      "vessel " + vessel.spec.name + ": a pressure of " + mmhg_text(pressure, units) +
      " collapses it, as a ring of its radius does at " + mmhg_text(-critical, units));
}

}  // namespace vasorod
