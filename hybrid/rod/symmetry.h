// Symmetries of a whole scene: the rod moves and turns rigidly while every section turns back about
// its own axis. The energy is constant along them, so an equilibrium off the symmetry axis is a
// member of a family. For example, the plane in which a column buckles is arbitrary, and so is the
// side to which a twisted rod between coaxial clamps bulges.
#pragma once

#include <string>
#include <vector>

#include "rod/rod_problem.h"

namespace vasorod {

/// zeta = (move + turn x r, turn + roll d3) at every node; scaled units, space axes about the
/// scaled origin.
struct RodSymmetry {
  Vec3 move = Vec3::Zero(), turn = Vec3::Zero();
  double roll = 0;  ///< only where every section is isotropic and naturally straight
};

/// Independent symmetries of the conditions and sections that move the state. Each is verified at
/// finite angles.
std::vector<RodSymmetry> symmetries(const RodProblem& problem, const RodState& state);

/// Springs that stop motion along the symmetries and nothing else: each acts at the node that moves
/// most, along its motion. The step at an equilibrium is then as well determined as without the
/// symmetry.
std::vector<GaugeSpring> gauge_springs(const RodProblem& problem, const RodState& state);

/// For example "turning the rod about the axis (0, 0, 1) through (0, 0, 0) while its sections turn
/// back".
std::string describe(const RodProblem& problem, const RodSymmetry& symmetry);

}  // namespace vasorod
