#include <gtest/gtest.h>

#include "wall/held_thickness.h"

namespace vasorod {
namespace {

// The energy is that of a wall shorter by delta: 1/2 E' t delta e^2, against finite elements.
TEST(HeldThickness, ShortensAsFiniteElementsDo) {
  const double t = 0.7;
  for (const auto& [poisson, delta] :
       {std::pair{0.1, 0.00178}, std::pair{0.2, 0.00862}, std::pair{0.3, 0.02406},
        std::pair{0.4, 0.0549}, std::pair{0.45, 0.08003}, std::pair{0.49, 0.10738}}) {
    const Material material = Material::isotropic(3, poisson);
    for (const Vec2& d : {Vec2(1, 0), Vec2(0, 1), Vec2(0.6, -0.8)}) {
      const Vec3 strain(d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]);
      const double modulus = 3 / (1 - poisson * poisson);
      EXPECT_NEAR(strain.dot(held_thickness(material, t, d) * strain) / (modulus * t * t), delta,
                  0.025 * delta)
          << poisson;
    }
  }
}

// A wall without contraction keeps its thickness anyway.
TEST(HeldThickness, NothingWithoutContraction) {
  EXPECT_EQ(held_thickness(Material::isotropic(1, 0), 0.2, Vec2(1, 0)).norm(), 0);
  const Material fibred{Law::biot, 2, 1, 0.1, 0.4, 0};
  const Mat3 k = held_thickness(fibred, 0.2, Vec2(1, 0));
  EXPECT_EQ(k(0, 0), 0);
  EXPECT_GT(k(1, 1), 0);
}

}  // namespace
}  // namespace vasorod
