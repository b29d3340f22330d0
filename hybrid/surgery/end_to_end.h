// The end-to-end join of two prepared vessels in the rest configuration: cut them or take their
// ends, lay the rims on each other, pair them.
#pragma once

#include <array>

#include <vasorod/scene.h>

#include "surgery/operation.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// A vessel and the conditions at its ends.
struct VesselToJoin {
  PreparedVessel& vessel;
  VesselConditions& conditions;
};

/// Perimeters of two rims beyond this factor are not joined: the wider one would be gathered, or
/// the narrower stretched, to a multiple of itself.
inline constexpr double largest_perimeter_ratio = 2;

/// Joins the two vessels (in the order of `spec.rims`) in place: surfaces, arrays, rods and
/// bindings become those after surgery (remaining points in the input's order, then new ones). The
/// conditions lose the ends of stumps. They gain the pose of the rim and, where the scene has no
/// support at the kept end of a cut vessel, or at any other end of a whole one, clamps there.
/// Throws InputError for picks more than a radius off their vessel, a cut that leaves nothing, a
/// tilt that leaves the vessel, a joined end that has a condition, or rims whose perimeters differ
/// too much.
Operation join_end_to_end(const Scene& scene, const EndToEndSpec& spec,
                          const std::array<VesselToJoin, 2>& vessels,
                          const OperationOptions& options = {});

}  // namespace vasorod
