#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "wall/lumen.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

WallInput short_tube(Law law) {
  Material material = Material::isotropic(2, 0.3, law);
  if (law == Law::svk) material.shear_axial = 0.3;  // a fibre, with partners in shear
  return tube_wall(tube(8, 3, 9, 5), 0.3, material, true);
}

// The stress of a small displacement is the wall's own: E(u) of the wall without prestress has the
// gradient that the prestressed one has at rest, up to the square of u.
TEST(WallPrestress, IsTheStressOfItsDisplacement) {
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) {
    WallInput input = short_tube(law);
    const WallEnergy plain(input);
    Points u(input.rest.points.rows(), 3);
    const VectorXd random = noise(u.size(), 4);
    u = Eigen::Map<const Points>(random.data(), u.rows(), 3);
    for (int v = 0; v < u.rows(); ++v)
      if (input.glued[static_cast<size_t>(v)] != 0) u.row(v).setZero();
    double before = 0;
    for (const double size : {1e-3, 1e-4}) {
      input.prestress_displacement = size * u;
      WallEnergy stressed(input);
      VectorXd at_rest, displaced;
      const double stored = stressed.gradient(stressed.rest(), at_rest);
      // The free edges of the plain wall relaxed by Newton's steps.
      VectorXd q = plain.rest();
      for (Eigen::Index v = 0; v < u.rows(); ++v)
        q.segment<3>(3 * v) += size * u.row(v).transpose();
      WallEnergy moving(short_tube(law));
      const auto first = 3 * Eigen::Index{moving.vertices()};
      for (int step = 0; step < 6; ++step) {
        moving.gradient(q, displaced);
        const Eigen::MatrixXd lower =
            Eigen::MatrixXd(moving.hessian(q))
                .block(first, first, moving.free_edges(), moving.free_edges());
        const Eigen::MatrixXd h = lower.selfadjointView<Eigen::Lower>();
        q.segment(first, moving.free_edges()) -=
            h.ldlt().solve(displaced.segment(first, moving.free_edges()));
      }
      const double energy = moving.gradient(q, displaced);
      const double apart = (at_rest - displaced).head(first).norm() / displaced.head(first).norm();
      EXPECT_LT(apart, 30 * size) << to_string(law);
      EXPECT_NEAR(stored / energy, 1, 30 * size) << to_string(law);
      if (before > 0) {
        EXPECT_NEAR(apart / before, 0.1, 0.05) << to_string(law);
      }
      before = apart;
      EXPECT_LT(at_rest.segment(first, moving.free_edges()).norm(), 1e-12 * at_rest.norm());
    }
  }
}

TEST(WallPrestress, DerivativesMatchDifferences) {
  for (const bool by_shape : {false, true})
    for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) {
      WallInput input = short_tube(law);
      input.from_stress_free_shape = by_shape;
      const VectorXd random = noise(input.rest.points.size(), 4);
      input.prestress_displacement =
          0.1 * Eigen::Map<const Points>(random.data(), input.rest.points.rows(), 3);
      input.axial_prestretch = 1.1;
      WallEnergy wall(input);
      const VectorXd q = wall.rest() + 0.1 * noise(wall.unknowns(), 5);
      VectorXd g, up, down;
      wall.gradient(q, g);
      EXPECT_NEAR(wall.value(q), wall.gradient(q, g), 1e-12 * std::abs(wall.value(q)));
      const Eigen::MatrixXd lower = wall.hessian(q);
      const Eigen::MatrixXd h = lower.selfadjointView<Eigen::Lower>();
      const VectorXd along = noise(wall.unknowns(), 6);
      const double step = 1e-5;
      const double energy =
          wall.gradient(q + step * along, up) - wall.gradient(q - step * along, down);
      EXPECT_NEAR(energy / (2 * step), g.dot(along), 1e-6 * g.norm() * along.norm());
      EXPECT_LT(((up - down) / (2 * step) - h * along).norm(), 1e-6 * (h * along).norm());
      // The parts of a report are those of the energy.
      const WallReport report = wall.report(q);
      EXPECT_NEAR(report.membrane + report.bending + report.coupling, wall.value(q),
                  1e-10 * std::abs(wall.value(q)));
    }
}

// The wall of a shape without stress is the plain wall of that shape, with the thickness that thins
// to the one as seen: its energy is the same wherever its vertices are, once its edges are relaxed.
TEST(WallPrestress, IsTheWallOfTheShapeWithoutStress) {
  constexpr double widened = 1.3;  // in all directions
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) {
    WallInput seen = tube_wall(tube(8, 3, 9, 5), 0.3, Material::isotropic(2, 0.3, law), false);
    seen.mid_offset = 0.1;
    WallInput plain = seen;
    seen.prestress_displacement = (1 - 1 / widened) * seen.rest.points;
    seen.from_stress_free_shape = true;
    plain.rest.points /= widened;
    const double thicker = std::pow(widened, 2 * (1 - thinning_exponent(seen.material)));
    plain.thickness *= thicker;
    plain.mid_offset *= thicker;
    WallEnergy one(seen), other(plain);
    const auto first = 3 * Eigen::Index{one.vertices()};
    const auto relaxed = [&](WallEnergy& wall, const VectorXd& vertices) {
      VectorXd q = wall.rest(), g;
      q.head(first) = vertices;
      for (int step = 0; step < 8; ++step) {
        wall.gradient(q, g);
        const Eigen::MatrixXd lower = Eigen::MatrixXd(wall.hessian(q))
                                          .block(first, first, q.size() - first, q.size() - first);
        const Eigen::MatrixXd h = lower.selfadjointView<Eigen::Lower>();
        q.tail(q.size() - first) -= h.ldlt().solve(g.tail(q.size() - first));
      }
      return wall.gradient(q, g);
    };
    EXPECT_NEAR(relaxed(one, other.rest().head(first)), 0, 1e-20) << to_string(law);
    const VectorXd somewhere = other.rest().head(first) + 0.1 * noise(first, 7);
    const double energy = relaxed(other, somewhere);
    EXPECT_NEAR(relaxed(one, somewhere), energy, 1e-10 * energy) << to_string(law);
    // As seen its edges are relaxed.
    VectorXd g;
    one.gradient(one.rest(), g);
    EXPECT_LT(g.tail(g.size() - first).norm(), 1e-12 * g.norm()) << to_string(law);
    EXPECT_LT((one.rest().head(first) - widened * other.rest().head(first)).norm(), 1e-13);
  }
}

// A short tube with fibres, directions of leans and one glued rim, from a shape without stress.
WallInput leaning_tube() {
  Material material = Material::isotropic(2, 0.3);
  material.shear_axial = 0.3;
  WallInput input = tube_wall(tube(8, 3, 9, 5), 0.3, material, true);
  input.lean.setZero(input.rest.points.rows(), 3);
  for (int v = 0; v < input.rest.points.rows(); ++v) {
    const double z = input.rest.points(v, 2);
    if (z > 4) input.glued[static_cast<size_t>(v)] = 0;
    if (z < 2) input.lean.row(v) = Vec3(0.1, 0, 1);
  }
  input.from_stress_free_shape = true;
  input.axial_prestretch = 1.2;
  return input;
}

// Where the shape without stress lies does not count: its fibres and the directions of its leans
// turn with it.
TEST(WallPrestress, ATurnedShapeWithoutStressIsTheSame) {
  WallInput input = leaning_tube();
  input.glued.clear();  // whose normals are kept as seen
  const WallEnergy straight(input);
  const Pose motion{exp_rotation(Vec3(0.5, -0.3, 0.9)), Vec3(2, 1, -3)};
  input.prestress_displacement.resize(input.rest.points.rows(), 3);
  for (int v = 0; v < input.rest.points.rows(); ++v) {
    const Vec3 p = input.rest.points.row(v);
    input.prestress_displacement.row(v) = p - motion * p;
  }
  const WallEnergy turned(input);
  const VectorXd q = straight.rest() + 0.1 * noise(straight.unknowns(), 5);
  VectorXd one, other;
  const double energy = straight.gradient(q, one);
  EXPECT_NEAR(turned.gradient(q, other), energy, 1e-12 * energy);
  EXPECT_LT((one - other).norm(), 1e-12 * one.norm());
}

// From one shape to another the wall becomes that of the other.
TEST(WallPrestress, AnotherShapeIsThatOfAFreshWall) {
  for (const Law law : {Law::biot, Law::neo_hookean}) {
    WallInput input = leaning_tube();
    if (law == Law::neo_hookean) input.material = Material::isotropic(2, 0.3, law);
    WallEnergy wall(input);
    for (const unsigned seed : {4u, 5u}) {
      const VectorXd random = noise(input.rest.points.size(), seed);
      input.prestress_displacement =
          0.1 * Eigen::Map<const Points>(random.data(), input.rest.points.rows(), 3);
      input.axial_prestretch = 1 + 0.02 * seed;
      wall.set_stress_free_shape(input);
      WallEnergy fresh(input);
      const VectorXd q = fresh.rest() + 0.1 * noise(fresh.unknowns(), 6);
      VectorXd one, other;
      const double energy = fresh.gradient(q, one);
      EXPECT_LT((wall.rest() - fresh.rest()).norm(), 1e-13) << to_string(law);
      EXPECT_NEAR(wall.gradient(q, other), energy, 1e-11 * energy) << to_string(law);
      EXPECT_LT((one - other).norm(), 1e-11 * one.norm()) << to_string(law);
      const Eigen::MatrixXd of_fresh = fresh.hessian(q), of_wall = wall.hessian(q);
      EXPECT_LT((of_fresh - of_wall).norm(), 1e-11 * of_fresh.norm()) << to_string(law);
    }
  }
}

// The strain of a linear prestress is the one that its displacement has.
TEST(WallPrestress, ItsStrainIsThatOfItsDisplacement) {
  WallInput input = tube_wall(tube(8, 3, 96, 40), 0.3, Material::isotropic(2, 0), false);
  EXPECT_EQ(WallEnergy(input).rms_prestrain(), 0);
  Mat3 gradient;
  gradient << 0.02, 0, 0, 0, 0.02, 0, 0.03, 0, 0.01;
  input.prestress_displacement = input.rest.points * gradient.transpose();
  input.axial_prestretch = 1.04;
  // Around e = 0.02; along 0.05; their shear is half of 0.03 times the cosine of the angle around,
  // of whose square the mean is a half.
  const double expected = std::sqrt(0.02 * 0.02 + 0.05 * 0.05 + 2 * 0.015 * 0.015 / 2);
  EXPECT_NEAR(WallEnergy(input).rms_prestrain(), expected, 1e-4 * expected);
}

// A tube stretched along its fibre pulls at its ends with E t times the strain.
TEST(WallPrestress, APrestretchPullsAtTheEnds) {
  for (const bool by_shape : {false, true}) {
    WallInput input = tube_wall(tube(30, 5, 48, 30), 0.25, Material::isotropic(2, 0.3), true);
    input.axial_prestretch = 1.02;
    input.from_stress_free_shape = by_shape;
    const WallEnergy wall(input);
    VectorXd g;
    wall.gradient(wall.rest(), g);
    Vec3 end = Vec3::Zero();
    double inside = 0;
    for (int v = 0; v < wall.vertices(); ++v) {
      if (input.rest.points(v, 2) > 30 - 1e-9) end += g.segment<3>(3 * v);
      if (input.glued[static_cast<size_t>(v)] == 0)
        inside = std::max(inside, g.segment<3>(3 * v).norm());
    }
    double force = 2 * 0.02 * 0.25 * 48 * 2 * 5 * std::sin(M_PI / 48);
    // On the section without stress, which is wider and thicker.
    const double across = 1 - 0.3 * 0.02;
    if (by_shape) force /= across * std::pow(1.02 * across, thinning_exponent(input.material) - 1);
    EXPECT_NEAR(end.z(), force, 2e-3 * force);
    EXPECT_LT(inside, 2e-3 * force / 48);
  }
}

}  // namespace
}  // namespace vasorod
