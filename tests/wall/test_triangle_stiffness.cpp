#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wall/triangle_stiffness.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

// A triangle with a corner at the origin.
struct Corners {
  Eigen::Matrix2d edges;
  Eigen::Matrix<double, 2, 3> gradients;  // of the corners' linear functions
  Corners(const Vec2& x1, const Vec2& x2) {
    edges << x1, x2;
    gradients.rightCols<2>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.col(1) - gradients.col(2);
  }
};

TEST(TriangleStiffness, FlatWallIsItsSectionTimesTheArea) {
  WallSection section{-0.2, 0.3, Vec3::Zero(), plane_stress(Material::isotropic(2, 0.3)),
                      Vec2(1, 1)};
  const auto [edges, gradients] = Corners({2, 0.1}, {0.5, 1.5});
  // A quadratic surface w = 1/2 x.c x (towards the inside): b_k is the sum of its slopes; b_k g_k
  // g_k^T gives c again.
  const Vec6 y = (Vec6() << 0.1, -0.2, 0.3, 0.05, 0.02, -0.04).finished();
  Vec3 c = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec2 g = gradients.col(k);
    c += y[3 + k] * Vec3(g[0] * g[0], g[1] * g[1], 2 * g[0] * g[1]);
  }
  Vec6 ec;
  ec << y.head<3>(), c;
  const double area = edges.determinant() / 2;
  EXPECT_NEAR(y.dot(triangle_stiffness(gradients, section) * y),
              area * ec.dot(wall_section_stiffness(section) * ec), 1e-14);
}

// The piece of wall that a law for large strains starts from has the same stiffness, with all
// corrections.
TEST(TriangleStiffness, ThePieceOfWallHasTheSameStiffness) {
  const auto [edges, gradients] = Corners({0.8, 0.1}, {0.2, 0.7});
  for (const Vec3& b : {Vec3(0, 0, 0), Vec3(0, 0.6, 0), Vec3(-0.2, 0.5, 0.1)})
    for (const double inner : {-0.2, -0.4}) {
      const WallSection section{inner, inner + 0.4, b, plane_stress(Material::isotropic(1, 0.45)),
                                Vec2(0.35, 0.35)};
      const WallPiece piece = wall_piece(gradients, section);
      const Mat6 k = triangle_stiffness(gradients, section);
      EXPECT_LT((piece.area * piece.strains.transpose() * wall_section_stiffness(section) *
                     piece.strains -
                 k)
                    .norm(),
                1e-14 * k.norm())
          << b.transpose();
    }
}

// A cylinder stretched along its axis and widened uniformly: the facets' energy relative to the
// smooth wall's.
double relative_error(int around, double along, double wider) {
  const double r = 1, l = 2, t = 0.2, small = 1e-4;
  const Material m = Material::isotropic(1, 0.3);
  const WallEnergy wall(tube_wall(tube(l, r, around, around / 2), t, m, false));
  Eigen::VectorXd q = wall.rest();
  for (int i = 0; i < wall.vertices(); ++i) {
    q[3 * i] *= 1 + small * wider;
    q[3 * i + 1] *= 1 + small * wider;
    q[3 * i + 2] *= 1 + small * along;
  }
  Vec6 y;  // c of the hoop: (1 + e) / R - 1 / R
  y << small * along, small * wider, 0, 0, small * wider / r, 0;
  const Vec2 shear(m.shear_axial, m.shear_axial);
  const double exact =
      M_PI * r * l *
      y.dot(wall_section_stiffness({-t / 2, t / 2, Vec3(0, 1 / r, 0), plane_stress(m), shear}) * y);
  return wall.value(q) / exact - 1;
}

TEST(TriangleStiffness, FacetsStandForTheSmoothCylinder) {
  for (const auto& [along, wider] :
       {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{1.0, -0.3}}) {
    const double coarse = relative_error(16, along, wider), fine = relative_error(32, along, wider);
    EXPECT_LT(std::abs(fine), 1e-3) << along << " " << wider;
    EXPECT_LT(std::abs(fine), 0.3 * std::abs(coarse) + 1e-4) << along << " " << wider;
  }
}

TEST(TriangleStiffness, SliverAcrossTheCurvatureStaysBounded) {
  WallSection section{-0.1, 0.1, Vec3(0, 1, 0), plane_stress(Material::isotropic(1, 0.3)),
                      Vec2(0.4, 0.4)};
  Eigen::Matrix2d edges;  // 0.5 along the hoop, a hundredth of that across
  edges << 0, 0.005, 0.5, 0.25;
  Eigen::Matrix<double, 2, 3> gradients;
  gradients.rightCols<2>() = edges.inverse().transpose();
  gradients.col(0) = -gradients.col(1) - gradients.col(2);
  const Mat6 k = triangle_stiffness(gradients, section);
  const double area = 0.5 * 0.5 * 0.005;
  EXPECT_TRUE(k.allFinite());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat6>(k).eigenvalues().minCoeff(), 0);
  EXPECT_GT(k(0, 0), 0.2 * area);
  EXPECT_LT(k(0, 0), 0.4 * area);
}

}  // namespace
}  // namespace vasorod
