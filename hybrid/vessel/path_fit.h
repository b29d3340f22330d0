// One axis while it is being fitted to the vertices of its path.
#pragma once

#include <array>
#include <optional>

#include "vessel/centerline.h"

namespace vasorod {

/// The parameter near `u` with (p - r(u)) . r'(u) = 0: the section through p. Steps are at most
/// `radius` long.
double section_through(const Spline<3>& axis, const Vec3& p, double u, double radius);

/// The parameter in the domain at which `axis` comes closest to p; `radius` is the scale on which
/// the axis bends.
double closest_parameter(const Spline<3>& axis, const Vec3& p, double radius);

class PathFit {
 public:
  /// `area`: per vertex of the surface; what vertices weigh before there is an axis.
  PathFit(const TriangleSurface& surface, const Eigen::VectorXd& area, const AxisPath& path);

  AxisCurve curve;
  std::optional<Vec3> first;                  ///< where the axis begins
  Vec3 last = Vec3::Zero();                   ///< where it ends
  std::vector<std::array<double, 2>> broken;  ///< parameter intervals whose sections are not whole

  double radius() const { return path_.radius; }
  bool stub() const { return path_.stub; }
  double u(size_t i) const { return u_[i]; }
  double at(const Vec3& p, double guess) const {
    return section_through(curve.axis, p, guess, radius());
  }
  /// Indices into the path's vertices.
  void add_triangle(const std::array<size_t, 3>& triangle) { triangles_.push_back(triangle); }

  /// Finds every vertex' section, its direction in it, and the share of directions times length it
  /// stands for.
  void project();

  /// Smooths the vertices of whole sections. The new axis is parametrised by the arc length of the
  /// present one, counted such that its whole sections begin at `clean_at` (a branch: how far they
  /// are from its parent's axis). `correct`: smooth the data plus what the present axis leaves of
  /// them, which undoes the smoothing's pull on a bend (Tukey's twicing). `smoothing`: share of
  /// full smoothing.
  void fit_axis(bool correct, double smoothing, std::optional<double> clean_at = {});

  void fit_radius();

  /// How far the wall is from round: RMS of distance from the axis minus radius, over the radius.
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
