#include "wall/leaning_triangle.h"

#include <Eigen/LU>
#include <algorithm>

#include "wall/shear_left.h"
#include "wall/triangle_stiffness.h"

namespace vasorod {

namespace {

// Least share of the wall's compliance in shear that a lean keeps (shear_left.h).
constexpr double least_left = 0.02;

// By how much the shear of the triangle is stiffer than the wall's.
double stiffening(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section,
                  const Eigen::Matrix<double, 2, 3>& directions) {
  Vec2 d = directions.col(0);
  for (int i = 1; i < 3; ++i) d += (d.dot(directions.col(i)) < 0 ? -1 : 1) * directions.col(i);
  if (d.isZero(0)) return 1;
  return 1 / std::max(shear_left(gradients, section, d.normalized()), least_left);
}

}  // namespace

LeaningTriangle leaning_triangle(const Eigen::Matrix<double, 2, 3>& gradients,
                                 const WallSection& section,
                                 const Eigen::Matrix<double, 2, 3>& directions,
                                 const std::array<bool, 3>& glued) {
  const WallPiece piece = curved_piece(gradients, section);
  LeaningTriangle leaning;
  Eigen::Matrix<double, 6, 3> bend = Eigen::Matrix<double, 6, 3>::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec2 d = directions.col(i), g = gradients.col(i);
    bend.col(i).tail<3>() << d[0] * g[0], d[1] * g[1], d[0] * g[1] + d[1] * g[0];
  }
  leaning.strains = piece.strains.partialPivLu().solve(bend);
  // b_k = 2 h_k slope: on a glued rim the surface's slope lacks the mean lean of the edge's ends
  // over the edge, (l_i d_i + l_j d_j) . p_k / 2 with h_k p_k = -g_k / g_k^2.
  for (int k = 0; k < 3; ++k)
    if (glued[static_cast<size_t>(k)])
      for (const int i : {(k + 1) % 3, (k + 2) % 3})
        leaning.strains(3 + k, i) +=
            directions.col(i).dot(gradients.col(k)) / gradients.col(k).squaredNorm();
  const double stiffness = shear_factor * (section.outer - section.inner) * piece.area *
                           stiffening(gradients, section, directions);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      leaning.stiffness(i, j) =
          stiffness * (i == j ? 2 : 1) / 12 *
          directions.col(i).dot(section.shear_modulus.cwiseProduct(directions.col(j)));
  return leaning;
}

}  // namespace vasorod
