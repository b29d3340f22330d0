// Cook's membrane with the split neo-Hookean law, compressible and nearly incompressible.
#include <cstdio>
#include <gtest/gtest.h>

#include "reference_fem/solid.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

// Cook's membrane, compressible split neo-Hookean, plane strain, dead shear force of 1 N: 14.74 mm
// at the middle of the right edge.
double cooks_tip(double kappa, int cells, int degree) {
  const double mu = 0.4225;
  const Solid solid(make_solid({{cells, cells, 1}, false, degree},
                               [](const Vec3& p) {
                                 const double low = 44 * p[0], high = 44 + 16 * p[0];
                                 return Vec3(48 * p[0], low + (high - low) * p[1], p[2]);
                               }),
                    MaterialLaw::split(mu, kappa),
                    [](const Vec3&) { return Mat3(Mat3::Identity()); });
  const Mesh& mesh = solid.mesh();
  Supports supports;
  for (const int node : mesh.nodes_on(0, 0))
    for (const int c : {0, 1}) supports.prescribed.emplace_back(3 * node + c, 0);
  for (int node = 0; node < mesh.node_count(); ++node)
    if (mesh.parameters(node, 2) < 1e-9 || mesh.parameters(node, 2) > 1 - 1e-9)
      supports.prescribed.emplace_back(3 * node + 2, 0);
  supports.dead_load = Eigen::VectorXd::Zero(solid.dof_count());
  for (const auto& [node, share] : parameter_shares(mesh, 0, 1))
    supports.dead_load[3 * node + 1] = share;
  const System system(solid, supports);
  State state;
  System::Assembly assembly;
  EXPECT_EQ(follow_path(system, state, assembly).status, PathStatus::complete);
  const int corner = mesh.nearest_node({1, 0, 0}), top = mesh.nearest_node({1, 1, 0});
  // the middle of the edge is a node for even degrees and for even numbers of cells
  const int middle = mesh.nearest_node({1, 0.5, 0});
  EXPECT_NE(middle, corner);
  EXPECT_NE(middle, top);
  return state.u[3 * middle + 1];
}

TEST(Cook, Compressible) {
  const double mu = 0.4225, nu = 0.3, kappa = 2 * mu * (1 + nu) / (3 * (1 - 2 * nu));
  const double tip = cooks_tip(kappa, 8, 3);
  std::printf("Cook %.4f (14.74)\n", tip);
  EXPECT_NEAR(tip, 14.74, 0.015);
}

// No locking near incompressibility (bulk modulus 1e4 mu): few large cells are as close to the fine
// mesh's answer as with the compressible law.
TEST(Cook, NearlyIncompressible) {
  const double kappa = 1e4 * 0.4225;
  const double fine = cooks_tip(kappa, 8, 4), coarse = cooks_tip(kappa, 4, 2),
               low = cooks_tip(kappa, 8, 1);
  std::printf("Cook, nearly incompressible: p = 4 %.4f, p = 2 %.4f, p = 1 %.4f\n", fine, coarse,
              low);
  EXPECT_NEAR(coarse / fine, 1, 0.01);
  EXPECT_NEAR(low / fine, 1, 0.06);
}

}  // namespace
}  // namespace vasorod::fem
