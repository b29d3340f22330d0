// Where two vessels meet end to end: both rods in equilibrium with each other.
#pragma once

#include <array>
#include <optional>

#include "rod/newton.h"

namespace vasorod {

/// A rod with a rim that is to meet another's.
struct RimRod {
  const RodTree* rod = nullptr;
  RodConditions held;  ///< at its other nodes
  int node = 0;        ///< the rim's node
  /// The rim at rest: its centre, and as third axis its normal out of the vessel.
  Pose rim;
  double radius = 0;  ///< of the rim, length
};

/// Two rods whose rims meet.
struct Meeting {
  std::array<RodSolution, 2> rods;
  /// `held` with the pose of the rim's node.
  std::array<RodConditions, 2> conditions;
  double rotation = 0;   ///< of the second rim, radians; as in EndToEndSpec
  double axis_turn = 0;  ///< angle between the rims' normals at rest, 0: face to face, radians
};

/// Lays the rims on each other, centre on centre and face to face. The pose of the seam is the one
/// in which the forces and moments of both rods on it cancel, so that their energy is smallest;
/// without a `rotation` (radians, as in EndToEndSpec) the seam carries no torque about its normal
/// either. The way there shrinks the gap and the angle between the rims as they are at rest, under
/// all conditions. Where no such pose is found, the rods' status is that of the last attempt and
/// their message says so. Throws InputError as solve_rod() does.
Meeting meet(const std::array<RimRod, 2>& rims, std::optional<double> rotation,
             const RodOptions& options);

}  // namespace vasorod
