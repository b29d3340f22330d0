#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>

#include "wall/plane_stress.h"
#include "wall/wall_section.h"

namespace vasorod {
namespace {

TEST(WallSection, FlatWallIsTheClassicalShell) {
  const Mat3 c = plane_stress(Material::isotropic(3, 0.3));
  const double t = 0.7;
  const Mat6 k = wall_section_stiffness({-t / 2, t / 2, Vec3::Zero(), c});
  EXPECT_LT((k.topLeftCorner<3, 3>() - t * c).norm(), 1e-14);
  EXPECT_LT((k.bottomRightCorner<3, 3>() - t * t * t / 12 * c).norm(), 1e-14);
  EXPECT_LT((k.topRightCorner<3, 3>()).norm(), 1e-15);
}

// A curved bar of rectangular section (Winkler): hoop strain (e + z chi) / (1 + z/R), where chi is
// the change of angle per rest length, e the strain of the mid line, and c = chi + e / R.
TEST(WallSection, CylinderIsWinklersCurvedBar) {
  const double t = 1, r = 2;
  const Mat6 k =
      wall_section_stiffness({-t / 2, t / 2, Vec3(0, 1 / r, 0), Vec3(1, 1, 1).asDiagonal()});
  const double logarithm = std::log((r + t / 2) / (r - t / 2));
  const double m0 = r * logarithm, m1 = r * (t - m0), m2 = -r * m1;  // int z^n / (1 + z/R) dz
  const double ee = m0 - 2 * m1 / r + m2 / (r * r), ec = m1 - m2 / r;
  EXPECT_NEAR(k(1, 1), ee, 1e-6);
  EXPECT_NEAR(k(1, 4), ec, 1e-6);
  EXPECT_NEAR(k(4, 4), m2, 1e-6);
  // along the axis: (e + z c), measure 1 + z/R
  EXPECT_NEAR(k(0, 0), t, 1e-12);
  EXPECT_NEAR(k(0, 3), t * t * t / (12 * r), 1e-12);
  EXPECT_NEAR(k(3, 3), t * t * t / 12, 1e-12);
}

// The same wall defined by its outer face: strains of the mid surface e = e_o - (t/2) (c_o - e_o
// b), and b at mid-wall.
TEST(WallSection, OuterFaceGivesTheSameHoop) {
  const double t = 1, r = 5, ro = r + t / 2;
  const Mat3 c = Vec3(1, 1, 1).asDiagonal();
  const Mat6 mid = wall_section_stiffness({-t / 2, t / 2, Vec3(0, 1 / r, 0), c});
  const Mat6 outer = wall_section_stiffness({-t, 0, Vec3(0, 1 / ro, 0), c});
  // Rest angle phi: mid length r phi, outer length ro phi. Same motion: change a of the angle and l
  // of the mid length (both per phi).
  for (const auto& [a, l] : {std::pair{0.3, 0.1}, std::pair{0.0, 1.0}, std::pair{1.0, 0.0}}) {
    const double em = l / r, eo = (l + a * t / 2) / ro;
    Vec6 ym = Vec6::Zero(), yo = Vec6::Zero();
    ym[1] = em;
    ym[4] = a / r + em / r;
    yo[1] = eo;
    yo[4] = a / ro + eo / ro;
    EXPECT_NEAR(ym.dot(mid * ym) * r, yo.dot(outer * yo) * ro, 1e-7);
  }
}

// A ring loaded by p cos 2 theta: displacement from the section's 6 x 6 stiffness compared with the
// thick ring in plane strain. A quarter of the energy is W = p^2 r^5 pi / (8 * 9 D) times 1.02916
// at t/r = 0.2, by high-order finite elements.
TEST(WallSection, ThickRingWithShear) {
  const double r = 1, nu = 0.3;
  for (const auto& [t, expected] : {std::pair{0.2, 1.02916}, std::pair{0.02, 1.000299}}) {
    const double g = 1 / (2 * (1 + nu));
    const WallSection wall{-t / 2, t / 2, Vec3(0, 1 / r, 0),
                           plane_stress(Material::isotropic(1, nu)), Vec2(g, g)};
    Mat6 k = wall_section_stiffness(wall);
    add_bending_compliance(k, Vec2::UnitY(), shear_compliance(wall, Vec2::UnitY(), 1 / r));
    // w = W cos 2 theta, v = V sin 2 theta: e = (W + 2 V) / r, chi = (4 W + 2 V) / r^2 (rotation of
    // the tangent per length), c = chi + e / r. Both vary with cos 2 theta: minimises 1/2 q.K q - W
    // over (W, V).
    Eigen::Matrix<double, 2, 2> y;  // rows e, c; columns W, V
    y << 1 / r, 2 / r, 5 / (r * r), 4 / (r * r);
    Eigen::Matrix2d section;
    section << k(1, 1), k(1, 4), k(4, 1), k(4, 4);
    const Eigen::Matrix2d stiffness = y.transpose() * section * y;
    const double w = stiffness.inverse()(0, 0);
    const double d = t * t * t / (12 * (1 - nu * nu));
    EXPECT_NEAR(w / (std::pow(r, 4) / (9 * d)), expected, 0.3 * t * t) << t;
  }
}

}  // namespace
}  // namespace vasorod
