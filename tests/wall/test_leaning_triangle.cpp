// Walls that shear across their thickness, against beams and shells that do.
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <complex>
#include <functional>
#include <gtest/gtest.h>

#include "data/index.h"
#include "wall/leaning_triangle.h"
#include "wall/shear_band.h"
#include "wall/triangle_stiffness.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// A flat strip in the plane z = 0, `cells` long and wide with the fibre along x, glued at x = 0.
WallInput strip(double length, double width, int along, int across, double thickness,
                const Material& material) {
  WallInput in;
  in.rest.points.resize((along + 1) * (across + 1), 3);
  const auto at = [&](int i, int j) { return i * (across + 1) + j; };
  in.glued.assign(index(at(along, across) + 1), 0);
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      in.rest.points.row(at(i, j)) << length * i / along, width * j / across, 0;
      in.glued[index(at(i, j))] = i == 0;
    }
  in.rest.triangles.resize(2 * along * across, 3);
  int t = 0;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j)
      if ((i + j) % 2 == 0) {
        in.rest.triangles.row(t++) << at(i, j), at(i + 1, j), at(i + 1, j + 1);
        in.rest.triangles.row(t++) << at(i, j), at(i + 1, j + 1), at(i, j + 1);
      } else {
        in.rest.triangles.row(t++) << at(i, j), at(i + 1, j), at(i, j + 1);
        in.rest.triangles.row(t++) << at(i + 1, j), at(i + 1, j + 1), at(i, j + 1);
      }
  in.axis.assign(index(t), Vec3::UnitX());
  in.thickness = VectorXd::Constant(in.rest.points.rows(), thickness);
  in.material = material;
  return in;
}

Points all_along(const WallInput& in, const Vec3& direction) {
  return Points(direction.transpose().replicate(in.rest.points.rows(), 1));
}

// The displacement that a small load causes, and small prescribed values of q where they are held.
VectorXd response(WallEnergy& wall, const std::vector<char>& held, const VectorXd& load,
                  const VectorXd& prescribed) {
  const Sparse h = wall.hessian(wall.rest()).selfadjointView<Eigen::Lower>();
  const VectorXd force = load - h * prescribed;
  std::vector<int> free, place(held.size(), -1);
  for (size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) {
      place[i] = static_cast<int>(free.size());
      free.push_back(static_cast<int>(i));
    }
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < h.cols(); ++c)
    for (Sparse::InnerIterator it(h, c); it; ++it)
      if (place[index(it.row())] >= 0 && place[index(c)] >= 0)
        entries.emplace_back(place[index(it.row())], place[index(c)], it.value());
  const auto n = static_cast<Eigen::Index>(free.size());
  Sparse k(n, n);
  k.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> factor(k);
  EXPECT_TRUE((factor.vectorD().array() > 0).all());
  VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) right[i] = force[free[index(i)]];
  const VectorXd x = factor.solve(right);
  VectorXd moved = prescribed;
  for (Eigen::Index i = 0; i < n; ++i) moved[free[index(i)]] = x[i];
  return moved;
}

std::vector<char> held_of(const WallEnergy& wall, const WallInput& in) {
  std::vector<char> held(index(wall.unknowns()), 0);
  for (int v = 0; v < wall.vertices(); ++v)
    for (int k = 0; k < 3; ++k) held[index(3 * v + k)] = in.glued[index(v)];
  for (const WallEdge& e : wall.edges())
    if (e.glued)
      for (int k = 0; k < 3; ++k) held[index(e.unknown + k)] = 1;
  return held;
}

// Mean deflection of the strip's end under a force of 1 there.
double tip(const WallInput& in, double length) {
  WallEnergy wall(in);
  VectorXd load = VectorXd::Zero(wall.unknowns());
  double weights = 0;
  for (const WallEdge& e : wall.edges()) {
    if (!e.rim || in.rest.points(e.a, 0) < length - 1e-9 || in.rest.points(e.b, 0) < length - 1e-9)
      continue;
    const double w = (in.rest.points.row(e.a) - in.rest.points.row(e.b)).norm() / 2;
    load[3 * e.a + 2] += w;
    load[3 * e.b + 2] += w;
    weights += 2 * w;
  }
  load /= weights;
  return load.dot(response(wall, held_of(wall, in), load, VectorXd::Zero(wall.unknowns())));
}

// Timoshenko's cantilever, soft and very soft in shear; the error falls with the square of the
// mesh.
TEST(LeaningTriangle, CantileverOfTimoshenko) {
  const double length = 3, width = 1, t = 1;
  for (const double shear : {0.5, 0.05, 0.005}) {
    Material material = Material::isotropic(1, 0);
    material.shear_axial = shear;
    const double bending = 4 * std::pow(length, 3) / (width * std::pow(t, 3)),
                 exact = bending + length / (5.0 / 6 * shear * width * t);
    double before = 0;
    for (const int cells : {8, 16}) {
      WallInput in = strip(length, width, 3 * cells, cells, t, material);
      EXPECT_NEAR(tip(in, length) / bending, 1, 0.3 / (cells * cells));
      in.lean = all_along(in, Vec3::UnitX());
      const double error = tip(in, length) / exact - 1;
      EXPECT_LT(std::abs(error), 0.8 / (cells * cells)) << shear;
      if (before != 0) {
        EXPECT_LT(std::abs(error / before), 0.35) << shear;
      }
      before = error;
    }
  }
}

// Nothing locks: a thin wall with a lean is the wall without.
TEST(LeaningTriangle, ThinWallsBendAsWithout) {
  for (const double t : {1e-2, 1e-4, 1e-6}) {
    WallInput in = strip(3, 1, 12, 4, t, Material::isotropic(1, 0.3));
    const double without = tip(in, 3);
    in.lean = all_along(in, Vec3::UnitX());
    // shear adds t^2 E / (4 L^2 5/6 G) at most
    EXPECT_NEAR(tip(in, 3) / without, 1, 0.1 * t * t + 1e-8) << t;
  }
}

// With the leans eliminated, a wall that is stiff in shear across itself is the wall without them.
TEST(LeaningTriangle, StiffInShearIsTheWallWithout) {
  WallSection section;
  section.inner = -0.1;
  section.outer = 0.1;
  section.curvature << 0, 1, 0.1;
  section.stiffness = plane_stress(Material::isotropic(1, 0.3));
  section.shear_modulus.setConstant(1 / 2.6);
  Eigen::Matrix<double, 2, 3> gradients, directions;
  gradients << -3, 1, 2, -1, 4, -3;
  directions << 1, 0.8, 0.6, 0, 0.6, -0.8;
  const Mat6 k = triangle_stiffness(gradients, section);
  double before = 0;
  for (const double shear : {1e4, 1e6}) {
    section.shear_modulus.setConstant(shear);
    const LeaningTriangle l =
        leaning_triangle(gradients, section, directions, {true, false, false});
    const Mat3 of_leans = l.stiffness + l.strains.transpose() * k * l.strains;
    const Mat6 left = k - k * l.strains * of_leans.inverse() * l.strains.transpose() * k;
    const double apart = (left - k).norm() / k.norm();
    if (before > 0) {
      EXPECT_LT(apart, 1e-4);
      EXPECT_NEAR(apart / before, 1e-2, 1e-3);
    }
    before = apart;
  }
}

// The layer beside the rigid rims of a stretched tube, Reissner's shell: radial displacement over
// that far from the rims, at a distance from the rim.
std::function<double(double)> reissner(double radius, double t, double poisson, double shear) {
  const double d = t * t * t / 12 / (1 - poisson * poisson), k = t / (radius * radius),
               s = 5.0 / 6 * shear * t;
  using C = std::complex<double>;
  const C a = k / s, root = std::sqrt(a * a - 4 * k / d);
  const C m1 = std::sqrt((a + root) / 2.0), m2 = std::sqrt((a - root) / 2.0);
  // no rotation of the director at the rim
  const C f1 = -m1 + k / (m1 * s), f2 = -m2 + k / (m2 * s), c1 = -1.0 / (1.0 - f1 / f2),
          c2 = -1.0 - c1;
  return [=](double x) { return (1.0 + c1 * std::exp(-m1 * x) + c2 * std::exp(-m2 * x)).real(); };
}

// RMS difference from Reissner's layer, over the displacement far from the rims.
double from_reissner(WallInput in, bool leaning, double t, double shear) {
  const double length = in.rest.points.col(2).maxCoeff();
  if (leaning) in.lean = shear_band(in);
  WallEnergy wall(in);
  VectorXd prescribed = VectorXd::Zero(wall.unknowns());
  for (int v = 0; v < wall.vertices(); ++v)
    if (in.glued[index(v)] != 0 && in.rest.points(v, 2) > length / 2) prescribed[3 * v + 2] = 1;
  const VectorXd u = response(wall, held_of(wall, in), VectorXd::Zero(wall.unknowns()), prescribed);
  const auto radial = [&](int v) {
    return u[3 * v] * in.rest.points(v, 0) + u[3 * v + 1] * in.rest.points(v, 1);
  };
  double far = 0, sum = 0;
  int middle = 0, n = 0;
  for (int v = 0; v < wall.vertices(); ++v)
    if (std::abs(in.rest.points(v, 2) - length / 2) < length / 16) {
      far += radial(v);
      ++middle;
    }
  far /= middle;
  const auto exact = reissner(1, t, 0.3, shear);
  for (int v = 0; v < wall.vertices(); ++v) {
    if (in.rest.points(v, 2) > length / 2) continue;
    sum += std::pow(radial(v) / far - exact(in.rest.points(v, 2)), 2);
    ++n;
  }
  return std::sqrt(sum / n);
}

// A thick tube and one soft in shear. The thin layer of the soft one is half as long as a triangle.
TEST(LeaningTriangle, StretchedTubeOfReissner) {
  const auto pulled = [](double t, double shear) {
    Material material = Material::isotropic(1, 0.3);
    material.shear_axial = shear;
    return tube_wall(tube(4, 1, 48, 36), t, material, true);
  };
  const double isotropic = 1 / 2.6;
  EXPECT_LT(from_reissner(pulled(0.2, isotropic), true, 0.2, isotropic), 0.006);
  EXPECT_GT(from_reissner(pulled(0.2, isotropic), false, 0.2, isotropic), 0.02);
  EXPECT_LT(from_reissner(pulled(0.1, isotropic / 100), true, 0.1, isotropic / 100), 0.08);
  EXPECT_GT(from_reissner(pulled(0.1, isotropic / 100), false, 0.1, isotropic / 100), 0.2);
}

}  // namespace
}  // namespace vasorod
