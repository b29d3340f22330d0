// A surface whose sections are sums of harmonics that vary along the vessel as B-splines:
//
//   x(theta, u) = sum_i sum_m B_i(u) phi_m(theta) c_im
#pragma once

#include <Eigen/Core>

#include <vasorod/types.h>

#include "sections/axial_basis.h"
#include "sections/harmonics.h"

namespace vasorod {

/// Harmonics around and B-splines along: the space of a shape.
struct SectionSpace {
  int harmonics = 4;
  AxialBasis along{8, 3};

  int modes() const { return harmonic_count(harmonics); }
  int row_size() const { return 3 * modes(); }  ///< coefficients of one B-spline
};

/// Derivatives of a surface at a point: x_u, x_theta, x_uu, x_utheta, x_thetatheta. Length.
using SurfaceJet = Eigen::Matrix<double, 3, 5>;

/// A surface of that kind.
struct SectionShape {
  SectionSpace space;
  /// row_size() x along.count(), length: column i holds c_im with the modes of x first, then those
  /// of y and z.
  Eigen::MatrixXd coefficients;

  Vec3 point(double u, double theta) const;
  SurfaceJet jet(double u, double theta) const;
};

/// The same surface in another space: exact where that contains it, else interpolated along and
/// without the harmonics that the other lacks.
SectionShape in_space(const SectionShape& shape, const SectionSpace& space);

/// The right-handed frame (n, along x_theta, rest) of a surface at a point: of a glued rim it turns
/// rigidly with its section.
Mat3 surface_frame(const SurfaceJet& jet);

}  // namespace vasorod
