// What the operation did to a vessel (design.md section 2, "Judge"): per-vertex fields and their
// extremes.
#pragma once

#include <vasorod/result.h>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Per-vertex fields from the rod's strains, interpolated linearly between its nodes along the
/// vertex's section.
struct VertexFields {
  Eigen::VectorXd axial_stretch;  ///< (v3 + u1 y - u2 x) over its rest value: stretch of the fibre
                                  ///< through the vertex
  Eigen::VectorXd twist_shear;    ///< (u3 - u3^0) times the vertex's rest distance to the axis
};

VertexFields vertex_fields(const PreparedVessel& vessel, const RodPoses& poses);

/// Extremes over the vessel and where they occur. `current`: the deformed surface (points on it are
/// given as places). Flattening is the largest 1 - H / H_rest, H the mid-wall section's width in
/// one direction of its frame (for a round tube Brazier's 1 - H / 2R); the lumen is the mid-wall
/// section moved in by half the thickness. Sections that are not one closed curve (at forks, ends
/// and the incision) are left out; with `sections` false both stay at their rest values: nothing
/// moved.
VesselMetrics vessel_metrics(const PreparedVessel& vessel, const RodPoses& poses,
                             const VertexFields& fields, const Points& current,
                             const Eigen::VectorXd& pressure, bool sections);

}  // namespace vasorod
