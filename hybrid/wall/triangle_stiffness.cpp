#include "wall/triangle_stiffness.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>

#include "wall/ring_softness.h"

namespace vasorod {

namespace {

using Mat2 = Eigen::Matrix2d;

// Row that extracts the strain along the unit direction t from (e11, e22, 2 e12).
Eigen::RowVector3d along(const Vec2& t) {
  return {t[0] * t[0], t[1] * t[1], t[0] * t[1]};
}

constexpr double largest_strain = 0.1;

// Maps (e, c) of the facet to (e, c) of the curved piece it represents, and stores the ratio of
// their areas.
struct CurvedPiece {
  Mat6 map = Mat6::Identity();
  double area_ratio;

  CurvedPiece(const std::array<Vec2, 3>& edge, const Vec3& b) {
    Mat3 facet, piece;
    Vec3 square, curvature;
    for (int k = 0; k < 3; ++k) {
      const Vec2& d = edge[static_cast<size_t>(k)];
      square[k] = d.squaredNorm();
      facet.row(k) = along(d / std::sqrt(square[k]));
      curvature[k] = facet.row(k).dot(Vec3(b[0], b[1], 2 * b[2]));
    }
    Vec3 bow = square.cwiseProduct(curvature) / 12;  // l^2 k / 12
    Vec3 stretch = bow.cwiseProduct(curvature);      // of the squared length, from chord to arc
    // The triangle of the arcs is the facet stretched by u, to first order in `stretch`.
    Vec3 e = facet.inverse() * stretch / 2;
    // A sliver across the direction of curvature tilts out of the surface; the first-order formula
    // does not hold there.
    const double excess = e.cwiseAbs().maxCoeff() / largest_strain;
    if (excess > 1) {
      e /= excess;
      stretch /= excess;
      bow /= std::sqrt(excess);
    }
    Mat2 u;
    u << 1 + e[0], e[2] / 2, e[2] / 2, 1 + e[1];
    area_ratio = u.determinant();
    for (int k = 0; k < 3; ++k)
      piece.row(k) = along((u * edge[static_cast<size_t>(k)]).normalized());
    const Mat3 back = piece.inverse();
    map.topLeftCorner<3, 3>() = back * (Vec3::Ones() - stretch).asDiagonal() * facet;
    map.topRightCorner<3, 3>() = back * bow.asDiagonal() * facet;
  }
};

// A direction of principal curvature and the bending compliance along it, 1 / (force length), that
// corrects the section for the mode n = 2 of a ring: the transverse shear of the wall is added, the
// softness of the triangle is removed.
struct RingCorrection {
  Vec2 direction;
  double compliance;
};

std::array<RingCorrection, 2> ring_corrections(const Eigen::Matrix<double, 2, 3>& gradients,
                                               const WallSection& section, const Mat3& bending) {
  Mat2 b;
  b << section.curvature[0], section.curvature[2], section.curvature[2], section.curvature[1];
  const Eigen::SelfAdjointEigenSolver<Mat2> principal(b);
  std::array<RingCorrection, 2> corrections;
  for (int i = 0; i < 2; ++i) {
    const Vec2 d = principal.eigenvectors().col(i);
    const double k = principal.eigenvalues()[i];
    const Vec3 unit(d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]);
    const double softness = ring_softness(gradients, bending, d, k);
    // negative compliance: stiffer by the factor 1 + softness
    const double stiffer = -softness / ((1 + softness) * unit.dot(bending * unit));
    corrections[static_cast<size_t>(i)] = {d, shear_compliance(section, d, k) + stiffer};
  }
  return corrections;
}

// The facet's strains (e11, e22, 2 e12, b_0, b_1, b_2) to (e, c) of the curved piece.
struct Facet {
  double area, ratio;  // ratio: of the piece's area to the facet's
  Mat6 map;

  Facet(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section)
      : area(0.5 /
             std::abs(gradients(0, 0) * gradients(1, 1) - gradients(0, 1) * gradients(1, 0))) {
    std::array<Vec2, 3> edge;
    Mat6 bending = Mat6::Identity();  // c = sum_k b_k g_k g_k^T
    for (int k = 0; k < 3; ++k) {
      const Vec2 g = gradients.col(k);
      edge[static_cast<size_t>(k)] = 2 * area * Vec2(-g[1], g[0]);
      bending.block<3, 1>(3, 3 + k) << g[0] * g[0], g[1] * g[1], 2 * g[0] * g[1];
    }
    const CurvedPiece piece(edge, section.curvature);
    map = piece.map * bending;
    ratio = piece.area_ratio;
  }
};

}  // namespace

Mat6 triangle_stiffness(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section) {
  const Facet facet(gradients, section);
  Mat6 stiffness = wall_section_stiffness(section);
  for (const RingCorrection& ring :
       ring_corrections(gradients, section, stiffness.bottomRightCorner<3, 3>()))
    add_bending_compliance(stiffness, ring.direction, ring.compliance);
  return facet.area * facet.ratio * facet.map.transpose() * stiffness * facet.map;
}

WallPiece curved_piece(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section) {
  const Facet facet(gradients, section);
  return {facet.map, facet.area * facet.ratio};
}

WallPiece wall_piece(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section) {
  const Facet facet(gradients, section);
  Mat6 stiffness = wall_section_stiffness(section), strains = Mat6::Identity();
  for (const RingCorrection& ring :
       ring_corrections(gradients, section, stiffness.bottomRightCorner<3, 3>())) {
    const Mat6 reduced = less_bending(stiffness, ring.direction, ring.compliance);
    stiffness = reduced.transpose() * stiffness * reduced;
    strains *= reduced;
  }
  return {strains * facet.map, facet.area * facet.ratio};
}

}  // namespace vasorod
