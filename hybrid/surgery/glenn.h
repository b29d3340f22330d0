// The Glenn operation on two prepared vessels, all of it in the rest configuration (design.md
// section 2): cut the vein, open the incision, pose the vein's rod, pair mouth and rim.
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

struct GlennOperation {
  GlennReport report;  ///< seam gaps and opened area still zero: they belong to a solution
  RodSolution
      vein;  ///< equilibrium of the kept vein's rod between its far end and the mouth's pose
  int mouth_node = 0;  ///< rod node of the mouth
  bool mouth_is_branch_end =
      true;               ///< the rod runs towards the mouth; false: the mouth is its root
  TriangleSurface stump;  ///< what the cut leaves behind, closed
  std::vector<std::array<int, 2>>
      pairs;  ///< {vertex of the vein, vertex of the recipient}, in order round the seam
  std::vector<Stage> stages;  ///< "cut" and "incision", with the two vessels
};

struct GlennOptions {
  RodOptions rod;
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// Operates on `svc` and `rpa` in place: their surfaces, arrays, rods and bindings become those
/// after surgery (points in the input's order where surgery left them, new ones after).
/// `svc_conditions` loses the ends that went with the stump and gains a clamp at the kept far end
/// where the scene says nothing of it, and the mouth's pose. Throws InputError on picks more than a
/// radius off their vessel, a cut that leaves nothing, an incision that does not fit.
GlennOperation operate(const Scene& scene, const GlennSpec& spec, PreparedVessel& svc,
                       PreparedVessel& rpa, VesselConditions& svc_conditions,
                       const GlennOptions& options = {});

}  // namespace vasorod
