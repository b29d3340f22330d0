// What a prediction did to a vessel: per-vertex fields and their extremes.
#pragma once

#include <vasorod/result.h>

#include "judge/sections.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Per-vertex fields from the rod's strains, interpolated linearly between its nodes.
struct VertexFields {
  /// (v3 + u1 y - u2 x) over its rest value: stretch of the fibre through the vertex.
  Eigen::VectorXd axial_stretch;
  Eigen::VectorXd twist_shear;  ///< (u3 - u3^0) times the vertex's rest distance to the axis
};

/// The fields of a vessel whose rod has these poses.
VertexFields vertex_fields(const PreparedVessel& vessel, const RodPoses& poses);

/// Extremes over the vessel and their places. `current`: the deformed surface; places are points on
/// it. `pressure`: of contact, per vertex; empty: not modelled. `sections`: its judged sections;
/// none (nothing moved): flattening and lumen keep their rest values. Flattening is the largest 1 -
/// H / H_rest, where H is the width of the mid-wall section in one direction of its frame (for a
/// round tube Brazier's 1 - H / 2R). `opened`: per rod element, whether an incision opens the
/// section there; such elements and those within the reach of a fork (vessel/fork_reach.h) do not
/// count in the curvature. Empty: none.
VesselMetrics vessel_metrics(const PreparedVessel& vessel, const RodPoses& poses,
                             const VertexFields& fields, const Points& current,
                             const Eigen::VectorXd& pressure,
                             const std::vector<JudgedSection>& sections,
                             const std::vector<char>& opened = {});

}  // namespace vasorod
