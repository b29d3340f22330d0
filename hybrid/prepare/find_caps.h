// The blunt closed ends of a vessel: flat, round parts of its wall behind a rim.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A flat part of the wall across a vessel, as a mask's border or a clipped model leaves it.
struct FlatCap {
  Vec3 center = Vec3::Zero();   ///< on the wall's flat part, length
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the vessel
  double radius = 0;            ///< of the circle of its area with half its rim, length
  double growth = 1;      ///< its area where normals within twice the angle count, over its own
  double oval = 1;        ///< its long axis over its short one
  double unevenness = 0;  ///< root mean square of its distance from a plane, over the radius
};

/// Connected parts of the wall whose normals are within 12 to 25 degrees of their mean, round (axes
/// 1 : 3 at most), wider than `least`, and behind a rim: where normals within twice that angle
/// count too, the part has at most 2.2 times the area (on a ball 3.9 times), and in 13 of 16
/// directions the wall falls away by 40 degrees. Ends that are short for their width have no
/// farthest point of their own, but a cap. With `named` 3 times the area and 8 directions will do,
/// for a place that is known to be an end. The sharpest rim first; one for each place.
std::vector<FlatCap> find_caps(const TriangleSurface& surface, double least, bool named = false);

/// Whether the wall is so flat, its rim so sharp and so round that an end was cut there. Dents,
/// sides and an ostium that was closed bulge more, a growth of 1.42 and an unevenness of 0.033 at
/// least; the outside of a bend is longer than wide.
bool surely_cut(const FlatCap& cap);

/// From a cap straight into the vessel to the wall opposite, over the cap's radius. The side of a
/// tube has the other side about two radii behind it.
double depth_behind(const TriangleSurface& surface, const FlatCap& cap);

}  // namespace vasorod
