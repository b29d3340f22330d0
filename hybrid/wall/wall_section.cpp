#include "wall/wall_section.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "wall/thickness_points.h"

namespace vasorod {

namespace {

using Mat2 = Eigen::Matrix2d;

Vec3 voigt(const Mat2& m) {
  return {m(0, 0), m(1, 1), m(0, 1) + m(1, 0)};
}

// Bending along the unit direction d, as (e, c).
Vec6 unit_bend(const Vec2& d) {
  Vec6 bend = Vec6::Zero();
  bend.tail<3>() << d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1];
  return bend;
}

}  // namespace

Mat6 wall_section_stiffness(const WallSection& s) {
  Mat2 b;
  b << s.curvature[0], s.curvature[2], s.curvature[2], s.curvature[1];
  std::array<Mat2, 3> unit;
  unit[0] << 1, 0, 0, 0;
  unit[1] << 0, 0, 0, 1;
  unit[2] << 0, 0.5, 0.5, 0;
  const double half = (s.outer - s.inner) / 2, middle = (s.outer + s.inner) / 2;
  Mat6 stiffness = Mat6::Zero();
  for (size_t i = 0; i < thickness_point_count; ++i) {
    const double z = middle + half * thickness_abscissa[i];
    const Mat2 shifter = Mat2::Identity() + z * b;
    const Mat2 inverse = shifter.inverse();
    Eigen::Matrix<double, 3, 6> strain;
    for (int k = 0; k < 3; ++k) {
      const Mat2& m = unit[static_cast<size_t>(k)];
      strain.col(k) = voigt((m - z * m * b) * inverse);
      strain.col(3 + k) = voigt(z * m * inverse);
    }
    stiffness += half * thickness_weight[i] * shifter.determinant() * strain.transpose() *
                 s.stiffness * strain;
  }
  return stiffness;
}

double shear_compliance(const WallSection& s, const Vec2& d, double curvature) {
  return 4 * curvature * curvature /
         (5.0 / 6 * d.cwiseAbs2().dot(s.shear_modulus) * (s.outer - s.inner));
}

void add_bending_compliance(Mat6& stiffness, const Vec2& d, double compliance) {
  const Vec6 bend = unit_bend(d);
  // (K^-1 + compliance bend bend^T)^-1 by Sherman and Morrison
  const Vec6 moment = stiffness * bend;
  stiffness -= compliance / (1 + compliance * bend.dot(moment)) * moment * moment.transpose();
}

Mat6 less_bending(const Mat6& stiffness, const Vec2& d, double compliance) {
  // M = I - f bend moment^T; f is the root of 2 f - f^2 bend.moment = compliance / (1 + compliance
  // bend.moment) that vanishes with the compliance.
  const Vec6 bend = unit_bend(d), moment = stiffness * bend;
  const double along = bend.dot(moment);
  return Mat6::Identity() -
         (1 - 1 / std::sqrt(1 + compliance * along)) / along * bend * moment.transpose();
}

}  // namespace vasorod
