// The plan that the page changes: the numbers of a Glenn operation, its picks as fractions.
#pragma once

#include <optional>

#include "planner/body.h"
#include "vessel/axis_route.h"

namespace vasorod::planner {

struct Plan {
  double cut_along = 0.5;       ///< fraction of the vein's axis, 0 at the kept end
  double cut_tilt_deg = 0;      ///< degrees, -75 to 75
  double incision_along = 0.5;  ///< fraction of the artery's axis
  double around_deg = 0;        ///< degrees about the artery's axis, -360 to 360
  double incision_length = 1;   ///< over half the perimeter of the mouth; ellipse: over the whole
  std::optional<double> ellipse_ratio;  ///< width over length; empty: a slit
  std::optional<double> rotation_deg;   ///< degrees; empty: automatic
  /// Empty: as in the opened scene.
  std::optional<RouteEnds> cut_route, incision_route;

  bool operator==(const Plan&) const = default;
};

/// Reads the `plan` of a request. Throws Refusal.
Plan read_plan(const Body& body);
Json json_of(const Plan& plan);

}  // namespace vasorod::planner
