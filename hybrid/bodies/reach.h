// Broad phase of contact: finds the pairs of surfaces within reach from their bounding boxes.
#pragma once

#include <Eigen/Geometry>

#include <vasorod/types.h>

namespace vasorod {

using Box = Eigen::AlignedBox3d;

/// Bounding box of points (n x 3).
Box box_of(const Points& points);

/// Whether two boxes are within `margin` (length) of each other.
bool within_reach(const Box& a, const Box& b, double margin);

}  // namespace vasorod
