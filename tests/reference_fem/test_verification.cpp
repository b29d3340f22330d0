// Verification against tables and closed forms that take minutes, not seconds.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.h"
#include "reference_fem/shear_coefficient.h"
#include "reference_fem/shell.h"
#include "reference_fem/solid.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

constexpr std::array<bool, 6> all{true, true, true, true, true, true};

struct Ends {
  std::array<bool, 6> fixed = all;
  Vec3 move = Vec3::Zero(), rotation = Vec3::Zero(), force = Vec3::Zero(), moment = Vec3::Zero();
};

struct Answer {
  Vec6 force;
  Pose pose;
  double center_move = 0;
};

/// Tube with soft ends: start held, end as told.
Answer soft_tube(const TubeShape& tube, const Block& block, const MaterialLaw& law, const Ends& ends,
                 double step = 1) {
  const Solid solid(make_solid(block, [&](const Vec3& p) { return tube.point(p); }), law,
                    [&](const Vec3& p) { return tube.axes(p); });
  Supports supports;
  for (const int side : {0, 1}) supports.sections.push_back(end_section(solid, tube, side, true));
  supports.sections[0].fixed = all;
  Section& end = supports.sections[1];
  end.fixed = ends.fixed;
  end.move = ends.move;
  end.rotation = ends.rotation;
  end.force = ends.force;
  end.moment = ends.moment;
  const Vec3 center = end.center;
  const System system(solid, std::move(supports));
  State state;
  System::Assembly assembly;
  StepperOptions options;
  options.first_step = options.largest_step = step;
  options.certify = false;
  EXPECT_EQ(follow_path(system, state, assembly, options).status, PathStatus::complete);
  return {assembly.section_force[1], state.pose[1], (state.pose[1].position - center)[0]};
}

// tip(L) = a L^3 + b L + c of a tube between soft ends: a = P / 3 E I, b = P / k G A. The three-dimensional k
// is Hutchinson's (2001) for a hollow circle, 0.57397 here; Cowper's (1966), 0.53910, which the rod uses, is
// 6 % lower.
TEST(Verification, ShearCoefficientFromTheSlopeInLength) {
  const double P = 1e-7;
  Eigen::Matrix3d powers;
  Vec3 tips;
  const double lengths[] = {40, 60, 90};
  for (int i = 0; i < 3; ++i) {
    const double L = lengths[i];
    Ends ends;
    ends.fixed = {};
    ends.force = Vec3(P, 0, 0);
    const TubeShape tube{L, 10, 2, 10, 2, 0, {}};
    tips[i] = soft_tube(tube, {{8, static_cast<int>(L / 10), 1}, true, 3},
                        MaterialLaw(LawKind::svk, Moduli::isotropic(1, 0.3)), ends)
                  .center_move /
              P;
    powers.row(i) << L * L * L, L, 1;
  }
  const Vec3 fit = powers.inverse() * tips;
  const double EI = 1 / (3 * fit[0]), k = 1 / (fit[1] * 125.6637061436 / 2.6);
  EXPECT_NEAR(EI / 6346.0171602514, 1, 5e-5);
  EXPECT_NEAR(k, hutchinson(9, 11, 0.3), 1e-3);
}

// Cook's membrane, compressible split neo-Hookean, plane strain, dead shear of 1 N: 14.74 mm at the middle of
// the right edge.
double cooks_tip(double kappa, int cells, int degree) {
  const double mu = 0.4225;
  const Solid solid(make_solid({{cells, cells, 1}, false, degree},
                               [](const Vec3& p) {
                                 const double low = 44 * p[0], high = 44 + 16 * p[0];
                                 return Vec3(48 * p[0], low + (high - low) * p[1], p[2]);
                               }),
                    MaterialLaw::split(mu, kappa), [](const Vec3&) { return Mat3(Mat3::Identity()); });
  const Mesh& mesh = solid.mesh();
  Supports supports;
  for (const int node : mesh.nodes_on(0, 0))
    for (const int c : {0, 1}) supports.prescribed.emplace_back(3 * node + c, 0);
  for (int node = 0; node < mesh.node_count(); ++node)
    if (mesh.parameters(node, 2) < 1e-9 || mesh.parameters(node, 2) > 1 - 1e-9)
      supports.prescribed.emplace_back(3 * node + 2, 0);
  supports.dead_load = Eigen::VectorXd::Zero(solid.dof_count());
  for (const auto& [node, share] : parameter_shares(mesh, 0, 1)) supports.dead_load[3 * node + 1] = share;
  const System system(solid, supports);
  State state;
  System::Assembly assembly;
  EXPECT_EQ(follow_path(system, state, assembly).status, PathStatus::complete);
  const int corner = mesh.nearest_node({1, 0, 0}), top = mesh.nearest_node({1, 1, 0});
  // the middle of the edge is a node of even degree or an even number of cells
  const int middle = mesh.nearest_node({1, 0.5, 0});
  EXPECT_NE(middle, corner);
  EXPECT_NE(middle, top);
  return state.u[3 * middle + 1];
}

TEST(Verification, CooksMembrane) {
  const double mu = 0.4225, nu = 0.3, kappa = 2 * mu * (1 + nu) / (3 * (1 - 2 * nu));
  const double tip = cooks_tip(kappa, 8, 3);
  std::printf("Cook %.4f (14.74)\n", tip);
  EXPECT_NEAR(tip, 14.74, 0.015);
}

// No locking near incompressibility (bulk modulus 1e4 mu): few large cells give the fine mesh's answer as
// closely as they do for the compressible law.
TEST(Verification, CooksMembraneNearlyIncompressible) {
  const double kappa = 1e4 * 0.4225;
  const double fine = cooks_tip(kappa, 8, 4), coarse = cooks_tip(kappa, 4, 2), low = cooks_tip(kappa, 8, 1);
  std::printf("Cook, nearly incompressible: p = 4 %.4f, p = 2 %.4f, p = 1 %.4f\n", fine, coarse, low);
  EXPECT_NEAR(coarse / fine, 1, 0.01);
  EXPECT_NEAR(low / fine, 1, 0.06);
}

}  // namespace
}  // namespace vasorod::fem
