#include "wall/large_strain_wall.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "wall/neo_hookean.h"
#include "wall/thickness_points.h"

namespace vasorod {

namespace {

using Mat2 = Eigen::Matrix2d;
using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

Mat2 tensor(double m11, double m22, double m12) {
  Mat2 m;
  m << m11, m12, m12, m22;
  return m;
}

// The unit strains of the order (11, 22, 2*12).
const std::array<Mat2, 3>& units() {
  static const std::array<Mat2, 3> all{tensor(1, 0, 0), tensor(0, 1, 0), tensor(0, 0, 0.5)};
  return all;
}

Vec4 components(const Mat2& m) {
  return {m(0, 0), m(0, 1), m(1, 0), m(1, 1)};
}

Mat2 adjugate(const Mat2& m) {
  Mat2 a;
  a << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
  return a;
}

double product(const Mat2& a, const Mat2& b) {
  return a.cwiseProduct(b).sum();
}

// 1 / d with its derivatives. Below `least` a parabola, so that a collapsed surface keeps finite
// forces.
struct Reciprocal {
  double value, first, second;
  explicit Reciprocal(double d) {
    constexpr double least = 0.05;
    const double at = std::max(d, least), below = d - at;
    second = 2 / (at * at * at);
    first = -1 / (at * at) + second * below;
    value = 1 / at - below / (at * at) + second * below * below / 2;
  }
};

// X = U^-1 (c - e b0) of F(z) = I + (e + z X) Z^-1 with its derivatives with respect to (e, c).
struct Turning {
  Mat2 e, b0, difference, inverse;  // inverse: of U
  Reciprocal reciprocal;
  Mat2 value;
  std::array<Mat2, 6> first;
  std::array<Mat2, 3> by_strain;  // of `inverse`
  Vec3 area;                      // of det U

  Turning(const Vec6& p, const Mat2& curvature)
      : e(tensor(p[0], p[1], p[2] / 2)),
        b0(curvature),
        difference(tensor(p[3], p[4], p[5] / 2) - e * b0),
        reciprocal((1 + p[0]) * (1 + p[1]) - p[2] * p[2] / 4) {
    const Mat2 adjoint = adjugate(Mat2::Identity() + e);
    inverse = reciprocal.value * adjoint;
    value = inverse * difference;
    area << 1 + p[1], 1 + p[0], -p[2] / 2;
    for (size_t i = 0; i < 3; ++i) {
      by_strain[i] = reciprocal.value * adjugate(units()[i]) +
                     reciprocal.first * area[static_cast<int>(i)] * adjoint;
      first[i] = by_strain[i] * difference - inverse * units()[i] * b0;
      first[3 + i] = inverse * units()[i];
    }
  }

  // r : d2 X, added to the tangent.
  void add_second(const Mat2& r, Mat6& tangent) const {
    const Mat2 adjoint = adjugate(Mat2::Identity() + e);
    const Mat2 by_inverse = r * difference.transpose();  // of r : (inverse difference)
    Mat3 second_area = Mat3::Zero();
    second_area(0, 1) = second_area(1, 0) = 1;
    second_area(2, 2) = -0.5;
    Vec3 adjoints;
    for (int i = 0; i < 3; ++i)
      adjoints[i] = product(by_inverse, adjugate(units()[static_cast<size_t>(i)]));
    const double whole = product(by_inverse, adjoint);
    Mat3 block = reciprocal.first * (adjoints * area.transpose() + area * adjoints.transpose() +
                                     whole * second_area) +
                 reciprocal.second * whole * area * area.transpose();
    for (int i = 0; i < 3; ++i) {
      const Mat2 turned = by_strain[static_cast<size_t>(i)].transpose() * r;
      for (int j = 0; j < 3; ++j) {
        const Mat2& unit = units()[static_cast<size_t>(j)];
        const double cross = product(turned, unit * b0);
        block(i, j) -= cross;
        block(j, i) -= cross;
        const double mixed = product(turned, unit);
        tangent(i, 3 + j) += mixed;
        tangent(3 + j, i) += mixed;
      }
    }
    tangent.topLeftCorner<3, 3>() += block;
  }
};

// Sums over the thickness of z^n times the derivatives of the energy per volume with respect to
// Y = e + z X.
struct Sums {
  double value = 0;
  std::array<Vec4, 2> stress{Vec4::Zero(), Vec4::Zero()};
  std::array<Mat4, 3> tangent{Mat4::Zero(), Mat4::Zero(), Mat4::Zero()};

  void add(const Mat2& y, const Mat2& shifter, double z, double weight, double poisson,
           bool with_tangent) {
    const double size = shifter.determinant();
    const Mat2 back = adjugate(shifter) / size, d = y * back;
    const AreaEnergy u = neo_hookean_area(d.trace() + d.determinant(), poisson);
    // D11 - D22 and D12 + D21 as products with Y
    const Vec4 apart(back(0, 0), back(0, 1), -back(0, 1), -back(1, 1));
    const Vec4 shear(back(0, 1), back(1, 1), back(0, 0), back(0, 1));
    const Mat2 now = shifter + y;
    const Vec4 area = Vec4(now(1, 1), -now(1, 0), -now(0, 1), now(0, 0)) / size;
    const double a = d(0, 0) - d(1, 1), s = d(0, 1) + d(1, 0), w = weight * size;
    value += w * ((a * a + s * s) / 2 + u.value);
    const Vec4 force = w * (a * apart + s * shear + u.first * area);
    stress[0] += force;
    stress[1] += z * force;
    if (!with_tangent) return;
    Mat4 t =
        apart * apart.transpose() + shear * shear.transpose() + u.second * area * area.transpose();
    t(0, 3) += u.first / size;
    t(3, 0) += u.first / size;
    t(1, 2) -= u.first / size;
    t(2, 1) -= u.first / size;
    tangent[0] += w * t;
    tangent[1] += w * z * t;
    tangent[2] += w * z * z * t;
  }
};

}  // namespace

LargeStrainEnergy large_strain_energy(const LargeStrainWall& wall, const Vec6& y,
                                      bool with_tangent) {
  const Vec6 p = wall.strains * y;
  const Mat2 b0 = tensor(wall.curvature[0], wall.curvature[1], wall.curvature[2]);
  const Turning x(p, b0);
  const double half = (wall.outer - wall.inner) / 2, middle = (wall.outer + wall.inner) / 2;
  Sums sums;
  for (size_t i = 0; i < thickness_point_count; ++i) {
    const double z = middle + half * thickness_abscissa[i];
    sums.add(x.e + z * x.value, Mat2::Identity() + z * b0, z, half * thickness_weight[i],
             wall.poisson, with_tangent);
  }
  const double modulus = wall.shear * wall.area;
  Eigen::Matrix<double, 4, 6> by_e = Eigen::Matrix<double, 4, 6>::Zero(), by_x;
  for (int i = 0; i < 3; ++i) by_e.col(i) = components(units()[static_cast<size_t>(i)]);
  for (int i = 0; i < 6; ++i) by_x.col(i) = components(x.first[static_cast<size_t>(i)]);
  LargeStrainEnergy energy;
  energy.value = modulus * sums.value;
  energy.stress = modulus * wall.strains.transpose() *
                  (by_e.transpose() * sums.stress[0] + by_x.transpose() * sums.stress[1]);
  if (!with_tangent) return energy;
  const Mat6 mixed = by_e.transpose() * sums.tangent[1] * by_x;
  Mat6 tangent = by_e.transpose() * sums.tangent[0] * by_e + mixed + mixed.transpose() +
                 by_x.transpose() * sums.tangent[2] * by_x;
  Mat2 moment;
  moment << sums.stress[1][0], sums.stress[1][1], sums.stress[1][2], sums.stress[1][3];
  x.add_second(moment, tangent);
  energy.tangent = modulus * wall.strains.transpose() * tangent * wall.strains;
  return energy;
}

FaceStretches face_stretches(double inner, double outer, const Vec3& curvature, const Vec3& strain,
                             const Vec3& bend) {
  const Mat2 b0 = tensor(curvature[0], curvature[1], curvature[2]);
  Vec6 p;
  p << strain, bend;
  const Turning x(p, b0);
  FaceStretches found;
  for (const double z : {inner, outer}) {
    const Mat2 f = Mat2::Identity() + (x.e + z * x.value) * (Mat2::Identity() + z * b0).inverse();
    // the singular values of a 2 x 2 matrix, the smaller one with the sign of the determinant
    const double sum = std::hypot(f(0, 0) + f(1, 1), f(0, 1) - f(1, 0)),
                 spread = std::hypot(f(0, 0) - f(1, 1), f(0, 1) + f(1, 0));
    found.least = std::min(found.least, (sum - spread) / 2);
    found.largest = std::max(found.largest, (sum + spread) / 2);
  }
  return found;
}

}  // namespace vasorod
