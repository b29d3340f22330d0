// Fits one axis to the vertices of its path.
#pragma once

#include <array>
#include <optional>

#include "vessel/centerline.h"

namespace vasorod {

/// The parameter near `u` with (p - r(u)) . r'(u) = 0: the section through p. Newton steps are
/// limited to `radius`.
double section_through(const Spline<3>& axis, const Vec3& p, double u, double radius);

/// The parameter in the domain at which `axis` is closest to p. `radius`: the length scale on which
/// the axis bends.
double closest_parameter(const Spline<3>& axis, const Vec3& p, double radius);

/// The state of one fit.
class PathFit {
 public:
  /// `area`: per vertex of the surface; the weights before there is an axis.
  PathFit(const TriangleSurface& surface, const Eigen::VectorXd& area, const AxisPath& path);

  AxisCurve curve;                            ///< the fitted curve
  std::optional<Vec3> first;                  ///< where the axis begins
  Vec3 last = Vec3::Zero();                   ///< where the axis ends
  std::vector<std::array<double, 2>> broken;  ///< parameter intervals without closed sections

  double radius() const { return path_.radius; }
  bool stub() const { return path_.stub; }
  double u(size_t i) const { return u_[i]; }
  double at(const Vec3& p, double guess) const {
    return section_through(curve.axis, p, guess, radius());
  }
  /// Adds a triangle; indices into the path's vertices.
  void add_triangle(const std::array<size_t, 3>& triangle) { triangles_.push_back(triangle); }

  /// Computes for every vertex its section, its direction in the section, and its weight: the share
  /// of direction times length.
  void project();

  /// Smooths the vertices of closed sections. The new axis is parametrised by the arc length of the
  /// current axis, counted so that its closed sections begin at `clean_at` (for a branch: their
  /// distance from the parent's axis). `correct`: smooth the data plus the residual of the current
  /// axis, which removes the bias of the smoothing in a bend (Tukey's twicing). `smoothing`: share
  /// of full smoothing.
  void fit_axis(bool correct, double smoothing, std::optional<double> clean_at = {});

  void fit_radius();

  /// How far the wall is from round: RMS of (distance from the axis - radius) over the radius.
  double roughness() const;

 private:
  Vec3 point(int v) const { return surface_.points.row(v); }
  double weight(size_t i) const;
  std::vector<double> directions() const;
  void check_length() const;

  const TriangleSurface& surface_;
  const AxisPath& path_;
  std::vector<std::array<size_t, 3>> triangles_;
  std::vector<double> u_, share_;
  double start_ = 0, end_ = 0;  // domain of the next fit
};

}  // namespace vasorod
