#include <cmath>
#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "wall/shear_band.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

int leaning(const Points& lean) {
  return static_cast<int>((lean.rowwise().norm().array() > 0).count());
}

// Roots of D m^4 - D k / S m^2 + k = 0, the slowest of them.
TEST(ShearBand, LayerAgainstItsPolynomial) {
  for (const double shear : {0.02, 0.3, 0.56, 5.0}) {
    const double bending = 0.3, hoop = 0.2;
    const ShearLayer layer = shear_layer(bending, hoop, shear);
    EXPECT_NEAR(layer.share, std::sqrt(bending * hoop) / (2 * shear), 1e-15);
    const double half = hoop / shear / 2, inside = half * half - hoop / bending;
    const double decay = inside < 0 ? std::sqrt((half + std::sqrt(hoop / bending)) / 2)
                                    : std::sqrt(half - std::sqrt(inside));
    EXPECT_NEAR(layer.length * decay, 1, 1e-9) << shear;
  }
}

// Winkler's foundation k = E_T t / R^2 and the plate's D beside each other; the fibre along the
// tube.
TEST(ShearBand, LayerOfATube) {
  Material material = Material::isotropic(2, 0.3);
  const double t = 0.3, radius = 3, d = 2 * t * t * t / 12 / 0.91;
  const auto share = [&](double shear) {
    return std::sqrt(2 * t / (radius * radius) * d) / (2 * 5.0 / 6 * shear * t);
  };
  const ShearLayer layer = shear_layer(material, t, radius);
  EXPECT_NEAR(layer.share, share(2 / 2.6), 1e-12);
  EXPECT_NEAR(layer.length, shear_layer(d, 2 * t / (radius * radius), 5.0 / 6 * 2 / 2.6 * t).length,
              1e-12);
  material.shear_axial = 0.05;
  EXPECT_NEAR(shear_layer(material, t, radius).share, share(0.05), 1e-12);
}

// Whole rows beside both rims of a thick tube lean along it; walls as thick as vessels, coarse
// meshes and free rims have no lean.
TEST(ShearBand, OnlyWhereItMatters) {
  const Material material = Material::isotropic(1, 0.3);
  const auto band = [&](double t, int around, int along, bool glued) {
    return shear_band(tube_wall(tube(6, 1, around, along), t, material, glued));
  };
  EXPECT_EQ(band(0.1, 48, 52, true).size(), 0);
  EXPECT_EQ(band(0.2, 24, 26, true).size(), 0);
  EXPECT_EQ(band(0.2, 48, 52, false).size(), 0);
  const WallInput in = tube_wall(tube(6, 1, 48, 52), 0.2, material, true);
  const Points lean = shear_band(in);
  ASSERT_EQ(lean.rows(), in.rest.points.rows());
  EXPECT_EQ(leaning(lean) % 48, 0);
  const Points normals = vertex_normals(in.rest);
  double farthest = 0;
  for (int v = 0; v < lean.rows(); ++v) {
    if (lean.row(v).isZero(0)) continue;
    EXPECT_NEAR(std::abs(lean(v, 2)), 1, 1e-4);
    EXPECT_LT(std::abs(lean.row(v).dot(normals.row(v))), 1e-12);
    farthest = std::max(farthest, std::min(in.rest.points(v, 2), 6 - in.rest.points(v, 2)));
  }
  const double d = std::pow(0.2, 3) / 12 / 0.91;
  const double width = 3 * shear_layer(d, 0.2, 5.0 / 6 * 0.2 / 2.6).length;
  EXPECT_LT(farthest, width);
  EXPECT_GT(farthest, width - 6.0 / 52);
}

// Softer in shear: thinner walls lean too, farther from the rim.
TEST(ShearBand, SoftInShear) {
  Material material = Material::isotropic(1, 0.3);
  material.shear_axial /= 100;
  const WallInput in = tube_wall(tube(6, 1, 48, 52), 0.1, material, true);
  const int soft = leaning(shear_band(in));
  EXPECT_GT(soft, 25 * 48);
  EXPECT_LT(soft, 36 * 48);
}

TEST(ShearBand, UnitsDoNotMatter) {
  const WallInput in = tube_wall(tube(6, 1, 48, 52), 0.2, Material::isotropic(1, 0.3), true);
  WallInput other = scaled(in, in.rest, 1e3, 1e-6);
  other.rest.points *= 1e-3;
  EXPECT_LT((shear_band(other) - shear_band(in)).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace vasorod
