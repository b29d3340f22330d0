// Broad phase of contact: which pairs of surfaces can come within reach, by their boxes.
#pragma once

#include <Eigen/Geometry>

#include <vasorod/types.h>

namespace vasorod {

using Box = Eigen::AlignedBox3d;

Box box_of(const Points& points);

/// Whether two boxes come within `margin` of each other (length unit).
bool within_reach(const Box& a, const Box& b, double margin);

}  // namespace vasorod
