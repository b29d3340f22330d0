#include "reference_fem/scene_parts.h"

#include <Eigen/Geometry>
#include <numbers>
#include <sstream>
#include <utility>

#include <vasorod/error.h>

namespace vasorod::fem {
namespace {

/// Around the wall by a pressure, as R p / (E t); more is a mistaken unit.
constexpr double largest_stretch = 0.5;

Pose placement(const TubeSpec& tube, double unit) {
  Pose pose;
  const Vec3 d3 = tube.tangent.normalized();
  const Vec3 d1 = (tube.normal - tube.normal.dot(d3) * d3).normalized();
  pose.rotation << d1, d3.cross(d1), d3;
  pose.position = tube.position / unit;
  return pose;
}

}  // namespace

int side_of(const Scene& scene, const TubeShape& shape, const EndSelector& end, double unit) {
  if (end.kind == EndSelector::Kind::start) return 0;
  if (end.kind == EndSelector::Kind::end) return 1;
  if (end.kind == EndSelector::Kind::face)
    throw InputError(scene.file.string() + ": found the end " + to_string(end) +
                     " of a generated tube, expected start, end or {near: [x, y, z]}");
  const Vec3 at = end.near / unit;
  return (shape.section(0).position - at).norm() <= (shape.section(1).position - at).norm() ? 0 : 1;
}

bool EndProblem::held() const {
  for (const bool f : fixed)
    if (!f) return false;
  return !soft && move.isZero(0) && rotation.isZero(0);
}

TubeShape shape_of(const VesselSpec& vessel, const ProblemUnits& units) {
  const TubeSpec& tube = *vessel.tube;
  const double unit = units.length;
  TubeShape shape;
  shape.length = tube.length / unit;
  shape.radius = tube.radius / unit;
  shape.thickness = vessel.wall->thickness / unit;
  shape.end_radius = tube.end_radius.value_or(tube.radius) / unit;
  shape.end_thickness = tube.end_thickness.value_or(vessel.wall->thickness) / unit;
  shape.bend = tube.bend_deg * std::numbers::pi / 180;
  shape.placement = placement(tube, unit);
  return shape;
}

// The reference has its own moduli and laws, independent of the hybrid solver's.
Moduli moduli_of(const Material& m, double unit) {
  if (m.is_isotropic()) return Moduli::isotropic(m.young_axial / unit, m.poisson_tt);
  return {m.young_axial / unit, m.young_transverse / unit, m.poisson_tt,
          m.poisson_lt,         m.shear_axial / unit,      false};
}

LawKind law_of(const Material& material) {
  switch (material.law) {
    case Law::biot:
      return LawKind::biot;
    case Law::svk:
      return LawKind::svk;
    case Law::neo_hookean:
      return LawKind::neo_hookean;
  }
  return LawKind::biot;
}

std::vector<EndProblem> ends_of(const Scene& scene, const std::string& vessel,
                                const TubeShape& shape, const ProblemUnits& units) {
  std::vector<EndProblem> ends;
  for (const EndCondition& condition : scene.ends) {
    if (condition.vessel != vessel) continue;
    const int side = side_of(scene, shape, condition.end, units.length);
    EndProblem* entry = nullptr;
    for (EndProblem& known : ends)
      if (known.side == side) entry = &known;
    if (entry == nullptr) {
      ends.emplace_back();
      entry = &ends.back();
      entry->name = to_string(condition.end);
      entry->side = side;
    }
    entry->soft = entry->soft || condition.soft_section;
    if (condition.hold || condition.rotate_deg || condition.move) entry->fixed.fill(true);
    for (std::size_t k = 0; k < 6; ++k) entry->fixed[k] = entry->fixed[k] || condition.fix[k];
    if (condition.rotate_deg) entry->rotation = *condition.rotate_deg * (std::numbers::pi / 180);
    if (condition.move) entry->move = *condition.move / units.length;
    if (condition.force) entry->force = *condition.force / units.force();
    if (condition.moment) entry->moment = *condition.moment / units.moment();
    entry->moment_in_body = entry->moment_in_body || condition.moment_in_body;
  }
  return ends;
}

void require_held(const Scene& scene, const std::vector<EndProblem>& ends,
                  const std::string& what) {
  int fixed = 0;
  for (const EndProblem& end : ends)
    for (const bool f : end.fixed) fixed += f ? 1 : 0;
  if (fixed < 6)
    throw InputError(scene.file.string() + ": ends: found " + std::to_string(fixed) +
                     " components held in all, expected at least 6, as " + what +
                     " would float away");
}

void require_admissible(const Scene& scene, const std::string& vessel, LawKind law,
                        const Moduli& moduli) {
  try {
    const MaterialLaw check(law, moduli);
  } catch (const InputError& error) {
    throw InputError(scene.file.string() + ": " + vessel + ": " + error.what());
  }
}

SeenState seen_state(const Scene& scene, const VesselSpec& vessel, const ProblemUnits& units) {
  SeenState seen;
  seen.axial_stretch = vessel.axial_prestretch;
  if (!vessel.pressure) return seen;
  const double lumen = vessel.tube->radius - vessel.wall->thickness / 2,
               per_stretch =
                   vessel.wall->material.young_transverse * vessel.wall->thickness / lumen;
  for (const auto& [key, pressure] :
       {std::pair("scan", vessel.pressure->scan), {"after", vessel.pressure->after}})
    if (pressure > largest_stretch * per_stretch) {
      std::ostringstream sentence;
      sentence.precision(4);
      sentence << scene.file.string() << ": " << vessel.name << ": pressure." << key << ": found "
               << pressure << ' ' << scene.units.stress << ", which would stretch the wall by "
               << 100 * pressure / per_stretch << " %, expected at most "
               << largest_stretch * per_stretch << ' ' << scene.units.stress
               << ": are its unit (units.pressure) and the wall's right?";
      throw InputError(sentence.str());
    }
  seen.pressure = {vessel.pressure->scan / units.stress, vessel.pressure->after / units.stress};
  return seen;
}

void apply(const EndProblem& end, Section& section) {
  section.fixed = end.fixed;
  section.move = end.move;
  section.rotation = end.rotation;
  section.force = end.force;
  section.moment = end.moment;
  section.moment_in_body = end.moment_in_body;
}

}  // namespace vasorod::fem
