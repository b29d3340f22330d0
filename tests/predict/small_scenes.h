// Scenes made in C++ for the tests of the prediction: no files.
#pragma once

#include <gtest/gtest.h>
#include <string>

#include <vasorod/error.h>
#include <vasorod/predict.h>

namespace vasorod::testing {

/// A straight bare rod along x, d1 along y. Stiffness: GA, GA, EA, EI, EI, GJ.
inline VesselSpec bare_rod(const std::string& name, double length, int elements,
                           double bending = 50) {
  VesselSpec vessel;
  vessel.name = name;
  vessel.rod.emplace();
  RodPiece piece;
  piece.length = length;
  piece.elements = elements;
  Vec6 stiffness;
  stiffness << 1000, 1000, 2000, bending, bending, 40;
  piece.stiffness = stiffness.asDiagonal();
  vessel.rod->pieces.push_back(piece);
  return vessel;
}

/// A mid-wall tube along z from `position`, R = 6, t = 0.6, E = 1, nu = 0.3.
inline VesselSpec tube(const std::string& name, double length = 48,
                       const Vec3& position = {0, 0, 0}, int around = 24) {
  VesselSpec vessel;
  vessel.name = name;
  vessel.tube.emplace();
  vessel.tube->length = length;
  vessel.tube->radius = 6;
  vessel.tube->around = around;
  vessel.tube->along = static_cast<int>(length * around / 40);
  vessel.tube->position = position;
  vessel.surface_is = SurfaceIs::mid;
  vessel.wall = Wall{0.6, Material::isotropic(1, 0.3)};
  return vessel;
}

inline EndCondition at(const std::string& vessel, EndSelector::Kind kind) {
  EndCondition end;
  end.vessel = vessel;
  end.end.kind = kind;
  return end;
}
inline EndCondition held(const std::string& vessel, EndSelector::Kind kind, bool soft = false) {
  EndCondition end = at(vessel, kind);
  end.hold = true;
  end.soft_section = soft;
  return end;
}
inline EndCondition moved(const std::string& vessel, EndSelector::Kind kind, const Vec3& by,
                          bool soft = false) {
  EndCondition end = at(vessel, kind);
  end.move = by;
  end.soft_section = soft;
  return end;
}

/// One tube, its start held, its end pulled along the axis; both ends soft, so that the wall may
/// become thinner there as elsewhere.
inline Scene stretched_tube(double strain, const std::string& fidelity) {
  Scene scene;
  scene.name = "stretched";
  scene.vessels = {tube("aorta")};
  scene.ends = {held("aorta", EndSelector::Kind::start, true),
                moved("aorta", EndSelector::Kind::end, {0, 0, 48 * strain}, true)};
  scene.fidelity = fidelity;
  return scene;
}

/// A rod clamped at its start and bent by a moment about z at its free end.
inline Scene bent_cantilever(double length, double moment, int elements = 10) {
  Scene scene;
  scene.name = "cantilever";
  scene.vessels = {bare_rod("beam", length, elements)};
  scene.ends = {held("beam", EndSelector::Kind::start), at("beam", EndSelector::Kind::end)};
  scene.ends[1].moment = Vec3(0, 0, moment);
  scene.fidelity = "rod";
  return scene;
}

/// What a call says when it refuses; empty where it does not.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace vasorod::testing
