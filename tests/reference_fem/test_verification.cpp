// Verification against tables and closed forms that take minutes, not seconds.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.h"
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

// Ratio of the torque to G J D, transversely isotropic S = C : E, G = f E / 2.6: at fixed length, and with
// the length free. The exact one-dimensional solutions; the free-length ones are the stricter test of the
// law, the fixed-length ones of N.
TEST(Verification, TransverselyIsotropicTorsion) {
  struct Row {
    double twist, factor, fixed, free;
  };
  for (const Row& row : {Row{1e-3, 0.1, 1.001184, 0.999990}, Row{1e-3, 1, 0.999738, 0.999699},
                         Row{1e-3, 10, 0.997143, 0.996972}, Row{1e-3, 100, 0.972880, 0.970316},
                         Row{5e-4, 100, 0.993115, 0.992453}, Row{2e-3, 10, 0.988645, 0.987970}}) {
    const double L = 30;
    const TubeShape tube{L, 10, 2, 10, 2, 0, {}};
    const double G = row.factor / 2.6;
    const MaterialLaw law(LawKind::svk, {1, 1, 0.3, 0.3, G, false});
    Ends ends;
    ends.rotation = Vec3(0, 0, row.twist * L);
    const Block block{{6, 2, 1}, true, 4};
    const double scale = G * 12692.0343205028 * row.twist;
    const double fixed = soft_tube(tube, block, law, ends).force[5] / scale;
    ends.fixed[2] = false;
    const double free = soft_tube(tube, block, law, ends).force[5] / scale;
    std::printf("D %g f %g: %.6f (%.6f), %.6f (%.6f)\n", row.twist, row.factor, fixed, row.fixed, free,
                row.free);
    EXPECT_NEAR(fixed, row.fixed, 1e-4) << row.twist << " " << row.factor;
    EXPECT_NEAR(free, row.free, 1e-4) << row.twist << " " << row.factor;
  }
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
  const double a2 = 121, b2 = 81, nu = 0.3, a4 = a2 * a2 + b2 * b2, ab = a2 * b2;
  const double hutchinson = 6 * (a2 + b2) * (a2 + b2) * (1 + nu) * (1 + nu) /
                            (7 * a4 + 34 * ab + nu * (12 * a4 + 48 * ab) + nu * nu * (4 * a4 + 16 * ab));
  EXPECT_NEAR(k, hutchinson, 1e-3);
}

// Rivlin's torsion of a neo-Hookean tube, mu = 1, nearly incompressible (bulk modulus 1e4 mu, p = 4:
// locking-free), walls free.
TEST(Verification, RivlinTorsionOfANearlyIncompressibleTube) {
  const TubeShape tube{20, 10, 2, 10, 2, 0, {}};
  Ends ends;
  ends.rotation = Vec3(0, 0, 0.01 * 20);
  const Vec6 f = soft_tube(tube, {{6, 2, 1}, true, 4}, MaterialLaw::split(1, 1e4), ends, 0.25).force;
  std::printf("M %.6f (126.30915), N %.6f (-0.63307)\n", f[5], f[2]);
  EXPECT_NEAR(f[5] / 126.30915450, 1, 2e-4);
  EXPECT_NEAR(f[2] / -0.63306990, 1, 5e-3);
}

// Cook's membrane, compressible split neo-Hookean, plane strain, dead shear of 1 N: 14.74 mm at the middle of
// the right edge.
TEST(Verification, CooksMembrane) {
  const double mu = 0.4225, nu = 0.3, kappa = 2 * mu * (1 + nu) / (3 * (1 - 2 * nu));
  const Solid solid(make_solid({{8, 8, 1}, false, 3},
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
  const FaceMesh face = face_of(mesh, 0, 1);
  const double cells = static_cast<double>(face.nodes.size());
  for (const auto& nodes : face.nodes)
    for (std::size_t a = 0; a < nodes.size(); ++a)
      supports.dead_load[3 * nodes[a] + 1] +=
          face.weights.dot(face.shape.col(static_cast<Eigen::Index>(a))) / cells;
  const System system(solid, supports);
  State state;
  System::Assembly assembly;
  ASSERT_EQ(follow_path(system, state, assembly).status, PathStatus::complete);
  const double tip = state.u[3 * mesh.nearest_node({1, 0.5, 0}) + 1];
  std::printf("Cook %.4f (14.74)\n", tip);
  EXPECT_NEAR(tip, 14.74, 0.015);
}

// Half of a tube of L / R = 10, t / R = 0.2, bent by its rigid end, which may move along the axis: the moment
// rises, passes its largest value and falls while the section collapses. No control but the rotation is
// needed there.
TEST(Verification, BentTubeIsFollowedPastItsLargestMoment) {
  const TubeShape tube{50, 10, 2, 10, 2, 0, {}};
  const Shell shell(make_surface({{8, 6, 1}, true, 3},
                                 [&](const Vec3& p) {
                                   return tube.point({p[0], p[1], 0.5});
                                 }),
                    MaterialLaw(LawKind::biot, Moduli::isotropic(1, 0.3)), tube_body(tube), 3);
  Supports supports;
  for (const int node : shell.mesh().nodes_on(1, 0))
    for (const int c : {2, 5}) supports.prescribed.emplace_back(7 * node + c, 0);
  Section end = end_section(shell, tube, 1, false);
  end.fixed = {true, true, false, true, true, true};
  end.rotation = Vec3(0, 45 * std::numbers::pi / 180, 0);
  supports.sections.push_back(end);
  const System system(shell, supports);
  State state;
  System::Assembly assembly;
  StepperOptions options;
  options.first_step = options.largest_step = 0.05;
  double largest = 0, at = 0;
  options.on_step = [&](double load, const State&, const System::Assembly& a) {
    const double moment = a.section_force[0][4];
    std::printf("%.2f degrees: moment %.4f\n", 90 * load, moment);
    if (moment > largest) largest = moment, at = load;
  };
  const StepperSummary summary = follow_path(system, state, assembly, options);
  EXPECT_EQ(summary.status, PathStatus::complete);
  EXPECT_LT(assembly.section_force[0][4], 0.95 * largest);
  EXPECT_GT(90 * at, 35);
  EXPECT_LT(90 * at, 70);
}

}  // namespace
}  // namespace vasorod::fem
