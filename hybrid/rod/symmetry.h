// Motions that leave a whole scene as it is: the rod turned and moved rigidly while every section
// turns back about its own axis. Along them the energy is constant, so an equilibrium off the axis
// is one of a family: the plane in which a column buckles is free, and so is the side to which a
// twisted rod between coaxial clamps bulges.
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

/// Independent symmetries of the conditions and sections that move the state. Each is checked at
/// finite angles.
std::vector<RodSymmetry> symmetries(const RodProblem& problem, const RodState& state);

/// Where a spring stops the motion along a symmetry and nothing else: the node that moves most, and
/// its motion there. An equilibrium's step is then as definite as without the symmetry.
std::vector<GaugeSpring> gauge_springs(const RodProblem& problem, const RodState& state);

/// "turning the rod about the axis (0, 0, 1) through (0, 0, 0) while its sections turn back".
std::string describe(const RodProblem& problem, const RodSymmetry& symmetry);

}  // namespace vasorod
