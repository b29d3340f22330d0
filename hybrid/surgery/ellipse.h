// An incision that takes an ellipse out of the wall, its axis parallel to the rod, its centre at
// the pick.
#pragma once

#include "surgery/incision.h"

namespace vasorod {

/// Perimeter of an ellipse of that length and width, by arithmetic-geometric means.
double ellipse_perimeter(double length, double width);

/// The length of the ellipse of that width with that perimeter, which is at least pi * width (a
/// circle).
double ellipse_length(double perimeter, double width);

/// Takes an ellipse out of the wall. It is drawn on the wall unrolled about the pick
/// (geometry/flat_chart.h), `length` along the rod and `width` across it, both on the wall. The
/// outcome's tips are the two points of the rim on the axis along the rod. The Euler number
/// decreases by 1, and no new edge is shorter than 5 % of the mean edge. Other parameters as in
/// `open_incision`. Throws InputError if the pick is more than `max_distance` off the surface, if
/// the ellipse meets an open end or a fork (with the size of the same shape that fits), goes too
/// far around the vessel, or is too small for the surface's triangles.
IncisionOutcome open_ellipse(const TriangleSurface& surface, const RodTree& rod,
                             const Binding& binding, const std::vector<int>& branch_of,
                             const Vec3& pick, double length, double width, double max_distance);

}  // namespace vasorod
