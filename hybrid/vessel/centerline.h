// The axis of a tubular surface: smooth curves through the centres of its sections, with the
// sections' radii.
//
// A section is the set of surface points whose plane normal to the axis passes through one axis
// point. Its centre is the point about which its points, averaged over their directions, have no
// offset; its radius is the mean of their distances over directions. For a circle or an ellipse
// this is the centre of the curve; noise of the wall averages out. Both follow from all vertices at
// once. A vertex stands for the share of the (arc length, direction) plane that its triangles
// cover, so the axis is the weighted penalised spline through the vertices themselves, each at the
// position of its own section. Sections that the surface does not close (beside an oblique end, at
// a fork) are left out; the spline bridges them.
#pragma once

#include <array>

#include "vessel/axis_paths.h"
#include "vessel/spline.h"

namespace vasorod {

/// One smooth axis. A path begins at the first end or on its parent's axis.
struct AxisCurve {
  int parent = -1;             ///< index of the parent's curve; -1 for the first
  int end = -1;                ///< index of the curve's end
  double parent_u = 0;         ///< parameter on the parent's axis where this curve begins
  double clean_start = 0;      ///< first parameter with closed sections
  Spline<3> axis;              ///< position (length) by a parameter that is nearly the arc length
  double first = 0, last = 0;  ///< parameters of the curve's start and of its end's centre
  Spline<1> radius;            ///< radius by the same parameter, length
  std::vector<std::array<double, 2>> forks;  ///< parameter intervals where other curves leave
};

/// The axes of a vessel.
struct Centerline {
  std::vector<AxisCurve> curves;  ///< parents before children
  AxisPaths paths;                ///< assigns the vertices to the curves
  std::vector<double> position;   ///< per vertex: the parameter of its section on its curve
};

/// Centroid of the closed polygon's perimeter.
Vec3 perimeter_centroid(const Points& points, const std::vector<int>& loop);

/// Fits the axes of a connected surface of genus 0 with at least two ends.
Centerline fit_centerline(const TriangleSurface& surface, const std::vector<Edge>& edges,
                          const std::vector<std::vector<int>>& loops);

}  // namespace vasorod
