#include <algorithm>
#include <gtest/gtest.h>

#include "geometry/umbrella.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(Umbrella, IsTheMeanOfTheNeighboursMinusTheVertex) {
  Triangles t(2, 3);
  t << 0, 1, 2, 0, 2, 3;
  Points p(4, 3);
  p << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 2;
  const Points l = Umbrella(edges_of(t), 4).apply(p);
  EXPECT_TRUE(l.row(0).isApprox(Eigen::RowVector3d(2.0 / 3, 2.0 / 3, 2.0 / 3)));
  EXPECT_TRUE(l.row(1).isApprox(Eigen::RowVector3d(0.5 - 1, 0.5, 0)));
}

TEST(Umbrella, MatrixAndTransposeAgreeWithApply) {
  const TriangleSurface t = tube(1, 2, 7, 4);
  const int n = static_cast<int>(t.points.rows());
  const Umbrella umbrella(edges_of(t.triangles), n);
  const Points p = random_points(n, 3);
  EXPECT_TRUE(umbrella.apply(p).isApprox(umbrella.matrix() * p, 1e-14));
  Points back = Points::Zero(n, 3);
  umbrella.add_transpose(p, 2.5, back);
  EXPECT_TRUE(back.isApprox(2.5 * (umbrella.matrix().transpose() * p), 1e-14));
  const Points target = random_points(n, 4);
  const Points misfit = umbrella.matrix() * p - target;
  back.setZero();
  EXPECT_NEAR(umbrella.add_misfit(p, target, 2.5, back) / misfit.squaredNorm(), 1, 1e-14);
  EXPECT_TRUE(back.isApprox(2.5 * (umbrella.matrix().transpose() * misfit), 1e-14));
}

TEST(Umbrella, IsTheSameWhicheverNeighbourComesFirstAndZeroWithoutAny) {
  Triangles t(2, 3);
  t << 0, 1, 2, 0, 2, 3;
  std::vector<Edge> edges = edges_of(t);
  const Points p = random_points(6, 8);  // vertices 4 and 5 belong to no triangle
  const Umbrella umbrella(edges, 6);
  EXPECT_EQ(umbrella.vertex_count(), 6);
  const Points l = umbrella.apply(p);
  std::reverse(edges.begin(), edges.end());
  EXPECT_LT((Umbrella(edges, 6).apply(p) - l).norm(), 1e-15);
  EXPECT_EQ(l.bottomRows(2).norm(), 0);
  EXPECT_EQ(Eigen::MatrixXd(umbrella.matrix()).bottomRows(2).norm(), 0);
}

TEST(Umbrella, OfAConstantIsNothing) {
  const TriangleSurface t = tube(1, 2, 7, 4);
  const int n = static_cast<int>(t.points.rows());
  const Umbrella umbrella(edges_of(t.triangles), n);
  EXPECT_LT(umbrella.apply(Points::Constant(n, 3, 7)).norm(), 1e-13);
  EXPECT_LT((umbrella.matrix() * Eigen::VectorXd::Ones(n)).norm(), 1e-13);
}

}  // namespace
}  // namespace vasorod
