// From a prepared vessel and its conditions to the wall of the coupled minimum.
#pragma once

#include "coupled/held_section.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// The vessel's surface as a wall: thickness of its sections, the rod's tangent as fibre, the
/// scene's material.
WallInput wall_of(const PreparedVessel& vessel);

/// The sections of the vessel's ends that its conditions hold or load, and per section the rod's
/// node. Supports at `left_out` (a node, -1: none) are no section's: what poses a mouth is its
/// join.
struct VesselSections {
  std::vector<HeldSection> sections;
  std::vector<int> nodes;
};
VesselSections sections_of(const Vessel& vessel, const VesselConditions& conditions, int left_out);

/// The shape a rod has when its strains have gone a share of the way from rest to those of `poses`:
/// a path on which a bend neither stretches nor shortens the rod, as moving its ends in proportion
/// would.
RodPoses share_of_strain(const RodTree& rod, const RodPoses& poses, double share);

}  // namespace vasorod
