// The shell: derivatives, rigid motions, and Sze, Liu and Lo's benchmarks (Finite Elements in
// Analysis and Design 40, 2004).
#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/rigid_motion.h"
#include "reference_fem/finite_differences.h"
#include "reference_fem/in_one_step.h"
#include "reference_fem/shell.h"
#include "reference_fem/sze.h"
#include "reference_fem/tube.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

Shell bent_tube(LawKind kind) {
  const TubeShape tube{8, 2, 0.6, 1.6, 0.4, 0.9, {}};
  return Shell(make_surface({{3, 2, 1}, true, 2},
                            [=](const Vec3& p) {
                              return tube.point({p[0], p[1], 0.5});
                            }),
               MaterialLaw(kind, {1.7, 0.9, 0.35, 0.2, 0.25, false}), tube_body(tube), 3);
}

TEST(Shell, ResidualAndTangentAreDerivatives) {
  for (const LawKind kind : {LawKind::biot, LawKind::svk}) {
    const Shell shell = bent_tube(kind);
    Shell pressed = bent_tube(kind), stressed = bent_tube(kind);
    pressed.set_pressure({0.1, 0.3});
    const Eigen::VectorXd u = uneven_state(shell, 0.04);
    stressed.set_prestress(1.1, -2 * u);
    expect_derivatives(shell, 2, u, 1, true);
    expect_derivatives(pressed, 2, u, 0.7, false);
    expect_derivatives(stressed, 2, u, 1, true);
    ASSERT_TRUE(stressed.set_stress_free_shape(1.2, 2 * u));
    expect_derivatives(stressed, 2, u, 1, true);
    EXPECT_FALSE(stressed.set_stress_free_shape(1, 1e3 * u));  // turned inside out
  }
}

TEST(Shell, RigidMotionsCostNothing) {
  const Shell shell = bent_tube(LawKind::biot);
  const Mat3 R = exp_rotation(Vec3(0.4, -1.1, 0.7));
  Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dof_count());
  for (int i = 0; i < shell.node_count(); ++i) {
    const Vec3 X = shell.mesh().nodes.row(i), D = shell.directors().row(i);
    u.segment<3>(7 * i) = R * X - X + Vec3(1, 2, 3);
    u.segment<3>(7 * i + 3) = R * D - D;
  }
  CellTerms terms;
  for (int c = 0; c < shell.cell_count(); ++c) {
    ASSERT_TRUE(shell.evaluate(c, u, 1, false, terms));
    EXPECT_LT(terms.energy, 1e-25);
    EXPECT_LT(terms.residual.norm(), 1e-12);
  }
}

// The bent, tapered shell has the volume of the solid, up to the meshes' geometric error.
TEST(Shell, HasTheVolumeOfTheSolid) {
  const TubeShape tube{8, 2, 0.6, 1.6, 0.4, 0.9, {}};
  const Block block{{8, 4, 1}, true, 3};
  const Mesh solid = make_solid(block, [&](const Vec3& p) { return tube.point(p); });
  double volume = 0;
  for (const auto& w : solid.weights) volume += w.sum();
  // unit energy density: a uniform dilation of svk, 1/2 E : C : E with E = e I
  const MaterialLaw law(LawKind::svk, Moduli::isotropic(1, 0));
  const Shell shell(make_surface(block,
                                 [&](const Vec3& p) {
                                   return tube.point({p[0], p[1], 0.5});
                                 }),
                    law, tube_body(tube), 3);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(shell.dof_count());
  for (int i = 0; i < shell.node_count(); ++i) {
    u.segment<3>(7 * i) = shell.mesh().nodes.row(i);
    u.segment<3>(7 * i + 3) = shell.directors().row(i);
  }
  double energy = 0;
  CellTerms terms;
  for (int c = 0; c < shell.cell_count(); ++c) {
    ASSERT_TRUE(shell.evaluate(c, u, 1, false, terms));
    energy += terms.energy;
  }
  EXPECT_NEAR(energy / law.evaluate(2 * Mat3::Identity()).energy / volume, 1, 1e-5);
}

// A flat plate of distorted cells whose edge nodes follow one gradient: the inside has the same
// gradient, and the thickness is that of plane stress.
TEST(Shell, PatchTestOnDistortedCells) {
  Mat3 H = Mat3::Zero();
  H.topLeftCorner<2, 2>() << 0.15, 0.2, -0.05, -0.1;
  const double h = 0.3;
  const auto plate = [](const Vec3& p) {
    return Vec3(p[0] + 0.15 * std::sin(3 * p[1]) * p[0] * (1 - p[0]),
                p[1] + 0.2 * p[0] * p[1] * (1 - p[1]), 0);
  };
  for (const LawKind kind : {LawKind::biot, LawKind::svk})
    for (const int degree : {1, 2, 3}) {
      const MaterialLaw law(kind, Moduli::isotropic(1.3, 0.3));
      double low = -0.5, high = 0.5;  // no stress across the plate
      for (int i = 0; i < 60; ++i) {
        H(2, 2) = (low + high) / 2;
        (law.evaluate(Mat3::Identity() + H).stress[2] < 0 ? low : high) = H(2, 2);
      }
      const Shell shell = sze::make_shell(
          {{3, 2, 1}, false, degree}, plate, [](const Vec3&) { return Vec3(0, 0, 1); }, h, 1.3, 0.3,
          kind);
      const Mesh& mesh = shell.mesh();
      Supports supports;
      for (int i = 0; i < mesh.node_count(); ++i) {
        const Vec3 u = H * mesh.nodes.row(i).transpose();
        const bool edge = mesh.parameters.row(i).head<2>().minCoeff() < 1e-9 ||
                          mesh.parameters.row(i).head<2>().maxCoeff() > 1 - 1e-9;
        for (int c = 0; c < 3 && edge; ++c) supports.prescribed.emplace_back(7 * i + c, u[c]);
      }
      const auto [state, assembly] = in_one_step(shell, supports, 1e-11);
      double worst = 0;
      for (int i = 0; i < mesh.node_count(); ++i) {
        const Vec3 X = mesh.nodes.row(i);
        worst = std::max({worst, (state.u.segment<3>(7 * i) - H * X).norm(),
                          (state.u.segment<3>(7 * i + 3) - H * Vec3(0, 0, 1)).norm(),
                          h * std::abs(state.u[7 * i + 6])});
      }
      EXPECT_LT(worst, 1e-9) << to_string(kind) << " " << degree;
      EXPECT_NEAR(assembly.energy, h * law.evaluate(Mat3::Identity() + H).energy, 1e-10);
    }
}

TEST(Shell, SzeCantileverUnderEndShear) {
  const auto path = sze::cantilever_shear({0.25, 0.5, 1.0}, {8, 1, 1}, 3);
  const double table[][2] = {{0.563, 3.015}, {1.604, 4.933}, {3.286, 6.698}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(path[i][0], table[i][0], std::max(0.002, 0.01 * table[i][0]));
    EXPECT_NEAR(path[i][1], table[i][1], std::max(0.002, 0.01 * table[i][1]));
  }
}

// p = 4: the stiffness error of twelve cells of p = 3 is as large as the difference between the
// exact solutions.
TEST(Shell, SzeCantileverRolledToACircleByAnEndMoment) {
  const std::vector<double> loads{0.25, 0.5, 0.75, 1.0};
  sze::expect_rolled(loads, sze::cantilever_moment(loads, {12, 1, 1}, 4),
                     reference::RolledStrip::Kind::shell, 0.0003);
}

}  // namespace
}  // namespace vasorod::fem
