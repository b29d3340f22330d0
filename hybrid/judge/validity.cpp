#include "judge/validity.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "data/index.h"
#include "data/sentence.h"
#include "judge/lumen_pressure.h"
#include "judge/triangle_strain.h"
#include "rod/conditions.h"
#include "rod/strain_change.h"
#include "vessel/fork_reach.h"
#include "wall/plane_stress.h"

namespace vasorod {
namespace {

// In uniaxial compression by this strain (nu 0.45) the stress of Biot's law is 20 % below that of
// the neo-Hookean law, that of S = C:E 42 %; in tension 18 and 55 % above.
constexpr double largest_strain_of_linear_laws = 0.2;

// The larger value. NaN is kept; std::max would lose it.
double worst(double a, double b) {
  return std::isnan(b) ? b : std::max(a, b);
}

// The largest value of a ratio along a vessel and where it occurs.
struct Extreme {
  double value = 0;
  Vec3 where = Vec3::Zero();
  void see(double candidate, const Vec3& place) {
    if (candidate <= value || std::isnan(value)) return;  // NaN is kept
    value = candidate;
    where = place;
  }
};

std::string sentence(const std::string& vessel, const Extreme& extreme, const std::string& near,
                     const std::string& past, double limit) {
  return "vessel " + vessel + " at " + place_text(extreme.where, 3) + ": " +
         (extreme.value < limit ? near : past) + " (ratio " +
         number_beside(extreme.value, limit, 3) + ")";
}

void judge(const std::string& vessel, const Extreme& extreme, const std::string& near,
           const std::string& past, Validity& validity) {
  if (extreme.value >= 0.7) validity.warnings.push_back(sentence(vessel, extreme, near, past, 0.9));
  if (extreme.value >= 0.9) validity.in_range = false;
}

// The strains of the triangles whose vertices all belong to the marked elements.
void see_walls(const Vessel& vessel, const Points& current, const std::vector<char>& marked,
               Extreme& strain) {
  const Triangles& triangles = vessel.surface.triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const std::array<int, 3> corner{triangles(t, 0), triangles(t, 1), triangles(t, 2)};
    if (std::all_of(corner.begin(), corner.end(),
                    [&](int v) { return marked[index(vessel.binding[index(v)].element)]; }))
      strain.see(triangle_strain(vessel.surface.points, current, corner),
                 (current.row(corner[0]) + current.row(corner[1]) + current.row(corner[2])) / 3);
  }
}

// Factors of a wall with a fibre on the limits of the isotropic wall (validity.h); 1 if isotropic.
struct FibreFactors {
  double bending;    ///< on Brazier's curvature
  double wrinkling;  ///< on the axial buckling strain
  double twist;      ///< on the torsional buckling stress over E_L
};

FibreFactors fibre_factors(const VesselSpec& spec) {
  const Material& m = spec.wall->material;
  const double across = m.young_transverse / m.young_axial, bending = std::sqrt(across);
  return {bending, bending * std::sqrt(std::min(1.0, m.shear_axial / ordinary_shear(m))),
          std::pow(across, 0.625)};
}

// Of the axial tension p R / (2 t) that a pressure from inside holds against bending's compression.
double tension_strain(double pressure, double t, double r, const Material& material) {
  return std::max(0.0, pressure) * r / (2 * t * material.young_axial);
}

}  // namespace

void add_validity(const PreparedVessel& vessel, const RodPoses& poses, const JudgedState& state,
                  Validity& validity) {
  const RodTree& rod = vessel.vessel.rod;
  const Material& material = vessel.spec.wall->material;
  const FibreFactors fibre = fibre_factors(vessel.spec);
  const double t = vessel.spec.wall->thickness,
               root = std::sqrt(1 - material.poisson_tt * material.poisson_tt),
               length = length_scale(rod);
  const double pressure = state.pressed && vessel.spec.pressure ? vessel.spec.pressure->after : 0;
  Extreme brazier, wrinkling, twist, strain, softening;
  const auto changes = element_changes(rod, poses);
  std::vector<char> at_fork = fork_elements(vessel.vessel);
  for (size_t e = 0; e < changes.size(); ++e) {
    if (e < state.opened.size() && state.opened[e]) {
      at_fork[e] = 0;
      continue;
    }
    const ElementChange& element = changes[e];
    const double r = element.radius;
    const bool at_rigid_end =
        std::any_of(state.rigid_nodes.begin(), state.rigid_nodes.end(), [&](int node) {
          return (rod.rest[index(node)].position - element.rest_middle).norm() < r;
        });
    if (at_rigid_end) {
      at_fork[e] = 0;
      continue;
    }
    const double outer = r + t / 2;
    if (!at_fork[e] || state.walls.rows() == 0) {
      strain.see(std::abs(element.change[2]) + element.bending() * outer, element.middle);
      strain.see(std::abs(element.twist()) * outer + element.change.head<2>().norm(),
                 element.middle);
    }
    if (at_fork[e]) continue;
    const bool is_long = length / r * std::sqrt(t / r) >= 7;
    const double inflated = pressure / collapse_pressure(material, t, r);
    if (is_long && inflated > -1)
      brazier.see(
          element.bending() * r * r * root / (0.471 * t * fibre.bending * std::sqrt(1 + inflated)),
          element.middle);
    wrinkling.see(element.bending() * r /
                      (0.605 * t / r * fibre.wrinkling + tension_strain(pressure, t, r, material)),
                  element.middle);
    const double critical_shear =
        0.747 * material.young_axial * fibre.twist * std::pow(t / r, 1.25) * std::sqrt(r / length);
    twist.see(material.shear_axial * r * std::abs(element.twist()) / critical_shear,
              element.middle);
    const double rest_curvature = (element.strain - element.change).segment<2>(3).norm();
    if (!state.sections_flatten && element.bending() > 0.1 * rest_curvature &&
        rest_curvature * r > 1e-3) {
      const double l = t * fibre.bending / (rest_curvature * r * r * root);
      softening.see((12 * l * l + 10) / (12 * l * l + 1), element.middle);
    }
  }
  if (state.walls.rows() > 0) see_walls(vessel.vessel, state.walls, at_fork, strain);
  const std::string& name = vessel.spec.name;
  validity.brazier_ratio = worst(validity.brazier_ratio, brazier.value);
  validity.wrinkling_ratio = worst(validity.wrinkling_ratio, wrinkling.value);
  validity.twist_ratio = worst(validity.twist_ratio, twist.value);
  validity.largest_strain = worst(validity.largest_strain, strain.value);
  judge(name, brazier, "its bending comes near the Brazier limit, the section flattens",
        "its section would kink there: bent past 0.9 of the Brazier limit", validity);
  judge(name, wrinkling, "its inner side comes near wrinkling",
        "its inner side would wrinkle there", validity);
  judge(name, twist, "its twist comes near the wrinkling limit",
        "it would wrinkle there under its twist", validity);
  if (strain.value > 0.2) {
    validity.in_range = false;
    validity.warnings.push_back(
        sentence(name, strain, "",
                 "strained past 0.2, where the choice of material law alone changes "
                 "the answer by 13 to 32 %",
                 0.2));
  }
  if (softening.value > 1.25)
    validity.warnings.push_back(
        sentence(name, softening, "",
                 "curved at rest: it bends softer than its round section by von "
                 "Karman's factor, which rod, skin and paper leave out",
                 1.25));
}

void warn_of_law(const VesselSpec& vessel, const FaceExtremes& faces, Validity& validity) {
  const Law law = vessel.wall->material.law;
  const double shortened = 1 - faces.least, lengthened = faces.largest - 1;
  const double strain = std::max(shortened, lengthened);
  if (law == Law::neo_hookean || strain <= largest_strain_of_linear_laws) return;
  const bool compressed = shortened >= lengthened || faces.least <= 0;
  std::string how = "folded through itself";
  if (faces.least > 0)
    how = (compressed ? "shortened by " : "lengthened by ") +
          number_beside(100 * strain, 100 * largest_strain_of_linear_laws, 2) + " %";
  validity.warnings.push_back("vessel " + vessel.name + " at " +
                              place_text(compressed ? faces.least_place : faces.largest_place, 3) +
                              ": a face of its wall is " + how +
                              ", past the 20 % up to which law " + to_string(law) +
                              " holds: use law neo-hookean");
}

void warn_of_units(const VesselSpec& vessel, const Units& units, Validity& validity) {
  if (!vessel.wall || vessel.tube) return;
  constexpr double softest = 0.01e6, stiffest = 100e6, rounding = 1e-12;
  const Material& material = vessel.wall->material;
  const auto judge_one = [&](const std::string& what, double young) {
    const double pascals = young * units.pascals;
    if (pascals >= softest * (1 - rounding) && pascals <= stiffest * (1 + rounding)) return;
    validity.warnings.push_back("vessel " + vessel.name + ": " + what + " of " +
                                number_text(young) + " " + units.stress +
                                " is outside 0.01 to 100 MPa, where vessels lie: are the units "
                                "right?");
  };
  judge_one("Young's modulus", material.young_axial);
  if (material.young_transverse != material.young_axial)
    judge_one("Young's modulus across the fibre", material.young_transverse);
}

void warn_of_radius(const std::string& vessel, double radius, const Units& units,
                    Validity& validity) {
  // Measured means: an adult's superior vena cava, pulmonary artery and aorta 8.8 to 10.0 mm, which
  // are 0.88 to 1.0 where cm is read as mm; an infant's 3.3 to 3.8 mm, 33 to 38 where mm is read as
  // cm.
  constexpr double smallest = 1.5, largest = 20;
  const double millimetres = radius * units.metres * 1e3;
  if (millimetres >= smallest && millimetres <= largest) return;
  const bool small = millimetres < smallest;
  std::string question = "is the unit right?";
  if (small && units.length != "m")
    question = "is it in " + std::string(units.length == "mm" ? "cm" : "m") + "?";
  if (!small && units.length != "mm")
    question = "is it in " + std::string(units.length == "m" ? "cm" : "mm") + "?";
  validity.warnings.push_back("vessel " + vessel + ": a mean radius of " + number_text(radius, 3) +
                              " " + units.length + " is " + (small ? "small" : "large") +
                              " for a great vessel: " + question);
}

void warn_of_keep(const GlennReport& glenn, Validity& validity) {
  if (!(glenn.join.axis_turn_deg > 90)) return;
  validity.warnings.push_back(
      "vessel " + glenn.svc + ": the mouth of the kept part has to turn by " +
      number_text(glenn.join.axis_turn_deg, 3) + " degrees to meet " + glenn.rpa +
      " from outside, that of the other part would turn by " +
      number_text(180 - glenn.join.axis_turn_deg, 3) +
      ": check that keep names the end on the head's side, and that the incision is on the side "
      "that faces the vein");
}

void warn_of_keep(const EndToEndReport& report, Validity& validity) {
  if (!(report.join.axis_turn_deg > 90)) return;
  validity.warnings.push_back(
      "vessels " + report.rims[0].vessel + " and " + report.rims[1].vessel +
      ": their rims have to turn by " + number_text(report.join.axis_turn_deg, 3) +
      " degrees to face each other: check which end each of them is joined by (keep, end)");
}

}  // namespace vasorod
