#include "wall/wall_section.h"

#include <Eigen/LU>
#include <array>

namespace vasorod {

namespace {

using Mat2 = Eigen::Matrix2d;

// Gauss points on [-1, 1]: five points integrate the thin wall exactly, and 1/Z to 1e-6 at
// t/R = 0.5.
constexpr std::array<double, 5> abscissa{0, 0.5384693101056831, -0.5384693101056831,
                                         0.9061798459386640, -0.9061798459386640};
constexpr std::array<double, 5> weight{0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                       0.2369268850561891, 0.2369268850561891};

Vec3 voigt(const Mat2& m) {
  return {m(0, 0), m(1, 1), m(0, 1) + m(1, 0)};
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
  for (size_t i = 0; i < abscissa.size(); ++i) {
    const double z = middle + half * abscissa[i];
    const Mat2 shifter = Mat2::Identity() + z * b;
    const Mat2 inverse = shifter.inverse();
    Eigen::Matrix<double, 3, 6> strain;
    for (int k = 0; k < 3; ++k) {
      const Mat2& m = unit[static_cast<size_t>(k)];
      strain.col(k) = voigt((m - z * m * b) * inverse);
      strain.col(3 + k) = voigt(z * m * inverse);
    }
    stiffness +=
        half * weight[i] * shifter.determinant() * strain.transpose() * s.stiffness * strain;
  }
  return stiffness;
}

double shear_compliance(const WallSection& s, const Vec2& d, double curvature) {
  return 4 * curvature * curvature /
         (5.0 / 6 * d.cwiseAbs2().dot(s.shear_modulus) * (s.outer - s.inner));
}

void add_bending_compliance(Mat6& stiffness, const Vec2& d, double compliance) {
  Vec6 bend = Vec6::Zero();
  bend.tail<3>() << d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1];
  // (K^-1 + compliance bend bend^T)^-1 by Sherman and Morrison
  const Vec6 moment = stiffness * bend;
  stiffness -= compliance / (1 + compliance * bend.dot(moment)) * moment * moment.transpose();
}

}  // namespace vasorod
