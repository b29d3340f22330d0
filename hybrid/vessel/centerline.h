// The axis of a tubular surface: smooth curves through the centres of its sections, and the
// sections' radii.
//
// A section is the set of surface points whose plane normal to the axis passes through one axis
// point. Its centre is the point about which its points, averaged over their directions, have no
// offset, and its radius is the mean of their distances over directions: circle and ellipse give
// their own centre, and noise of the wall averages out. Both come from all vertices at once. A
// vertex stands for the share of the (arc length, direction) plane that its triangles cover, so the
// axis is the weighted penalised spline through the vertices themselves, each at the position of
// its own section. Sections that the surface does not close (beside an oblique end, at a fork) are
// left out and bridged by the spline.
#pragma once

#include <array>

#include "vessel/axis_paths.h"
#include "vessel/spline.h"

namespace vasorod {

/// One smooth axis. A path begins at the first end or on its parent's axis.
struct AxisCurve {
  int parent = -1;
  int end = -1;                ///< index of the end it runs to
  double parent_u = 0;         ///< parameter on the parent's axis where this one begins
  double clean_start = 0;      ///< parameter from which its sections are whole
  Spline<3> axis;              ///< length over length, parameter nearly the arc length
  double first = 0, last = 0;  ///< parameters at which it begins and at which its end's centre lies
  Spline<1> radius;
  std::vector<std::array<double, 2>> forks;  ///< parameter intervals where other paths leave
};

struct Centerline {
  std::vector<AxisCurve> curves;  ///< parents before children
  AxisPaths paths;                ///< which vertex belongs to which curve
  std::vector<double> position;   ///< per vertex: the parameter of its section on its curve
};

/// Centroid of the closed polygon's perimeter.
Vec3 perimeter_centroid(const Points& points, const std::vector<int>& loop);

/// Fits the axis of a connected surface of genus 0 with at least two ends.
Centerline fit_centerline(const TriangleSurface& surface, const std::vector<Edge>& edges,
                          const std::vector<std::vector<int>>& loops);

}  // namespace vasorod
