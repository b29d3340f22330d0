// The Glenn operation on two prepared vessels in the rest configuration: cut the vein, place its
// rod, open the incision, pair mouth and rim.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <vasorod/result.h>
#include <vasorod/scene.h>

#include "rod/newton.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// The outcome of an operation.
struct GlennOperation {
  GlennReport report;  ///< without seam gaps and opened area, which belong to a solution
  /// Equilibrium of the kept vein's rod between its far end and the mouth's pose.
  RodSolution vein;
  int mouth_node = 0;  ///< rod node of the mouth
  /// True: the mouth is the end of the rod; false: the mouth is the rod's root.
  bool mouth_is_branch_end = true;
  TriangleSurface stump;  ///< closed surface of the part cut off
  /// {vertex of the vein, vertex of the recipient}, in order around the seam.
  std::vector<std::array<int, 2>> pairs;
  std::vector<Stage> stages;  ///< "cut" and "incision", with the two vessels
};

/// Options of `operate`.
struct GlennOptions {
  RodOptions rod;  ///< options of the rod solver
  /// Called with one line of text at each step.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// Operates on `svc` and `rpa` in place: surfaces, arrays, rods and bindings become those after
/// surgery (remaining points in the input's order, then new ones). `svc_conditions` loses the ends
/// of the stump. It gains the pose of the mouth and, if the scene has no entry for the kept far
/// end, a clamp there. Throws InputError for picks more than a radius off their vessel, a cut that
/// leaves nothing, a tilt that leaves the vein, or an incision that does not fit.
GlennOperation operate(const Scene& scene, const GlennSpec& spec, PreparedVessel& svc,
                       PreparedVessel& rpa, VesselConditions& svc_conditions,
                       const GlennOptions& options = {});

}  // namespace vasorod
