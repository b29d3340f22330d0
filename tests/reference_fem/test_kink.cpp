// A bent tube through its kink: L / R = 10, t / R = 0.2, the ends rotate as rigid disks and may
// approach. A quarter of the tube by symmetry: the kink forms in the middle. The angle has a limit
// point: the path in arc length shows it, and a tube with prescribed end rotations snaps across it.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "reference_fem/sze.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {
namespace {

constexpr double radius = 10, thickness = 2, half_length = 50;
constexpr double full_angle =
    75;  ///< degrees between the ends; a little beyond the walls would touch

/// A point of the path; angle between the ends in degrees, moment and energy of the whole tube.
struct Bent {
  double angle, moment, energy, height;  ///< of the middle section over its diameter
};

struct Tube {
  TubeShape shape{half_length, radius, thickness, radius, thickness, 0, {}};
  Shell shell;
  Supports supports;

  static Vec3 quarter(const Vec3& p) { return {0.5 * p[0], p[1], 0.5}; }

  explicit Tube(const std::array<int, 3>& cells)
      : shell(make_surface({cells, false, 3},
                           [this](const Vec3& p) { return shape.point(quarter(p)); }),
              MaterialLaw(LawKind::biot, Moduli::isotropic(1, 0.3)),
              {[this](const Vec3& p) { return Vec3(shape.axes(quarter(p)).col(0)); },
               [](const Vec3&) { return thickness; },
               [this](const Vec3& p) { return shape.axes(quarter(p)); }},
              3) {
    const Mesh& mesh = shell.mesh();
    sze::hold(supports, mesh.nodes_on(1, 0), {2, 5});
    for (const int side : {0, 1})
      for (const int node : mesh.nodes_on(0, side))
        if (mesh.parameters(node, 1) < 1 - 1e-9) sze::hold(supports, {node}, {1, 4});
    Section end = end_section(shell, shape, 1, false);
    end.fixed = {true, true, false, true, true, true};
    end.rotation = Vec3(0, full_angle / 2 * std::numbers::pi / 180, 0);
    supports.sections.push_back(end);
  }

  std::vector<Bent> bend(StepperOptions options) const {
    const System system(shell, supports);
    const int inside = shell.mesh().nearest_node({0, 0, 0}),
              outside = shell.mesh().nearest_node({1, 0, 0});
    std::vector<Bent> path;
    options.on_step = [&](double load, const State& at, const System::Assembly& a) {
      const double height = 2 * radius + at.u[7 * inside] - at.u[7 * outside];
      path.push_back(
          {full_angle * load, 2 * a.section_force[0][4], 4 * a.energy, height / (2 * radius)});
    };
    State state;
    System::Assembly assembly;
    const StepperSummary summary = follow_path(system, state, assembly, options);
    EXPECT_EQ(summary.status, PathStatus::complete);
    EXPECT_EQ(summary.positive_definite, true);
    return path;
  }
};

const Bent& largest_moment(const std::vector<Bent>& path) {
  return *std::max_element(path.begin(), path.end(),
                           [](const Bent& a, const Bent& b) { return a.moment < b.moment; });
}

/// Where the angle reverses, and where it increases again.
struct Fold {
  Bent first, second;
};

Fold fold_of(const std::vector<Bent>& path) {
  std::vector<Bent> turns;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    if ((path[i].angle - path[i - 1].angle) * (path[i + 1].angle - path[i].angle) < 0)
      turns.push_back(path[i]);
  EXPECT_EQ(turns.size(), 2u);
  turns.resize(2);
  return {turns[0], turns[1]};
}

TEST(Kink, IsFollowedThroughTheFoldOfItsAngle) {
  StepperOptions options;
  options.first_step = options.largest_step = 0.02;
  options.largest_jump = 0.5;
  const auto coarse = Tube({6, 12, 1}).bend(options), fine = Tube({6, 14, 1}).bend(options);
  const Fold fold = fold_of(fine), other = fold_of(coarse);
  for (const Bent& b : fine)
    std::printf("%.4f degrees: moment %.4f, energy %.4f, height %.4f\n", b.angle, b.moment,
                b.energy, b.height);
  // on both meshes, the moment has its maximum just before the angle reverses
  EXPECT_NEAR(fold.first.angle, 44.60, 0.03);
  EXPECT_NEAR(fold.first.angle, other.first.angle, 0.03);
  EXPECT_NEAR(fold.second.angle, 39.33, 0.1);
  EXPECT_NEAR(fold.second.angle, other.second.angle, 0.1);
  EXPECT_NEAR(largest_moment(fine).moment, 39.95, 0.02);
  EXPECT_NEAR(largest_moment(fine).moment / largest_moment(coarse).moment, 1, 1e-3);
  EXPECT_LT(largest_moment(fine).angle, fold.first.angle);
  EXPECT_NEAR(fine.back().moment / coarse.back().moment, 1, 5e-3);
  // equilibrium along the whole path: the moment's work is the energy, also where the angle
  // decreases
  double work = 0;
  Bent before{0, 0, 0, 1};
  for (const Bent& b : fine) {
    work += (before.moment + b.moment) / 2 * (b.angle - before.angle) * std::numbers::pi / 180;
    EXPECT_NEAR(work, b.energy, 2e-3 * fine.back().energy) << b.angle;
    EXPECT_LT(b.height, before.height) << b.angle;  // the section only flattens
    before = b;
  }
  EXPECT_GT(before.height, thickness / (2 * radius));  // the walls do not touch yet
}

// With prescribed end rotations the angle cannot decrease: the tube snaps to the state of the
// arc-length path.
TEST(Kink, SnapsToTheSameBranchWhereTheEndsAreTurned) {
  const Tube tube({6, 12, 1});
  StepperOptions options;
  options.first_step = options.largest_step = 0.02;
  options.largest_jump = 0.5;
  const auto followed = tube.bend(options);
  options.largest_jump = StepperOptions{}.largest_jump;
  options.first_step = options.largest_step = 0.05;
  const auto snapped = tube.bend(options);
  const Fold fold = fold_of(followed);
  double after = 0;
  for (std::size_t i = 1; i < snapped.size(); ++i)
    if (after == 0 && snapped[i].moment < 0.8 * snapped[i - 1].moment) {
      std::printf("snaps between %.3f and %.3f degrees: moment %.3f, then %.3f\n",
                  snapped[i - 1].angle, snapped[i].angle, snapped[i - 1].moment, snapped[i].moment);
      EXPECT_GT(snapped[i].angle, fold.second.angle);
      EXPECT_LT(snapped[i - 1].angle, fold.first.angle + 0.01);
      after = snapped[i].angle;
    }
  EXPECT_GT(after, 0);
  EXPECT_NEAR(snapped.back().moment / followed.back().moment, 1, 1e-6);
  EXPECT_NEAR(snapped.back().energy / followed.back().energy, 1, 1e-6);
}

}  // namespace
}  // namespace vasorod::fem
