// A tube's wall as a strip: whole, with a slit, and in parts.
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>

#include "reference_fem/strip_mesh.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {
namespace {

const TubeShape tube{6, 2, 0.5, 2, 0.5, 0, {}};

Strip strip_of(std::vector<char> welded) {
  Strip strip;
  strip.around = {0, 0.05, 0.2, 0.5, 0.8, 0.95, 1};
  strip.along = {0, 0.3, 0.5, 0.7, 1};
  strip.welded = std::move(welded);
  return strip;
}

Mesh mesh_of(const Strip& strip) {
  return make_strip(strip, [](const Vec3& p) { return tube.point(p); });
}

double size(const Mesh& mesh) {
  double sum = 0;
  for (const auto& w : mesh.weights) sum += w.sum();
  return sum;
}

/// Pairs of different nodes at one place.
int doubles(const Mesh& mesh) {
  int count = 0;
  for (int i = 0; i < mesh.node_count(); ++i)
    for (int j = i + 1; j < mesh.node_count(); ++j)
      count += (mesh.nodes.row(i) - mesh.nodes.row(j)).norm() < 1e-9 ? 1 : 0;
  return count;
}

TEST(StripMesh, AWholeTubeHasNoDoubleNodes) {
  Strip strip = strip_of({1, 1, 1, 1, 1});
  const Mesh mesh = mesh_of(strip);
  EXPECT_EQ(doubles(mesh), 0);
  EXPECT_NEAR(size(mesh), 2 * std::numbers::pi * 2 * 6, 1e-2);
  // Q3 on a closed strip of 6 x 4 cells
  EXPECT_EQ(mesh.node_count(), 18 * 13);
}

// Two cells of the line are open: five nodes of their seven are on both lips, the tips on one.
TEST(StripMesh, ASlitDoublesTheNodesBetweenItsTips) {
  const Mesh mesh = mesh_of(strip_of({1, 1, 0, 1, 1}));
  EXPECT_EQ(doubles(mesh), 5);
  EXPECT_NEAR(size(mesh), size(mesh_of(strip_of({1, 1, 1, 1, 1}))), 1e-12);
  // the two cells beside a lip share only a tip
  std::map<int, std::set<int>> cells_of;
  for (int c = 0; c < mesh.cell_count(); ++c)
    for (const int node : mesh.cell_nodes[static_cast<std::size_t>(c)]) cells_of[node].insert(c);
  int tips = 0;
  for (const auto& [node, cells] : cells_of) {
    const Vec3 at = mesh.parameters.row(node);
    const bool on_line = at[0] < 1e-12 || at[0] > 1 - 1e-12;
    if (!on_line || at[1] < 0.3 - 1e-12 || at[1] > 0.7 + 1e-12) continue;
    const bool tip = std::abs(std::abs(at[1] - 0.5) - 0.2) < 1e-12;
    tips += tip ? 1 : 0;
    const std::size_t expected = tip ? 4 : std::abs(at[1] - 0.5) < 1e-12 ? 2 : 1;
    EXPECT_EQ(cells.size(), expected) << at.transpose();
  }
  EXPECT_EQ(tips, 2);
}

TEST(StripMesh, APartIsOpenAllAlong) {
  Strip strip = strip_of({0, 0, 0, 0, 0});
  strip.around = {0, 0.1, 0.25};
  EXPECT_NEAR(size(mesh_of(strip)), std::numbers::pi / 2 * 2 * 6, 1e-3);
  EXPECT_EQ(doubles(mesh_of(strip)), 0);
}

TEST(StripMesh, LayersFillTheWall) {
  Strip strip = strip_of({1, 1, 0, 1, 1});
  strip.layers = 2;
  const Mesh mesh = mesh_of(strip);
  const double area = std::numbers::pi * (2.25 * 2.25 - 1.75 * 1.75);
  EXPECT_NEAR(size(mesh), area * 6, 2e-2);
  EXPECT_EQ(doubles(mesh), 5 * 7);  // at seven depths
  int middle = 0;
  for (int i = 0; i < mesh.node_count(); ++i)
    middle += std::abs(mesh.parameters(i, 2) - 0.5) < 1e-12 ? 1 : 0;
  EXPECT_EQ(middle, 18 * 13 + 5);
}

}  // namespace
}  // namespace vasorod::fem
