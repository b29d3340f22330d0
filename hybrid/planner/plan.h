// The plan that the page changes: the numbers of a Glenn operation, its picks as fractions.
#pragma once

#include <array>
#include <optional>

#include "planner/body.h"

namespace vasorod::planner {

/// Ranges that scene files have too (docs/scene.md).
inline constexpr std::array<double, 2> incision_lengths{0.25, 4}, cut_tilts{-75, 75},
    ellipse_ratios{0.1, 1};

/// Two open ends (indices into Vessel::ends), between which a fraction counts.
using Route = std::array<int, 2>;

struct Plan {
  double cut_along = 0.5;       ///< fraction of the vein's axis, 0 at the kept end
  double cut_tilt_deg = 0;      ///< degrees, -75 to 75
  double incision_along = 0.5;  ///< fraction of the artery's axis
  double around_deg = 0;        ///< degrees about the artery's axis, -360 to 360
  double incision_length = 1;   ///< over half the perimeter of the mouth; ellipse: over the whole
  std::optional<double> ellipse_ratio;  ///< width over length; empty: a slit
  std::optional<double> rotation_deg;   ///< degrees; empty: automatic
  /// Empty: as in the opened scene.
  std::optional<Route> cut_route, incision_route;

  bool operator==(const Plan&) const = default;
};

/// Reads the `plan` of a request. Throws Refusal.
Plan read_plan(const Body& body);
Json json_of(const Plan& plan);

}  // namespace vasorod::planner
