// Tubes between rigid ends compared with closed forms: the wall's accuracy, not only its
// consistency.
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "numerics/cholesky.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

constexpr double radius = 10, nu = 0.3, shear_modulus = 1 / (2 * (1 + nu));

// Newton on the unknowns that are not held; held unknowns keep their values in q.
void minimise(WallEnergy& wall, const std::vector<char>& held, const Eigen::VectorXd& load,
              Eigen::VectorXd& q, int steps) {
  std::vector<int> number(held.size(), -1);
  int n = 0;
  for (size_t i = 0; i < held.size(); ++i)
    if (!held[i]) number[i] = n++;
  Cholesky cholesky;
  for (int step = 0; step < steps; ++step) {
    Eigen::VectorXd g;
    wall.gradient(q, g);
    g -= load;
    const Eigen::SparseMatrix<double>& full = wall.hessian(q);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right(n), change(n);
    for (int c = 0; c < full.cols(); ++c) {
      const int column = number[static_cast<size_t>(c)];
      if (column < 0) continue;
      right[column] = -g[c];
      for (Eigen::SparseMatrix<double>::InnerIterator it(full, c); it; ++it)
        if (const int row = number[static_cast<size_t>(it.row())]; row >= 0)
          entries.emplace_back(row, column, it.value());
    }
    Eigen::SparseMatrix<double> reduced(n, n);
    reduced.setFromTriplets(entries.begin(), entries.end());
    if (step == 0) cholesky.analyse(reduced);
    ASSERT_TRUE(cholesky.factorise(reduced));
    cholesky.solve(right.data(), change.data(), 1);
    for (size_t i = 0; i < held.size(); ++i)
      if (!held[i]) q[static_cast<Eigen::Index>(i)] += change[number[i]];
  }
}

// A tube whose end is stretched by `stretch` and rotated by `turn` about the axis: its state and
// reaction.
struct Pulled {
  WallInput input;
  Eigen::VectorXd q, reaction;
  double force = 0, torque = 0;
};

Pulled pull(double length, double thickness, double poisson, double stretch, double turn,
            Law law = Law::biot) {
  Pulled p;
  const int around = 32;
  const int along =
      2 * static_cast<int>(std::lround(length / (2 * M_PI * radius / around * 0.866) / 2));
  p.input = tube_wall(tube(length, radius, around, along), thickness,
                      Material::isotropic(1, poisson, law), true);
  WallEnergy wall(p.input);
  std::vector<char> held(static_cast<size_t>(wall.unknowns()), 0);
  p.q = wall.rest();
  for (int i = 0; i < wall.vertices(); ++i) {
    const double s = p.q[3 * i + 2] / length;
    p.q.segment<3>(3 * i) = exp_rotation(Vec3(0, 0, turn * s)) * p.q.segment<3>(3 * i);
    p.q[3 * i + 2] *= 1 + stretch;
    for (int k = 0; k < 3; ++k)
      held[static_cast<size_t>(3 * i + k)] = p.input.glued[static_cast<size_t>(i)];
  }
  for (const WallEdge& e : wall.edges()) {
    if (!e.glued) continue;
    const bool end = wall.rest()[3 * e.a + 2] > length / 2;
    p.q.segment<3>(e.unknown) =
        exp_rotation(Vec3(0, 0, end ? turn : 0)) * wall.rest().segment<3>(e.unknown);
    for (int k = 0; k < 3; ++k) held[static_cast<size_t>(e.unknown + k)] = 1;
  }
  minimise(wall, held, Eigen::VectorXd::Zero(wall.unknowns()), p.q, 4);
  wall.gradient(p.q, p.reaction);
  const auto add_torque = [&](int at) {
    p.torque += p.q.segment<3>(at).cross(p.reaction.segment<3>(at)).z();
  };
  for (int i = 0; i < wall.vertices(); ++i) {
    if (wall.rest()[3 * i + 2] < length / 2 || !p.input.glued[static_cast<size_t>(i)]) continue;
    p.force += p.reaction[3 * i + 2];
    add_torque(3 * i);
  }
  for (const WallEdge& e : wall.edges())
    if (e.glued && wall.rest()[3 * e.a + 2] > length / 2) add_torque(e.unknown);
  return p;
}

// Means of axial stretch and radius over the rows in the middle half, away from the ends.
std::pair<double, double> gauge(const Pulled& p, double length) {
  double top = 0, bottom = 0, inside = 0;
  double z1 = 0, z0 = 0;
  int n1 = 0, n0 = 0, n = 0;
  for (int i = 0; i < p.input.rest.points.rows(); ++i) {
    const double z = p.input.rest.points(i, 2);
    if (z < length / 4 || z > 3 * length / 4) continue;
    inside += std::hypot(p.q[3 * i], p.q[3 * i + 1]);
    ++n;
    if (z > length / 2) {
      top += p.q[3 * i + 2];
      z1 += z;
      ++n1;
    } else {
      bottom += p.q[3 * i + 2];
      z0 += z;
      ++n0;
    }
  }
  return {(top / n1 - bottom / n0) / (z1 / n1 - z0 / n0) - 1, inside / n / radius - 1};
}

TEST(WallTube, StretchIsEAAndNarrowsByNu) {
  const double length = 100, t = 1, area = 2 * M_PI * radius * t;
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) {
    const auto small = pull(length, t, nu, 1e-4, 0, law);
    EXPECT_NEAR(small.force / (area * gauge(small, length).first), 1, 5e-4) << to_string(law);
  }
  for (const double poisson : {0.0, 0.3, 0.45}) {
    const auto p = pull(length, t, poisson, 0.05, 0);
    const auto [stretch, wider] = gauge(p, length);
    EXPECT_NEAR(wider, -poisson * stretch, 0.002 * poisson * stretch + 1e-5) << poisson;
    EXPECT_NEAR(p.force / (area * stretch), 1, 1e-3) << poisson;
  }
}

TEST(WallTube, TwistIsGJAndStaysACylinder) {
  const double length = 100, t = 1, shear = 3e-4;
  const double polar = 2 * M_PI * std::pow(radius, 3) * t * (1 + t * t / (4 * radius * radius));
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) {
    const auto p = pull(length, t, nu, 0, shear * length / radius, law);
    EXPECT_NEAR(p.torque / (shear_modulus * polar * shear / radius), 1, 5e-5) << to_string(law);
    for (int i = 0; i < p.input.rest.points.rows(); ++i)
      EXPECT_NEAR(std::hypot(p.q[3 * i], p.q[3 * i + 1]) / radius, 1, 1e-6);
  }
}

// A neo-Hookean bar (E = 1) of the stretch l: its lateral stretch, where the lateral stress is
// zero, and its force per area at rest.
std::pair<double, double> bar(double l, double poisson) {
  const double mu = 1 / (2 * (1 + poisson)), lambda = 2 * mu * poisson / (1 - 2 * poisson);
  double low = 0.3, high = 3;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    const double stress = mu * (middle * middle - 1) + lambda * std::log(l * middle * middle);
    (stress > 0 ? high : low) = middle;
  }
  return {low, mu * (l - 1 / l) + lambda * std::log(l * low * low) / l};
}

// A tube with free rims whose end rows are held along the axis at a large stretch. Under
// compression it would wrinkle, so that there the bar's state is not relaxed.
TEST(WallTube, LargeStretchIsThatOfABar) {
  const double length = 40, t = 0.5;
  const int around = 24, along = 18;
  for (const double poisson : {0.3, 0.45})
    for (const double l : {0.7, 0.85, 1.2, 1.5}) {
      WallInput in = tube_wall(tube(length, radius, around, along), t,
                               Material::isotropic(1, poisson, Law::neo_hookean), false);
      WallEnergy wall(in);
      const auto [across, stress] = bar(l, poisson);
      Eigen::VectorXd q = wall.rest();
      std::vector<char> held(static_cast<size_t>(wall.unknowns()), 0);
      for (int i = 0; i < wall.vertices(); ++i) {
        const double z = q[3 * i + 2];
        q.segment<2>(3 * i) *= across;
        q[3 * i + 2] *= l;
        held[static_cast<size_t>(3 * i + 2)] = z < 1e-9 || z > length - 1e-9;
      }
      // three numbers against rigid motions in the plane; the tube narrows towards vertex 0
      held[0] = held[1] = held[3 * around / 2 + 1] = 1;
      if (l > 1) minimise(wall, held, Eigen::VectorXd::Zero(wall.unknowns()), q, 6);
      Eigen::VectorXd g;
      wall.gradient(q, g);
      double force = 0, left = 0, inside = 0;
      Vec3 middle = Vec3::Zero();
      for (int i = 0; i < around; ++i) middle += q.segment<3>(3 * i) / around;
      for (int i = 0; i < wall.vertices(); ++i) {
        if (wall.rest()[3 * i + 2] > length - 1e-9) force += g[3 * i + 2];
        inside += (q.segment<2>(3 * i) - middle.head<2>()).norm() / wall.vertices();
      }
      for (size_t i = 0; i < held.size(); ++i)
        if (!held[i]) left = std::max(left, std::abs(g[static_cast<Eigen::Index>(i)]));
      EXPECT_LT(left, l > 1 ? 1e-9 : 5e-3 * std::abs(force)) << l;
      // facets, and the wall's lever arms that do not thin: (t/R)^2
      EXPECT_NEAR(force / (2 * M_PI * radius * t) / stress, 1, 5e-3) << l << " " << poisson;
      EXPECT_NEAR(inside / radius, across, 2e-3) << l << " " << poisson;
    }
}

}  // namespace
}  // namespace vasorod
