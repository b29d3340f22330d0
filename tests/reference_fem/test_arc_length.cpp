// A shallow arch under a dead load that snaps through: the path in arc length compared with the
// path under an imposed displacement of the crown.
#include <cmath>
#include <gtest/gtest.h>

#include "reference_fem/sze.h"

namespace vasorod::fem {
namespace {

/// Half of a hinged cylindrical strip, radius 100, half angle 0.2, width 1, thickness 1.4. Rise
/// over thickness is 1.4, so the strip snaps; above about 2 the crown's deflection would reverse
/// too. The crown is at parameter 0.
struct Arch {
  Shell shell = sze::make_shell(
      {{4, 1, 1}, false, 3},
      [](const Vec3& p) {
        return Vec3(100 * std::sin(0.2 * p[0]), p[1], 100 * std::cos(0.2 * p[0]));
      },
      [](const Vec3& p) { return Vec3(std::sin(0.2 * p[0]), 0, std::cos(0.2 * p[0])); }, 1.4, 1e4,
      0);
  Supports supports;

  Arch() {
    sze::hold(supports, shell.mesh().nodes_on(0, 0), {0, 3});
    sze::hold(supports, shell.mesh().nodes_on(0, 1), {0, 1, 2, 4});
  }
};

struct Point {
  double load, crown;
};

/// Force that holds the crown at `down` below its rest position.
double held_force(double down) {
  Arch arch;
  const std::vector<int> crown = arch.shell.mesh().nodes_on(0, 0);
  for (const int node : crown) arch.supports.prescribed.emplace_back(7 * node + 2, -down);
  const System system(arch.shell, arch.supports);
  State state;
  System::Assembly assembly;
  StepperOptions options;
  options.largest_step = 0.05;
  options.arc_steps = 0;
  EXPECT_EQ(follow_path(system, state, assembly, options).status, PathStatus::complete);
  double force = 0;
  for (const int node : crown) force -= assembly.nodal[7 * node + 2];
  return force;
}

TEST(ArcLength, FollowsAShallowArchThroughItsLimitPoints) {
  Arch arch;
  const double full = 12;
  arch.supports.dead_load = Eigen::VectorXd::Zero(arch.shell.dof_count());
  for (const auto& [node, share] : parameter_shares(arch.shell.mesh(), 0, 0))
    arch.supports.dead_load[7 * node + 2] = -full * share;
  const int crown = arch.shell.mesh().nearest_node({0, 0, 0});
  const System system(arch.shell, arch.supports);
  StepperOptions options;
  options.first_step = 0.05;
  options.largest_step = 0.05;
  options.largest_jump = 0.7;
  std::vector<Point> path;
  options.on_step = [&](double load, const State& at, const System::Assembly&) {
    path.push_back({load, -at.u[7 * crown + 2]});
  };
  State state;
  System::Assembly assembly;
  const StepperSummary summary = follow_path(system, state, assembly, options);
  ASSERT_EQ(summary.status, PathStatus::complete);
  EXPECT_EQ(summary.load, 1);
  EXPECT_EQ(summary.positive_definite, true);
  ASSERT_EQ(summary.limit_loads.size(), 1u);
  // the crown moves down all the way; the load decreases between two limit points
  std::size_t lowest = 0;
  double highest = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_GT(path[i].crown, path[i - 1].crown);
    if (path[i].load < path[i - 1].load && (lowest == 0 || path[i].load < path[lowest].load))
      lowest = i;
  }
  ASSERT_GT(lowest, 0u);
  for (std::size_t i = 0; i < lowest; ++i) highest = std::max(highest, path[i].load);
  EXPECT_LT(path[lowest].load, 0.8 * highest);
  EXPECT_NEAR(summary.limit_loads[0], highest, 0.02 * highest);
  for (const std::size_t i : {lowest / 2, lowest, path.size() - 1})
    EXPECT_NEAR(held_force(path[i].crown) / (full * path[i].load), 1, 1e-6) << path[i].crown;

  options.arc_steps = 0;  // the path then ends at the first limit point and states where
  options.on_step = nullptr;
  const StepperSummary stopped = follow_path(system, state, assembly, options);
  EXPECT_EQ(stopped.status, PathStatus::stuck);
  EXPECT_LE(stopped.load, highest + 1e-9);
  EXPECT_GT(stopped.load, 0.9 * highest);
}

}  // namespace
}  // namespace vasorod::fem
