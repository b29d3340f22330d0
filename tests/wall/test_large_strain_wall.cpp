#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "wall/large_strain_wall.h"
#include "wall/plane_stress.h"
#include "wall/principal_stretches.h"
#include "wall/wall_section.h"

namespace vasorod {
namespace {

using Mat2 = Eigen::Matrix2d;

LargeStrainWall wall(double inner, double outer, const Vec3& curvature, double nu) {
  LargeStrainWall w;
  w.inner = inner;
  w.outer = outer;
  w.curvature = curvature;
  w.shear = 1 / (2 * (1 + nu));
  w.poisson = nu;
  w.area = 1;
  return w;
}

// The mean of a function over [a, b] by Simpson's rule, times b - a.
template <typename Function>
double integral(double a, double b, const Function& f) {
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i <= n; ++i)
    sum += (i == 0 || i == n ? 1 : (i % 2 == 1 ? 4 : 2)) * f(a + (b - a) * i / n);
  return sum * (b - a) / (3 * n);
}

TEST(LargeStrainWall, AtRestItIsTheLinearWall) {
  for (const double nu : {0.0, 0.3, 0.45, 0.5})
    for (const Vec3& b : {Vec3(0, 0, 0), Vec3(0, 0.5, 0), Vec3(-0.1, 0.3, 0.2)})
      for (const double middle : {0.0, -0.3}) {
        const LargeStrainEnergy e =
            large_strain_energy(wall(middle - 0.3, middle + 0.3, b, nu), Vec6::Zero(), true);
        const Mat6 k = wall_section_stiffness(
            {middle - 0.3, middle + 0.3, b, plane_stress(Material::isotropic(1, nu)), Vec2(1, 1)});
        EXPECT_EQ(e.value, 0);
        EXPECT_EQ(e.stress.norm(), 0);
        EXPECT_LT((e.tangent - k).norm(), 1e-14 * k.norm()) << nu << " " << b.transpose();
      }
}

// Stretches of 0.5 to 1.6, bending of up to 0.5 per thickness, and states beyond a collapse.
TEST(LargeStrainWall, DerivativesAgainstDifferences) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const double t = 0.4, nu = trial % 2 == 0 ? 0.3 : 0.45;
    LargeStrainWall w = wall(-t / 2, t / 2, Vec3(0.1, 0.4, -0.2), nu);
    if (trial % 3 == 1) w = wall(-t, 0, Vec3(0, 0.3, 0), nu);
    if (trial % 3 == 2)
      for (int i = 0; i < 36; ++i) w.strains(i) += 0.2 * uniform(engine);
    Vec6 y;
    y << 0.05 + 0.55 * uniform(engine), 0.05 + 0.55 * uniform(engine), 0.3 * uniform(engine),
        0.5 / t * uniform(engine), 0.5 / t * uniform(engine), 0.5 / t * uniform(engine);
    if (trial % 10 == 9) y *= 2;
    const LargeStrainEnergy at = large_strain_energy(w, y, true);
    ASSERT_TRUE(std::isfinite(at.value));
    EXPECT_EQ(at.value, large_strain_energy(w, y, false).value);
    EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-12 * at.tangent.norm());
    const double h = 1e-6;
    for (int i = 0; i < 6; ++i) {
      const LargeStrainEnergy up = large_strain_energy(w, y + h * Vec6::Unit(i), false),
                              down = large_strain_energy(w, y - h * Vec6::Unit(i), false);
      EXPECT_NEAR((up.value - down.value) / (2 * h), at.stress[i],
                  1e-8 * (1 + at.stress.norm() + at.tangent.norm()))
          << trial << " " << i;
      EXPECT_LT(((up.stress - down.stress) / (2 * h) - at.tangent.col(i)).norm(),
                1e-6 * (1 + at.tangent.norm()))
          << trial << " " << i;
    }
  }
}

// A wide strip bent in plane strain, stretched by l on its middle: the hoop stretch at the height z
// is l (1 + z k). Energy and moment by Simpson's rule in principal stretches.
TEST(LargeStrainWall, BentStrip) {
  const double t = 1, nu = 0.45, mu = 1 / (2 * (1 + nu));
  for (const double l : {0.7, 1.0, 1.3})
    for (const double kt : {0.05, 0.3, 0.5, 1.0}) {
      const auto energy = [&](double k) {
        return mu * integral(-t / 2, t / 2, [&](double z) {
                 return neo_hookean_of_stretches(l * (1 + z * k), 1, nu);
               });
      };
      Vec6 y = Vec6::Zero();
      y[0] = l - 1;
      y[3] = l * l * kt / t;  // pulled back to rest
      const LargeStrainEnergy e =
          large_strain_energy(wall(-t / 2, t / 2, Vec3::Zero(), nu), y, false);
      const double exact = energy(kt / t), h = 1e-4;
      const double moment = (energy(kt / t + h) - energy(kt / t - h)) / (2 * h);
      // five points through the thickness
      const double error = kt <= 0.5 ? 1e-5 : 2e-3;
      EXPECT_NEAR(e.value / exact, 1, error) << l << " " << kt;
      EXPECT_NEAR(e.stress[3] * l * l / moment, 1, 3 * error) << l << " " << kt;
    }
}

// A tube of radius R at rest, widened by w and stretched by l, of its outer face.
TEST(LargeStrainWall, TubeGivenByItsOuterFace) {
  const double t = 0.6, radius = 2, nu = 0.3, mu = 1 / (2 * (1 + nu));
  for (const double wide : {0.8, 1.0, 1.4})
    for (const double l : {0.7, 1.5}) {
      // fibres at rest at radius + z go to wide * radius + z
      const double exact =
          mu * integral(-t, 0, [&](double z) {
            return (1 + z / radius) *
                   neo_hookean_of_stretches(l, (wide * radius + z) / (radius + z), nu);
          });
      Vec6 y = Vec6::Zero();
      y[0] = l - 1;
      y[1] = wide - 1;
      y[4] = wide / radius - 1 / radius;  // wide^2 / (wide R) - 1 / R
      const double value =
          large_strain_energy(wall(-t, 0, Vec3(0, 1 / radius, 0), nu), y, false).value;
      EXPECT_NEAR(value / exact, 1, 1e-6) << wide << " " << l;
    }
}

// Any strain and curvature: principal stretches of the metric a + 2 z b + z^2 b a^-1 b over the
// metric at rest.
TEST(LargeStrainWall, AnyBendingAgainstTheMetricAtEachHeight) {
  const double t = 0.5, nu = 0.3, mu = 1 / (2 * (1 + nu));
  Mat2 b0, u, b;
  b0 << 0.3, 0.1, 0.1, -0.2;
  u << 1.3, 0.2, 0.2, 0.8;
  b << 0.5, 0.3, 0.3, -0.4;
  const double exact =
      mu * integral(-t / 2, t / 2, [&](double z) {
        const Mat2 rest = (Mat2::Identity() + z * b0) * (Mat2::Identity() + z * b0);
        const Mat2 a = u * u, now = a + 2 * z * b + z * z * b * a.inverse() * b;
        const Vec2 square = Eigen::GeneralizedSelfAdjointEigenSolver<Mat2>(now, rest).eigenvalues();
        return std::sqrt(rest.determinant()) *
               neo_hookean_of_stretches(std::sqrt(square[0]), std::sqrt(square[1]), nu);
      });
  Vec6 y;
  y << u(0, 0) - 1, u(1, 1) - 1, 2 * u(0, 1), (b - b0)(0, 0), (b - b0)(1, 1), 2 * (b - b0)(0, 1);
  const LargeStrainWall w = wall(-t / 2, t / 2, Vec3(b0(0, 0), b0(1, 1), b0(0, 1)), nu);
  EXPECT_NEAR(large_strain_energy(w, y, false).value / exact, 1, 1e-6);
}

TEST(LargeStrainWall, StretchesOfTheFaces) {
  // a tube of radius 2 closed to radius 1, seen in a frame turned by 45 degrees
  Mat2 turn;
  turn << std::sqrt(0.5), -std::sqrt(0.5), std::sqrt(0.5), std::sqrt(0.5);
  const auto turned = [&](double m, double factor) {
    const Mat2 r = m * turn.col(0) * turn.col(0).transpose();
    return Vec3(r(0, 0), r(1, 1), factor * r(0, 1));
  };
  const FaceStretches s =
      face_stretches(-0.2, 0.2, turned(0.5, 1), turned(-0.5, 2), turned(0.25 - 0.5, 2));
  EXPECT_NEAR(s.least, 0.8 / 1.8, 1e-12);
  EXPECT_NEAR(s.largest, 1, 1e-12);
}

}  // namespace
}  // namespace vasorod
