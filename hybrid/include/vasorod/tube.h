// Generated tubes: triangle surfaces of near-equilateral staggered rows around a straight or
// circular axis.
#pragma once

#include <optional>

#include <vasorod/types.h>

namespace vasorod {

/// A generated tube, along +z from the origin unless placed. Radii are those of the mid-wall.
struct TubeSpec {
  double length = 0,    ///< arc length of the axis, length
      radius = 0;       ///< mid-wall radius at the start, length
  int around = 48,      ///< vertices per row
      along = 80;       ///< rows of triangles; there is one more row of vertices
  double bend_deg = 0;  ///< total angle of the circular axis, degrees, turning towards `normal`
  std::optional<double> end_radius,  ///< mid-wall radius at the end, length; empty: `radius`
      end_thickness;                 ///< wall thickness at the end, length; empty: as at the start
  Vec3 position = Vec3::Zero(),      ///< start of the axis, length
      tangent = Vec3::UnitZ(),       ///< unit tangent at the start
      normal = Vec3::UnitX();        ///< unit normal at the start, orthogonal to the tangent
};

/// Frame of the axis at arc length s, 0 to length: d3 is the tangent, d1 = normal at s = 0; the
/// frame rotates about the constant d2 = d3 x d1.
Pose tube_axis(const TubeSpec& tube, double s);

/// Mid-wall radius at arc length s (length), linear from `radius` to `end_radius`.
double tube_radius(const TubeSpec& tube, double s);

/// The mid-wall surface: (along + 1) rows of `around` vertices, row by row from s = 0. Every second
/// row is rotated by half a step; the first vertex of row 0 lies on the normal. All vertices lie on
/// the mid-wall surface, so the triangles lie slightly inside it.
TriangleSurface tube_surface(const TubeSpec& tube);

/// Arc length of each vertex of tube_surface, length.
Eigen::VectorXd tube_arc_lengths(const TubeSpec& tube);

/// Wall thickness at each vertex of tube_surface (length), linear from `thickness` to
/// `end_thickness`.
Eigen::VectorXd tube_thickness(const TubeSpec& tube, double thickness);

}  // namespace vasorod
