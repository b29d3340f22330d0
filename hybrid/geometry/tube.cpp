#include <Eigen/Geometry>
#include <cmath>

#include <vasorod/tube.h>

namespace vasorod {

Pose tube_axis(const TubeSpec& tube, double s) {
  const double total = tube.bend_deg * M_PI / 180;
  const double angle = total * s / tube.length;
  const Vec3 binormal = tube.tangent.cross(tube.normal);
  // Chord form of the arc: exact, with the straight line as its limit and not as a special case.
  const double half = angle / 2;
  const double chord = s * (std::abs(half) < 1e-8 ? 1 : std::sin(half) / half);
  Pose pose;
  pose.position =
      tube.position + chord * (std::cos(half) * tube.tangent + std::sin(half) * tube.normal);
  pose.rotation.col(0) = std::cos(angle) * tube.normal - std::sin(angle) * tube.tangent;
  pose.rotation.col(1) = binormal;
  pose.rotation.col(2) = std::cos(angle) * tube.tangent + std::sin(angle) * tube.normal;
  return pose;
}

double tube_radius(const TubeSpec& tube, double s) {
  return tube.radius + (tube.end_radius.value_or(tube.radius) - tube.radius) * s / tube.length;
}

Eigen::VectorXd tube_arc_lengths(const TubeSpec& tube) {
  Eigen::VectorXd s(tube.around * (tube.along + 1));
  for (int row = 0; row <= tube.along; ++row)
    s.segment(row * tube.around, tube.around).setConstant(tube.length * row / tube.along);
  return s;
}

TriangleSurface tube_surface(const TubeSpec& tube) {
  const int n = tube.around;
  TriangleSurface surface;
  surface.points.resize(n * (tube.along + 1), 3);
  for (int row = 0; row <= tube.along; ++row) {
    const double s = tube.length * row / tube.along;
    const Pose axis = tube_axis(tube, s);
    const double radius = tube_radius(tube, s);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * M_PI * (i + 0.5 * (row % 2)) / n;
      surface.points.row(row * n + i) =
          axis * Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  surface.triangles.resize(2 * n * tube.along, 3);
  int t = 0;
  for (int row = 0; row < tube.along; ++row)
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      const int a = row * n + i, b = row * n + next, c = a + n, d = b + n;
      if (row % 2 == 0) {  // the row above is rotated forwards: c is above the middle of a, b
        surface.triangles.row(t++) << a, b, c;
        surface.triangles.row(t++) << b, d, c;
      } else {  // the row above is rotated backwards: d is above the middle of a, b
        surface.triangles.row(t++) << a, b, d;
        surface.triangles.row(t++) << a, d, c;
      }
    }
  return surface;
}

Eigen::VectorXd tube_thickness(const TubeSpec& tube, double thickness) {
  const double change = tube.end_thickness.value_or(thickness) - thickness;
  return (thickness + (change / tube.length) * tube_arc_lengths(tube).array()).matrix();
}

}  // namespace vasorod
