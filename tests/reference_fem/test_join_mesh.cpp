// The meshes of a join: rim and lips in pairs at equal arc length, and the folding of points into
// the part that symmetry leaves.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "reference_fem/join_mesh.h"
#include "reference_fem/joined_tubes.h"

namespace vasorod::fem {
namespace {

JoinProblem problem_of(std::array<bool, 2> mirror, const std::string& text = joined_tubes_text) {
  JoinProblem problem = read_join(scene_of_text(text), std::nullopt);
  problem.mirror = mirror;
  return problem;
}

JoinCells small_cells(int degree, int layers) {
  JoinCells cells;
  cells.seam = 2;
  cells.vein = cells.around = cells.before = cells.after = 3;
  cells.degree = degree;
  cells.layers = layers;
  return cells;
}

double size(const Mesh& mesh) {
  double sum = 0;
  for (const auto& w : mesh.weights) sum += w.sum();
  return sum;
}

TEST(JoinMesh, PairsStandAtEqualArcLength) {
  for (const bool x : {false, true})
    for (const bool y : {false, true})
      for (const int layers : {0, 2}) {
        const JoinProblem problem = problem_of({x, y});
        const JoinMesh mesh = make_join_mesh(problem, small_cells(3, layers));
        // Q3: 8 cells around the whole seam
        EXPECT_EQ(mesh.seam.size(), x && y ? 7u : x != y ? 13u : 24u);
        const double perimeter = 2 * std::numbers::pi;  // of the vein, radius 1
        for (const SeamPair& pair : mesh.seam) {
          const Vec3 rim = mesh.vein.nodes.row(pair.vein), lip = mesh.artery.nodes.row(pair.artery);
          // arc lengths from the positions: of the rim by its angle, of the slit by its abscissa
          double angle = std::atan2(rim[1], rim[0]);
          if (angle < -1e-9) angle += perimeter;
          const double tip = problem.incision.length / 2;
          EXPECT_NEAR(rim.head<2>().norm(), 1, 1e-9);
          EXPECT_NEAR(lip[1], 0, 1e-12);
          EXPECT_NEAR(lip[2], 0, 1e-12);
          const double to_lip = angle <= perimeter / 2 ? tip - lip[0] : 3 * tip + lip[0];
          EXPECT_NEAR(angle, to_lip, 1e-9) << rim.transpose();
          EXPECT_NEAR(pair.share, angle / perimeter, 1e-9);
          EXPECT_LT((pair.gap - (rim - lip)).norm(), 1e-12);
          // the lip's cells lie on the rim's side of the slit
          if (std::abs(rim[1]) < 1e-9) continue;
          for (int c = 0; c < mesh.artery.cell_count(); ++c) {
            const auto& nodes = mesh.artery.cell_nodes[static_cast<std::size_t>(c)];
            if (std::find(nodes.begin(), nodes.end(), pair.artery) == nodes.end()) continue;
            for (const int node : nodes) EXPECT_GT(mesh.artery.nodes(node, 1) * rim[1], -1e-9);
          }
        }
      }
}

// An ellipse of the same perimeter as the rim: pairs at equal arc length of both, and the artery
// without the hole, whose area on the unrolled wall is pi a b.
TEST(JoinMesh, AnEllipticHoleIsTakenOutOfTheWall) {
  double whole = 0;
  for (const bool mirror : {false, true}) {
    JoinProblem problem = problem_of({mirror, mirror});
    const double length = 2.594, width = 1.297;
    ASSERT_TRUE(open_ellipse(problem, length, width));
    JoinCells cells = first_cells(problem, 4, 0, 1);
    cells.degree = 4;
    const JoinMesh mesh = make_join_mesh(problem, cells);
    const double area = 2 * std::numbers::pi * 1.1 * 10 - std::numbers::pi / 4 * length * width;
    EXPECT_NEAR((mirror ? 4 : 1) * size(mesh.artery), area, 2e-3);
    if (mirror)
      EXPECT_NEAR(4 * size(mesh.artery), whole, 1e-9);
    else
      whole = size(mesh.artery);
    const double perimeter = problem.incision.perimeter;
    EXPECT_NEAR(perimeter, 2 * std::numbers::pi, 2e-3);
    EXPECT_EQ(mesh.seam.size(), mirror ? 17u : 64u);
    double way = 0;  // along the ellipse by small chords, from node to node
    Vec2 before(length / 2, 0);
    for (const SeamPair& pair : mesh.seam) {
      const Vec3 lip = mesh.artery.nodes.row(pair.artery);
      const Vec2 flat(lip[0], 1.1 * std::atan2(lip[1], lip[2] + 1.1));
      EXPECT_NEAR(std::pow(2 * flat[0] / length, 2) + std::pow(2 * flat[1] / width, 2), 1, 1e-9);
      const double from = std::atan2(before[1] / width, before[0] / length);
      double to = std::atan2(flat[1] / width, flat[0] / length);
      if (to < from - 1e-9) to += 2 * std::numbers::pi;
      const auto at = [&](double t) {
        return Vec2(length / 2 * std::cos(t), width / 2 * std::sin(t));
      };
      const int parts = 400;
      for (int k = 0; k < parts; ++k)
        way +=
            (at(from + (to - from) * (k + 1) / parts) - at(from + (to - from) * k / parts)).norm();
      EXPECT_NEAR(pair.share, way / perimeter, 1e-5);
      before = flat;
    }
  }
}

TEST(JoinMesh, PartsAddUpToTheWhole) {
  const double vein = size(make_join_mesh(problem_of({false, false}), small_cells(4, 0)).vein),
               artery = size(make_join_mesh(problem_of({false, false}), small_cells(4, 0)).artery);
  EXPECT_NEAR(vein, 2 * std::numbers::pi * 4, 1e-4);
  EXPECT_NEAR(artery, 2 * std::numbers::pi * 1.1 * 10, 1e-3);
  for (const auto& [x, y] : {std::pair{true, false}, {false, true}, {true, true}}) {
    const JoinMesh part = make_join_mesh(problem_of({x, y}), small_cells(4, 0));
    const double copies = x && y ? 4 : 2;
    EXPECT_NEAR(copies * size(part.vein), vein, 1e-9);
    EXPECT_NEAR(copies * size(part.artery), artery, 1e-9);
  }
}

TEST(JoinMesh, AFoldedPointIsTheMirroredPoint) {
  for (const bool x : {false, true})
    for (const bool y : {false, true}) {
      const JoinProblem problem = problem_of({x, y});
      const JoinMesh mesh = make_join_mesh(problem, small_cells(3, 0));
      for (const double share : {0.0, 0.03, 0.25, 0.4, 0.5, 0.62, 0.75, 0.93})
        for (const double s : {0.0, 0.2, 0.5, 0.55, 1.0}) {
          const auto check = [&](const JoinWall& wall, const Mesh& part, const Folded& folded) {
            const Vec3 whole = wall.shape.point(wall.parameters(share, s)),
                       point = wall.shape.point(wall.parameters(folded.parameter));
            EXPECT_LT((folded.sign.cwiseProduct(point) - whole).norm(), 1e-12);
            EXPECT_NO_THROW(part.rows_at({folded.parameter}));
          };
          check(problem.vein, mesh.vein, fold_vein(problem, share, s));
          check(problem.artery, mesh.artery, fold_artery(problem, share, s));
        }
    }
}

TEST(JoinMesh, CellsMeetTheTipAtOneSize) {
  const JoinProblem problem =
      problem_of({false, true}, with(joined_tubes_text, "[-10, 0, 10.2]", "[-8, 0, 10.2]"));
  const JoinCells cells = first_cells(problem, 6, 0, 2);
  EXPECT_EQ(cells.seam, 6);
  for (const int number : {cells.vein, cells.around, cells.before, cells.after})
    EXPECT_EQ(number % 2, 0);
  EXPECT_LT(cells.before, cells.after + 1);
  const std::vector<double> lines = join_lines(problem, cells).artery;
  for (const double tip : {problem.incision.from, problem.incision.to}) {
    const auto at = std::min_element(lines.begin(), lines.end(), [&](double a, double b) {
      return std::abs(a - tip) < std::abs(b - tip);
    });
    EXPECT_EQ(*at, tip);
    EXPECT_NEAR((at[1] - at[0]) / (at[0] - at[-1]), 1, 0.35);
  }
  const JoinCells fine = refined(cells, 1.5);
  EXPECT_EQ(fine.seam, 9);
  EXPECT_EQ(fine.after, cells.after * 3 / 2);
}

}  // namespace
}  // namespace vasorod::fem
