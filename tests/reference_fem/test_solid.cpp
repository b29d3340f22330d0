// The solid compared with exact solutions: patch test, manufactured solution, Lame's tube, uniaxial
// bar, residual and tangent.
#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numbers>

#include "reference_fem/finite_differences.h"
#include "reference_fem/in_one_step.h"
#include "reference_fem/solid.h"
#include "reference_fem/stepper.h"
#include "reference_fem/sze.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {
namespace {

const Axes space_axes = [](const Vec3&) { return Mat3(Mat3::Identity()); };

/// A distorted block of size 1 x 1 x 1.
Vec3 skewed(const Vec3& p) {
  return p + 0.08 * Vec3(std::sin(2 * p[1]) * p[0] * (1 - p[0]), p[0] * p[2] * p[1] * (1 - p[1]),
                         p[2] * (1 - p[2]) * p[0]);
}

std::vector<int> boundary_of(const Mesh& mesh) {
  std::vector<int> nodes;
  for (int i = 0; i < mesh.node_count(); ++i)
    if (mesh.parameters.row(i).minCoeff() < 1e-9 || mesh.parameters.row(i).maxCoeff() > 1 - 1e-9)
      nodes.push_back(i);
  return nodes;
}

TEST(Solid, TangentIsTheDerivativeOfTheResidualWithPressure) {
  TubeShape tube{5, 2, 1, 1.6, 0.7, 0.5, {}};
  Solid solid(make_solid({{3, 1, 1}, true, 2}, [&](const Vec3& p) { return tube.point(p); }),
              MaterialLaw(LawKind::biot, {1.7, 0.9, 0.35, 0.2, 0.25, false}),
              [&](const Vec3& p) { return tube.axes(p); });
  solid.add_pressure(2, 0, 0.3);
  const Eigen::VectorXd u = uneven_state(solid, 0.05);
  expect_derivatives(solid, 1, u, 0.7, true);                        // a cell
  expect_derivatives(solid, solid.cell_count() - 1, u, 0.7, false);  // a face under pressure
  solid.set_pressure({0.2, 0.3});
  solid.set_prestress(1.1, -2 * u);
  expect_derivatives(solid, 1, u, 0.7, true);
  ASSERT_TRUE(solid.set_stress_free_shape(1.2, 2 * u));
  expect_derivatives(solid, 1, u, 0.7, true);
  expect_derivatives(solid, solid.cell_count() - 1, u, 0.7, false);
}

// The split law on cells with projected volume ratio: energy, residual and tangent are consistent.
TEST(Solid, ProjectedVolumeRatioIsConsistent) {
  for (const int degree : {1, 2, 3}) {
    Solid solid(make_solid({{1, 1, 1}, false, degree}, skewed), MaterialLaw::split(0.4, 50),
                space_axes);
    SCOPED_TRACE(degree);
    expect_derivatives(solid, 0, uneven_state(solid, 0.03), 1, true);
    solid.set_prestress(1.05, uneven_state(solid, 0.01));
    expect_derivatives(solid, 0, uneven_state(solid, 0.03), 1, true);
    ASSERT_TRUE(solid.set_stress_free_shape(1.2, uneven_state(solid, 0.04)));
    expect_derivatives(solid, 0, uneven_state(solid, 0.03), 1, true);
  }
}

TEST(Solid, PatchTestOnDistortedCells) {
  Mat3 H;
  H << 0.1, 0.2, -0.05, 0.0, -0.1, 0.1, 0.15, 0.05, 0.2;
  for (const int degree : {1, 2, 3, 4})
    for (const LawKind kind : {LawKind::biot, LawKind::svk}) {
      const MaterialLaw law(kind, {1.7, 0.9, 0.35, 0.2, 0.25, false});
      Solid solid(make_solid({{2, 2, 2}, false, degree}, skewed), law, space_axes);
      Supports supports;
      const Mesh& mesh = solid.mesh();
      hold_at(supports, mesh.nodes, boundary_of(mesh), [&](const Vec3& X) { return Vec3(H * X); });
      const System system(solid, supports);
      State state;
      System::Assembly assembly;
      const StepperSummary summary = follow_path(system, state, assembly);
      ASSERT_EQ(summary.status, PathStatus::complete);
      double worst = 0;
      for (int i = 0; i < mesh.node_count(); ++i)
        worst =
            std::max(worst, (state.u.segment<3>(3 * i) - H * mesh.nodes.row(i).transpose()).norm());
      EXPECT_LT(worst, 1e-9) << degree;
      double volume = 0;
      for (const auto& w : mesh.weights) volume += w.sum();
      EXPECT_NEAR(assembly.energy, volume * law.evaluate(Mat3::Identity() + H).energy, 1e-10);
    }
}

// x = X + 0.3 f(X), f smooth; body force -Div P by central differences of the law's P; Dirichlet
// data on all faces.
struct Manufactured {
  MaterialLaw law;
  static Vec3 u(const Vec3& X) {
    return 0.1 * Vec3(std::sin(2 * X[1] + X[2]), std::cos(X[0] - 1.5 * X[2]),
                      std::sin(X[0] + X[1] * X[2]));
  }
  static Mat3 gradient(const Vec3& X) {
    Mat3 H;
    H << 0, 2 * std::cos(2 * X[1] + X[2]), std::cos(2 * X[1] + X[2]),  //
        -std::sin(X[0] - 1.5 * X[2]), 0, 1.5 * std::sin(X[0] - 1.5 * X[2]),
        std::cos(X[0] + X[1] * X[2]), X[2] * std::cos(X[0] + X[1] * X[2]),
        X[1] * std::cos(X[0] + X[1] * X[2]);
    return Mat3::Identity() + 0.1 * H;
  }
  Mat3 P(const Vec3& X) const {
    const Mat3 F = gradient(X);
    return F * stress_tensor(law.evaluate(F).stress);
  }
  Vec3 body_force(const Vec3& X) const {
    const double h = 1e-3;  // fourth-order differences: 1e-12 relative
    Vec3 b = Vec3::Zero();
    for (int J = 0; J < 3; ++J) {
      const Vec3 e = Vec3::Unit(J);
      b -= ((P(X - 2 * h * e) - P(X + 2 * h * e)) + 8 * (P(X + h * e) - P(X - h * e))).col(J) /
           (12 * h);
    }
    return b;
  }
};

struct Errors {
  double displacement, gradient;
  double potential;  ///< strain energy minus the body force's work (the value, not an error)
};

/// The exact potential: the skewed block fills the unit cube.
double exact_potential(const Manufactured& exact) {
  const Mesh cube = make_solid({{2, 2, 2}, false, 7}, [](const Vec3& p) { return p; });
  double sum = 0;
  for (std::size_t c = 0; c < cube.cell_nodes.size(); ++c)
    for (int q = 0; q < cube.point_count(); ++q) {
      const Vec3 X = cube.point_parameters[c].col(q);
      sum += cube.weights[c][q] * (exact.law.evaluate(Manufactured::gradient(X)).energy -
                                   exact.body_force(X).dot(Manufactured::u(X)));
    }
  return sum;
}

Errors manufactured_errors(const Manufactured& exact, int degree, int cells) {
  Solid solid(make_solid({{cells, cells, cells}, false, degree}, skewed), exact.law, space_axes);
  const Mesh& mesh = solid.mesh();
  Supports supports;
  hold_at(supports, mesh.nodes, boundary_of(mesh), Manufactured::u);
  supports.dead_load = Eigen::VectorXd::Zero(solid.dof_count());
  for (int c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < mesh.point_count(); ++q) {
      Vec3 X = Vec3::Zero();
      const auto cell = static_cast<std::size_t>(c);
      for (std::size_t a = 0; a < mesh.cell_nodes[cell].size(); ++a)
        X += mesh.shape(q, static_cast<Eigen::Index>(a)) * mesh.nodes.row(mesh.cell_nodes[cell][a]);
      const Vec3 f = mesh.weights[cell][q] * exact.body_force(X);
      for (std::size_t a = 0; a < mesh.cell_nodes[cell].size(); ++a)
        supports.dead_load.segment<3>(3 * mesh.cell_nodes[cell][a]) +=
            mesh.shape(q, static_cast<Eigen::Index>(a)) * f;
    }
  const auto [state, assembly] = in_one_step(solid, supports, 1e-11);
  double square = 0, slope = 0;
  for (std::size_t c = 0; c < mesh.cell_nodes.size(); ++c) {
    const auto n = static_cast<Eigen::Index>(mesh.cell_nodes[c].size());
    Eigen::MatrixX3d ue(n, 3), xe(n, 3);
    for (Eigen::Index a = 0; a < n; ++a) {
      ue.row(a) = state.u.segment<3>(3 * mesh.cell_nodes[c][static_cast<std::size_t>(a)]);
      xe.row(a) = mesh.nodes.row(mesh.cell_nodes[c][static_cast<std::size_t>(a)]);
    }
    for (int q = 0; q < mesh.point_count(); ++q) {
      const Vec3 X = (mesh.shape.row(q) * xe).transpose();
      const Mat3 H = (mesh.gradient[c].middleRows<3>(3 * q) * ue).transpose();
      square += mesh.weights[c][q] *
                ((mesh.shape.row(q) * ue).transpose() - Manufactured::u(X)).squaredNorm();
      slope +=
          mesh.weights[c][q] * (H + Mat3::Identity() - Manufactured::gradient(X)).squaredNorm();
    }
  }
  return {std::sqrt(square), std::sqrt(slope), assembly.energy - supports.dead_load.dot(state.u)};
}

TEST(Solid, ManufacturedSolutionConvergesAtItsOrder) {
  for (const LawKind kind : {LawKind::biot, LawKind::svk}) {
    const Manufactured exact{MaterialLaw(kind, {1.3, 0.9, 0.35, 0.2, 0.35, false})};
    const double potential = exact_potential(exact);
    for (const int degree : {1, 2, 3}) {
      const int coarse = degree == 1 ? 4 : 2;
      const Errors a = manufactured_errors(exact, degree, coarse),
                   b = manufactured_errors(exact, degree, 2 * coarse);
      const double order = std::log2(a.displacement / b.displacement),
                   slope_order = std::log2(a.gradient / b.gradient),
                   potential_order =
                       std::log2(std::abs((a.potential - potential) / (b.potential - potential)));
      std::printf(
          "%s, p = %d: order %.2f of displacements, %.2f of gradients, %.2f of the potential\n",
          to_string(kind).c_str(), degree, order, slope_order, potential_order);
      EXPECT_GT(order, degree + 1 - 0.25) << degree;
      EXPECT_LT(order, degree + 1 + 0.6) << degree;
      EXPECT_GT(slope_order, degree - 0.25) << degree;
      EXPECT_GT(potential_order, 2 * degree - 0.25) << degree;
    }
  }
}

TEST(Solid, LameTubeUnderPressure) {
  // ri = 9, ro = 11, E = 1, nu = 0.3, p_i = 1e-3 scaled down to the linear range; plane strain
  const double p = 1e-9;
  TubeShape tube{4, 10, 2, 10, 2, 0, {}};
  Solid solid(make_solid({{8, 1, 1}, true, 4}, [&](const Vec3& at) { return tube.point(at); }),
              MaterialLaw(LawKind::svk, Moduli::isotropic(1, 0.3)),
              [&](const Vec3& at) { return tube.axes(at); });
  solid.add_pressure(2, 0, p);
  Supports supports;
  const Mesh& mesh = solid.mesh();
  for (int i = 0; i < mesh.node_count(); ++i)
    if (mesh.parameters(i, 1) < 1e-9 || mesh.parameters(i, 1) > 1 - 1e-9)
      supports.prescribed.emplace_back(3 * i + 2, 0);
  const int right = mesh.nearest_node({0, 0, 0}), top = mesh.nearest_node({0.25, 0, 0});
  supports.prescribed.emplace_back(3 * right + 1, 0);
  supports.prescribed.emplace_back(3 * top, 0);
  supports.prescribed.emplace_back(3 * mesh.nearest_node({0.5, 0, 0}) + 1, 0);
  const State state = in_one_step(solid, supports, 1e-8).state;
  const double inner = state.u[3 * mesh.nearest_node({0, 0.5, 0})],
               outer = state.u[3 * mesh.nearest_node({0, 0.5, 1})];
  EXPECT_NEAR(inner / p * 1e-3, 4.48695e-2, 4.48695e-2 * 2e-5);
  EXPECT_NEAR(outer / p * 1e-3, 4.05405e-2, 4.05405e-2 * 2e-5);
}

TEST(Solid, SzeCantileverUnderEndShear) {
  const auto path = sze::solid_cantilever_shear({0.25, 0.5, 1.0}, {10, 1, 1}, 3);
  const double table[][2] = {{0.563, 3.015}, {1.604, 4.933}, {3.286, 6.698}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(path[i][k], table[i][k], std::max(0.002, 0.01 * table[i][k]));
}

TEST(Solid, SaysWhereAnElementIsTurnedInsideOut) {
  Solid solid(make_solid({{1, 1, 1}, false, 2}, skewed),
              MaterialLaw(LawKind::svk, Moduli::isotropic(1, 0.3)), space_axes);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(solid.dof_count());
  const Mesh& mesh = solid.mesh();
  for (int i = 0; i < mesh.node_count(); ++i) u[3 * i] = -2 * mesh.nodes(i, 0);
  CellTerms terms;
  EXPECT_FALSE(solid.evaluate(0, u, 1, false, terms));
}

}  // namespace
}  // namespace vasorod::fem
