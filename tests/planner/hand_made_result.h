// A result whose every number is written down here.
#pragma once

#include <memory>

#include "planner/stored_result.h"

namespace vasorod::planner {

/// A square of side 2 at z = 1, moved up from z = 0, and an obstacle of the same size at z = 3. The
/// axial stretch is 1 + x / 10, the contact pressure 1 kPa times y. A rod of three nodes along x.
inline Result hand_made_result() {
  Result result;
  result.scene = "hand-made";
  result.program = "vasorod 0.2.0";
  result.fidelity = "coupled";
  result.stress_unit = "kPa";
  VesselResult square;
  square.name = "square";
  square.rest.resize(4, 3);
  square.rest << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0;
  square.current = square.rest;
  square.current.col(2).setOnes();
  square.triangles.resize(2, 3);
  square.triangles << 0, 1, 2, 0, 2, 3;
  square.axial_stretch = Eigen::VectorXd::Ones(4) + square.rest.col(0) / 10;
  square.contact_pressure = square.rest.col(1);
  CenterlineResult& rod = square.centerline.emplace();
  rod.rest.resize(3, 3);
  rod.rest << 0, 1, 0, 1, 1, 0, 2, 1, 0;
  rod.current = 1.5 * rod.rest;
  rod.abscissa = {0, 1, 2};
  rod.radius = {0.5, 0.6, 0.7};
  rod.directors.assign(3, Mat3::Identity());
  rod.u.assign(3, Vec3(0.3, 0.4, 0.25));
  rod.u0.assign(3, Vec3(0, 0, 0.05));
  rod.v.assign(3, Vec3(0, 0, 1.5));
  rod.v0.assign(3, Vec3(0, 0, 1));
  rod.lumen_area = {1, std::nan(""), 3};
  rod.flattening = {0.1, std::nan(""), 0.3};
  rod.lines = {{0, 1, 2}};
  VesselResult roof = square;
  roof.name = "roof";
  roof.obstacle = true;
  roof.rest.col(2).setConstant(3);
  roof.current = roof.rest;
  roof.axial_stretch.resize(0);
  roof.contact_pressure.resize(0);
  roof.centerline.reset();
  result.vessels = {square, roof};
  return result;
}

inline std::shared_ptr<StoredResult> hand_made() {
  Result result = hand_made_result();
  const std::string json = to_json(result);
  return std::make_shared<StoredResult>("r1", std::move(result), std::nullopt, json);
}

}  // namespace vasorod::planner
