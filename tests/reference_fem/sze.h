// The geometries, supports and loads of Sze, Liu and Lo (2004) for the shell and, of 3.1, 3.2
// and 3.7, the solid; results at given fractions of the full load.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "reference_fem/rolled_strip.h"
#include "reference_fem/shell.h"
#include "reference_fem/solid.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem::sze {

using Rows = std::vector<std::array<double, 2>>;

inline Shell make_shell(const Block& block, const Chart& chart,
                        const std::function<Vec3(const Vec3&)>& normal, double h, double young,
                        double nu, LawKind law = LawKind::svk) {
  return Shell(
      make_surface(block, chart), MaterialLaw(law, Moduli::isotropic(young, nu)),
      {normal, [h](const Vec3&) { return h; }, [](const Vec3&) { return Mat3(Mat3::Identity()); }},
      law == LawKind::svk ? 2 : 3);
}

inline Rows follow(const Model& model, const Supports& supports, const std::vector<double>& loads,
                   double first, double largest,
                   const std::function<std::array<double, 2>(const Eigen::VectorXd&)>& measure) {
  const System system(model, supports);
  State state;
  System::Assembly assembly;
  StepperOptions options;
  options.first_step = first;
  options.largest_step = largest;
  options.stops = loads;
  options.certify = false;
  Rows rows;
  options.on_step = [&](double load, const State& at, const System::Assembly&) {
    if (rows.size() < loads.size() && std::abs(load - loads[rows.size()]) < 1e-12)
      rows.push_back(measure(at.u));
  };
  const StepperSummary summary = follow_path(system, state, assembly, options);
  EXPECT_EQ(summary.status, PathStatus::complete);
  ::testing::Test::RecordProperty("iterations", summary.iterations);
  ::testing::Test::RecordProperty("unknowns", system.size());
  rows.resize(loads.size(), {std::nan(""), std::nan("")});
  return rows;
}

inline void hold(Supports& supports, const std::vector<int>& nodes,
                 std::initializer_list<int> components, int per_node = 7) {
  for (const int node : nodes)
    for (const int c : components) supports.prescribed.emplace_back(per_node * node + c, 0);
}

inline Shell cantilever(double length, const std::array<int, 3>& cells, int degree, LawKind law) {
  return make_shell(
      {cells, false, degree}, [length](const Vec3& p) { return Vec3(length * p[0], p[1], 0); },
      [](const Vec3&) { return Vec3(0, 0, 1); }, 0.1, 1.2e6, 0, law);
}

/// 3.1: -u and w of the tip.
inline Rows cantilever_shear(const std::vector<double>& loads, const std::array<int, 3>& cells,
                             int degree) {
  const Shell shell = cantilever(10, cells, degree, LawKind::svk);
  Supports supports;
  hold(supports, shell.mesh().nodes_on(0, 0), {0, 1, 2, 3, 4, 5});
  supports.dead_load = Eigen::VectorXd::Zero(shell.dof_count());
  for (const auto& [node, share] : parameter_shares(shell.mesh(), 0, 1))
    supports.dead_load[7 * node + 2] = 4 * share;
  const int tip = shell.mesh().nearest_node({1, 0, 0});
  return follow(shell, supports, loads, 0.05, 0.2, [tip](const Eigen::VectorXd& u) {
    return std::array<double, 2>{-u[7 * tip], u[7 * tip + 2]};
  });
}

/// 3.2: the tip's edge is a rigid section under a moment about -y. By the Biot law, the moment is
/// linear in the curvature as in the elastica (S = C : E stiffens by (h curvature)^2).
inline Rows cantilever_moment(const std::vector<double>& loads, const std::array<int, 3>& cells,
                              int degree) {
  const Shell shell = cantilever(12, cells, degree, LawKind::biot);
  Supports supports;
  hold(supports, shell.mesh().nodes_on(0, 0), {0, 1, 2, 3, 4, 5});
  Section tip;
  tip.name = "tip";
  tip.center = Vec3(12, 0.5, 0);
  tip.moment = Vec3(0, -50 * std::numbers::pi / 3, 0);
  for (const int node : shell.mesh().nodes_on(0, 1)) {
    tip.members.push_back(
        {7 * node, shell.mesh().nodes.row(node).transpose() - tip.center, true, 0});
    tip.members.push_back({7 * node + 3, shell.directors().row(node), false, 0});
  }
  supports.sections.push_back(tip);
  const int corner = shell.mesh().nearest_node({1, 0, 0});
  return follow(shell, supports, loads, 0.05, 0.1, [corner](const Eigen::VectorXd& u) {
    return std::array<double, 2>{-u[7 * corner], u[7 * corner + 2]};
  });
}

/// 3.3: slit annular plate; w at the inner and outer corner of the loaded edge.
inline Rows slit_annulus(const std::vector<double>& loads, const std::array<int, 3>& cells,
                         int degree) {
  const Shell shell = make_shell(
      {cells, false, degree},
      [](const Vec3& p) {
        const double r = 6 + 4 * p[0], a = 2 * std::numbers::pi * p[1];
        return Vec3(r * std::cos(a), r * std::sin(a), 0);
      },
      [](const Vec3&) { return Vec3(0, 0, 1); }, 0.03, 21e6, 0);
  Supports supports;
  hold(supports, shell.mesh().nodes_on(1, 0), {0, 1, 2, 3, 4, 5});
  supports.dead_load = Eigen::VectorXd::Zero(shell.dof_count());
  for (const auto& [node, share] : parameter_shares(shell.mesh(), 1, 1))
    supports.dead_load[7 * node + 2] = 0.8 * 4 * share;
  const int inner = shell.mesh().nearest_node({0, 1, 0}),
            outer = shell.mesh().nearest_node({1, 1, 0});
  return follow(shell, supports, loads, 0.0125, 0.05, [=](const Eigen::VectorXd& u) {
    return std::array<double, 2>{u[7 * inner + 2], u[7 * outer + 2]};
  });
}

/// 3.4: quarter of the hemisphere with a hole; displacements of the outward and inward loaded
/// points along their loads.
inline Rows hemisphere(const std::vector<double>& loads, const std::array<int, 3>& cells,
                       int degree) {
  const auto normal = [](const Vec3& p) {
    const double a = std::numbers::pi / 2 * p[0], e = 72 * std::numbers::pi / 180 * p[1];
    return Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  };
  const Shell shell = make_shell(
      {cells, false, degree}, [&](const Vec3& p) { return Vec3(10 * normal(p)); }, normal, 0.04,
      6.825e7, 0.3);
  Supports supports;
  hold(supports, shell.mesh().nodes_on(0, 0), {1, 4});
  hold(supports, shell.mesh().nodes_on(0, 1), {0, 3});
  const int out = shell.mesh().nearest_node({0, 0, 0}), in = shell.mesh().nearest_node({1, 0, 0});
  hold(supports, {shell.mesh().nearest_node({0, 1, 0})}, {2});
  supports.dead_load = Eigen::VectorXd::Zero(shell.dof_count());
  supports.dead_load[7 * out] = 200;
  supports.dead_load[7 * in + 1] = -200;
  return follow(shell, supports, loads, 0.02, 0.1, [=](const Eigen::VectorXd& u) {
    return std::array<double, 2>{u[7 * out], -u[7 * in + 1]};
  });
}

/// 3.7: half of the pinched semi-cylinder; the crown's deflection under the load.
inline Rows semi_cylinder(const std::vector<double>& loads, const std::array<int, 3>& cells,
                          int degree) {
  const auto normal = [](const Vec3& p) {
    return Vec3(std::cos(std::numbers::pi / 2 * p[0]), 0, std::sin(std::numbers::pi / 2 * p[0]));
  };
  const Shell shell = make_shell(
      {cells, false, degree},
      [&](const Vec3& p) { return Vec3(101.6 * normal(p) + Vec3(0, 304.8 * p[1], 0)); }, normal, 3,
      2068.5, 0.3);
  Supports supports;
  hold(supports, shell.mesh().nodes_on(1, 0), {0, 1, 2, 3, 4, 5});
  hold(supports, shell.mesh().nodes_on(0, 0), {2, 5});
  hold(supports, shell.mesh().nodes_on(0, 1), {0, 3});
  const int crown = shell.mesh().nearest_node({1, 1, 0});
  supports.dead_load = Eigen::VectorXd::Zero(shell.dof_count());
  supports.dead_load[7 * crown + 2] = -1000;
  return follow(shell, supports, loads, 0.025, 0.05, [=](const Eigen::VectorXd& u) {
    return std::array<double, 2>{-u[7 * crown + 2], 0};
  });
}

/// The solids: one layer of cells through the thickness, the third parameter.
inline Solid make_body(const Block& block, const Chart& chart, double young, double nu,
                       LawKind law) {
  return {make_solid(block, chart), MaterialLaw(law, Moduli::isotropic(young, nu)),
          [](const Vec3&) { return Mat3(Mat3::Identity()); }};
}

inline Solid solid_cantilever(double length, const std::array<int, 3>& cells, int degree,
                              LawKind law) {
  return make_body(
      {cells, false, degree},
      [length](const Vec3& p) { return Vec3(length * p[0], p[1], 0.1 * (p[2] - 0.5)); }, 1.2e6, 0,
      law);
}

/// -u and w of the tip, the mean of its upper and lower corner (p = 3 has no node in between).
inline std::function<std::array<double, 2>(const Eigen::VectorXd&)> middle_of_tip(
    const Solid& solid) {
  const int low = solid.mesh().nearest_node({1, 0, 0}), high = solid.mesh().nearest_node({1, 0, 1});
  return [=](const Eigen::VectorXd& u) {
    return std::array<double, 2>{-(u[3 * low] + u[3 * high]) / 2,
                                 (u[3 * low + 2] + u[3 * high + 2]) / 2};
  };
}

/// 3.1
inline Rows solid_cantilever_shear(const std::vector<double>& loads,
                                   const std::array<int, 3>& cells, int degree) {
  const Solid solid = solid_cantilever(10, cells, degree, LawKind::svk);
  Supports supports;
  hold(supports, solid.mesh().nodes_on(0, 0), {0, 1, 2}, 3);
  supports.dead_load = Eigen::VectorXd::Zero(solid.dof_count());
  for (const auto& [node, share] : parameter_shares(solid.mesh(), 0, 1))
    supports.dead_load[3 * node + 2] = 4 * share;
  return follow(solid, supports, loads, 0.05, 0.2, middle_of_tip(solid));
}

/// 3.2: the tip's face is a rigid section (with nu = 0, bending does not deform it), Biot law as
/// for the shell.
inline Rows solid_cantilever_moment(const std::vector<double>& loads,
                                    const std::array<int, 3>& cells, int degree) {
  const Solid solid = solid_cantilever(12, cells, degree, LawKind::biot);
  Supports supports;
  hold(supports, solid.mesh().nodes_on(0, 0), {0, 1, 2}, 3);
  Section tip;
  tip.name = "tip";
  tip.center = Vec3(12, 0.5, 0);
  tip.moment = Vec3(0, -50 * std::numbers::pi / 3, 0);
  for (const int node : solid.mesh().nodes_on(0, 1))
    tip.members.push_back(
        {3 * node, solid.mesh().nodes.row(node).transpose() - tip.center, true, 0});
  supports.sections.push_back(tip);
  return follow(solid, supports, loads, 0.05, 0.1, middle_of_tip(solid));
}

/// 3.7: the load is distributed over the crown's nodes through the thickness by their shares; the
/// deflection is their mean with the same weights, which is conjugate to the load.
inline Rows solid_semi_cylinder(const std::vector<double>& loads, const std::array<int, 3>& cells,
                                int degree) {
  const Solid solid = make_body(
      {cells, false, degree},
      [](const Vec3& p) {
        const double r = 101.6 + 3 * (p[2] - 0.5), a = std::numbers::pi / 2 * p[0];
        return Vec3(r * std::cos(a), -304.8 * p[1], r * std::sin(a));
      },
      2068.5, 0.3, LawKind::svk);
  const Mesh& mesh = solid.mesh();
  Supports supports;
  hold(supports, mesh.nodes_on(1, 0), {0, 1, 2}, 3);
  hold(supports, mesh.nodes_on(0, 0), {2}, 3);
  hold(supports, mesh.nodes_on(0, 1), {0}, 3);
  // the nodes on the line through the thickness, in proportion to their shares of the adjacent face
  const std::map<int, double> shares = parameter_shares(mesh, 0, 1);
  std::vector<std::pair<int, double>> line;
  double sum = 0;
  for (const int node : mesh.nodes_on(1, 1))
    if (mesh.parameters(node, 0) > 1 - 1e-9) {
      line.emplace_back(node, shares.at(node));
      sum += shares.at(node);
    }
  supports.dead_load = Eigen::VectorXd::Zero(solid.dof_count());
  for (const auto& [node, share] : line) supports.dead_load[3 * node + 2] = -1000 * share / sum;
  return follow(solid, supports, loads, 0.025, 0.1, [=](const Eigen::VectorXd& u) {
    double mean = 0;
    for (const auto& [node, share] : line) mean -= share / sum * u[3 * node + 2];
    return std::array<double, 2>{mean, 0};
  });
}

/// Compares 3.2 with the strip's exact solution, within `bound` of its length 12, and, within 1 %
/// or 0.002, with the elastica.
inline void expect_rolled(const std::vector<double>& loads, const Rows& path,
                          reference::RolledStrip::Kind kind, double bound) {
  using reference::RolledStrip;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto exact = RolledStrip{}.tip(kind, loads[i]),
               elastica = RolledStrip{}.tip(RolledStrip::Kind::elastica, loads[i]);
    std::printf("%g: %.5f %.5f (exact %.5f %.5f, elastica %.5f %.5f)\n", loads[i], path[i][0],
                path[i][1], exact[0], exact[1], elastica[0], elastica[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(path[i][k], exact[k], bound) << "load " << loads[i];
      EXPECT_NEAR(path[i][k], elastica[k], std::max(0.002, 0.01 * std::abs(elastica[k])))
          << "load " << loads[i];
    }
  }
}

}  // namespace vasorod::fem::sze
