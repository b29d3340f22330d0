// From a scene's `ends:` to what holds, moves and loads a fitted vessel's rod.
#pragma once

#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "rod/conditions.h"
#include "vessel/vessel.h"

namespace vasorod {

/// One open end that the scene says something about.
struct ConditionedEnd {
  std::string label;  ///< as the scene names it: start, end, near(x, y, z)
  int end = 0;        ///< index into Vessel::ends
  bool rigid =
      false;  ///< the wall is glued to a disk there: a held, moved or loaded end that is not soft
};

struct VesselConditions {
  RodConditions rod;
  std::vector<ConditionedEnd> ends;
  bool acts = false;  ///< something moves or loads the vessel
};

/// The open end a selector means: `start` holds the lowest point index; `end` is the other of two;
/// `near` has the nearest centre, at most two of its radii off. Throws InputError (with the scene's
/// line) where that is not one end.
int find_end(const Vessel& vessel, const EndSelector& selector, const std::string& where);

/// All entries of `scene.ends` for this vessel; a load and a fix of one end add up. Throws
/// InputError where two entries mean one end and exclude each other.
VesselConditions end_conditions(const Scene& scene, const std::string& name, const Vessel& vessel);

}  // namespace vasorod
