// Tubes carried by a rod, for the tests of the paper's surface energies.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>
#include <random>

#include "bodies/body_problem.h"
#include "bodies/spring_coefficients.h"
#include "geometry/triangle_surface.h"

namespace vasorod::testing {

/// Staggered rows of near-equilateral triangles along +z, outward orientation; vertex (row j, k) is
/// j * around + k.
inline TriangleSurface tube(double radius, double length, int around, int along) {
  TriangleSurface t;
  t.points.resize(around * (along + 1), 3);
  for (int j = 0; j <= along; ++j)
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5 * (j % 2)) / around;
      t.points.row(j * around + k) << radius * std::cos(angle), radius * std::sin(angle),
          length * j / along;
    }
  t.triangles.resize(2 * around * along, 3);
  int row = 0;
  for (int j = 0; j < along; ++j)
    for (int k = 0; k < around; ++k) {
      const int next = (k + 1) % around, a = j * around, b = a + around;
      if (j % 2 == 0) {
        t.triangles.row(row++) << a + k, a + next, b + k;
        t.triangles.row(row++) << a + next, b + next, b + k;
      } else {
        t.triangles.row(row++) << a + k, a + next, b + next;
        t.triangles.row(row++) << a + k, b + next, b + k;
      }
    }
  return t;
}

struct Carried {
  Points points;
  std::vector<Mat3> rotations;
};

/// Sections of a straight tube along z, carried to an arc of `bend` radians in the x-z plane,
/// rotated by `twist` radians over the length and stretched by the factor `stretch`.
inline Carried bent(const Points& rest, double length, double bend, double twist, double stretch) {
  Carried c{Points(rest.rows(), 3), {}};
  for (int i = 0; i < rest.rows(); ++i) {
    const double s = rest(i, 2) / length, angle = bend * s;
    const double arc = stretch * length;
    const Vec3 center =
        bend == 0 ? Vec3(0, 0, arc * s)
                  : Vec3(arc / bend * (1 - std::cos(angle)), 0, arc / bend * std::sin(angle));
    const Mat3 r =
        (Eigen::AngleAxisd(angle, Vec3::UnitY()) * Eigen::AngleAxisd(twist * s, Vec3::UnitZ()))
            .matrix();
    c.points.row(i) = (center + r * Vec3(rest(i, 0), rest(i, 1), 0)).transpose();
    c.rotations.push_back(r);
  }
  return c;
}

inline Points random_points(int count, unsigned seed, double size = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  Points p(count, 3);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) p(i, k) = uniform(random);
  return p;
}

inline std::vector<Mat3> random_rotations(int count, unsigned seed) {
  const Points axes = random_points(count, seed);
  std::vector<Mat3> r;
  for (int i = 0; i < count; ++i)
    r.push_back(
        Eigen::AngleAxisd(axes.row(i).norm(), axes.row(i).transpose().normalized()).matrix());
  return r;
}

/// Largest difference between a gradient and central differences of the value, over the gradient's
/// largest entry.
template <class Value>
double gradient_error(const Value& value, const Points& p, const Points& gradient,
                      double step = 1e-5) {
  double worst = 0;
  for (int i = 0; i < p.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      Points plus = p, minus = p;
      plus(i, k) += step;
      minus(i, k) -= step;
      worst = std::max(worst, std::abs((value(plus) - value(minus)) / (2 * step) - gradient(i, k)));
    }
  return worst / gradient.cwiseAbs().maxCoeff();
}

/// The same for a Hessian (3n x 3n, dense) and differences of the gradient.
template <class Gradient>
double hessian_error(const Gradient& gradient, const Points& p, const Eigen::MatrixXd& hessian,
                     double step = 1e-5) {
  double worst = 0;
  for (int i = 0; i < p.size(); ++i) {
    Points plus = p, minus = p;
    plus.data()[i] += step;
    minus.data()[i] -= step;
    const Points difference = (gradient(plus) - gradient(minus)) / (2 * step);
    worst = std::max(
        worst,
        (Eigen::Map<const Eigen::VectorXd>(difference.data(), difference.size()) - hessian.col(i))
            .cwiseAbs()
            .maxCoeff());
  }
  return worst / hessian.cwiseAbs().maxCoeff();
}

/// Expands a V x V matrix, the same for x, y and z, to a dense 3V x 3V matrix.
inline Eigen::MatrixXd for_xyz(const Eigen::SparseMatrix<double>& matrix) {
  const Eigen::MatrixXd dense(matrix);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(3 * dense.rows(), 3 * dense.cols());
  for (int r = 0; r < dense.rows(); ++r)
    for (int c = 0; c < dense.cols(); ++c)
      full.block<3, 3>(3 * r, 3 * c) = dense(r, c) * Mat3::Identity();
  return full;
}

}  // namespace vasorod::testing
