// Converts a prepared vessel and its conditions to the wall of fidelity `coupled`.
#pragma once

#include "coupled/scan_displacement.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// The vessel's surface as a wall: thickness from its sections, fibre along the rod's tangent, the
/// scene's material.
WallInput wall_of(const PreparedVessel& vessel);

/// The end sections that the vessel's conditions hold or load, with the rod's node of each. A
/// support at the node `left_out` (-1: none) is not a section's: the join places a mouth.
struct VesselSections {
  std::vector<HeldSection> sections;
  std::vector<int> nodes;
};
VesselSections sections_of(const Vessel& vessel, const VesselConditions& conditions, int left_out);

/// PreparedVessel::prestress_displacement of a vessel as it was seen: under the pressure of the
/// scan and its axial prestretch, with the ends that have conditions held. `whole`: the others too,
/// as of a vessel that is cut. `largest_linear`: strain of a linear prestress. Empty if it has
/// neither. Throws InputError.
ScanDisplacement displacement_of_scan(const PreparedVessel& vessel,
                                      const VesselConditions& conditions, bool whole,
                                      double largest_linear,
                                      const std::function<bool()>& stop = {});

/// The rod's shape with strains at a share of the way from rest to those of `poses`. On this path a
/// bend neither stretches nor shortens the rod, which moving its ends proportionally would do.
RodPoses share_of_strain(const RodTree& rod, const RodPoses& poses, double share);

}  // namespace vasorod
