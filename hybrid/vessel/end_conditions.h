// Converts a scene's `ends:` to the supports and loads of a fitted vessel's rod.
#pragma once

#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "rod/conditions.h"
#include "vessel/vessel.h"

namespace vasorod {

/// One open end with entries in the scene.
struct ConditionedEnd {
  std::string label;  ///< as in the scene: start, end, near(x, y, z), face(n)
  int end = 0;        ///< index into Vessel::ends
  /// The wall is glued to a disk: a held, moved or loaded end whose section is not soft.
  bool rigid = false;
};

/// Conditions of one vessel.
struct VesselConditions {
  RodConditions rod;                 ///< supports and loads of the rod
  std::vector<ConditionedEnd> ends;  ///< the ends with entries
  bool acts = false;                 ///< something moves or loads the vessel
};

/// Index of the selected open end. `start` contains the lowest point index; `end` is the other of
/// two ends; `near` has the nearest centre, at most two of its radii away; `face` was closed by the
/// lid of that name. Throws InputError (with the scene's line) if the selector does not select one
/// end.
int find_end(const Vessel& vessel, const EndSelector& selector, const std::string& where);

/// All entries of `scene.ends` for this vessel. A load and a fix of one end are combined. Throws
/// InputError if two entries for one end exclude each other.
VesselConditions end_conditions(const Scene& scene, const std::string& name, const Vessel& vessel);

}  // namespace vasorod
