// Generated tubes: a triangle surface of near-equilateral staggered rows around a straight or
// circular axis.
#pragma once

#include <optional>

#include <vasorod/types.h>

namespace vasorod {

/// A generated tube: mid-wall radius, along +z from the origin unless placed.
struct TubeSpec {
  double length = 0, radius = 0;
  int around = 48, along = 80;  ///< vertices per row; strips of triangles (one row more)
  double bend_deg = 0;          ///< total angle of the circular axis, turning towards `normal`
  std::optional<double> end_radius, end_thickness;
  Vec3 position = Vec3::Zero(), tangent = Vec3::UnitZ(),
       normal = Vec3::UnitX();  ///< tangent, normal: orthonormal
};

/// The axis at arc length s, 0 to length: d3 along it, d1 = normal at s = 0, rotating about the
/// constant d2 = d3 x d1.
Pose tube_axis(const TubeSpec& tube, double s);

/// Mid-wall radius at arc length s, linear from `radius` to `end_radius`.
double tube_radius(const TubeSpec& tube, double s);

/// (along + 1) rows of `around` vertices, row by row from s = 0; every second row is turned by half
/// a step, the first vertex of row 0 lies on the normal. All vertices lie on the mid-wall surface,
/// so triangles lie slightly inside.
TriangleSurface tube_surface(const TubeSpec& tube);

/// Arc length of each vertex of tube_surface.
Eigen::VectorXd tube_arc_lengths(const TubeSpec& tube);

/// Wall thickness at each vertex of tube_surface, linear from `thickness` to `end_thickness`.
Eigen::VectorXd tube_thickness(const TubeSpec& tube, double thickness);

}  // namespace vasorod
