// A straight tube bent to a hairpin.
#pragma once

#include <algorithm>
#include <cmath>

#include <vasorod/types.h>

namespace vasorod::testing {

/// The points of a straight tube along z from the origin, of this length, on an axis that turns by
/// half a circle of radius `bend` in its middle: its legs run along -z at x = 0 and x = 2 bend.
inline Points hairpin(const Points& tube, double length, double bend) {
  Points bent = tube;
  const double arc = M_PI * bend, leg = (length - arc) / 2;
  for (Eigen::Index i = 0; i < bent.rows(); ++i) {
    const Vec3 p = tube.row(i);
    const double angle = std::clamp((p.z() - leg) / bend, 0.0, M_PI);
    const double beyond = p.z() < leg ? p.z() - leg : std::max(0.0, p.z() - leg - arc);
    const Vec3 centre(bend - bend * std::cos(angle), 0, bend * std::sin(angle));
    const Vec3 out(std::cos(angle), 0, -std::sin(angle)), on(std::sin(angle), 0, std::cos(angle));
    bent.row(i) = centre + p.x() * out + Vec3(0, p.y(), 0) + beyond * on;
  }
  return bent;
}

}  // namespace vasorod::testing
