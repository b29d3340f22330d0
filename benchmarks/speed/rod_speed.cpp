// Time of rod solves, by Google Benchmark; --benchmark_format=json writes JSON. Counters:
// microseconds per node and iteration from the solver's summary, in total and for Newton's steps
// alone (the rest: input checks, set-up, certificate, results). `sweep` measures one linear step,
// `stream` one pass that only reads and writes the same amount of memory.
#include <benchmark/benchmark.h>
#include <limits>

#include "../chain.h"
#include "rod/elimination.h"
#include "rod/scaled_rod.h"

namespace {

using namespace vasorod;
using namespace vasorod::bench;

void report(benchmark::State& state, const RodTree& tree, const RodConditions& conditions) {
  RodSummary best;
  best.seconds = std::numeric_limits<double>::infinity();
  for (auto _ : state) {
    const RodSolution s = solve_rod(tree, conditions);
    benchmark::DoNotOptimize(s.poses.data());
    if (s.summary.seconds < best.seconds) best = s.summary;
  }
  // of the fastest solve: this is wall-clock time, and other programs run
  const double all = static_cast<double>(best.iterations) * tree.node_count();
  state.counters["iterations"] = best.iterations;
  state.counters["ms"] = 1e3 * best.seconds;
  state.counters["us_per_node_iteration"] = 1e6 * best.seconds / all;
  state.counters["us_of_newton"] = 1e6 * best.sweep_seconds / all;
  state.SetLabel(to_string(best.status));
}

void elastica(benchmark::State& state) {  // 81 nodes, P L^2 / E I = 5, E A L^2 / E I = 1e8
  const RodTree tree = chain(1, Vec3::Zero(), 80, stiffness(1e8, 1e8, 1, 1));
  report(state, tree, cantilever(tree, {5, 0, 0}));
}
BENCHMARK(elastica)->Unit(benchmark::kMillisecond);

void bend45(benchmark::State& state) {
  const RodTree tree =
      chain(25 * std::numbers::pi, {0, .01, 0}, 64, stiffness(5e6, 1e7, 1e7 / 12, 833333.3));
  report(state, tree, cantilever(tree, {0, 600, 0}));
}
BENCHMARK(bend45)->Unit(benchmark::kMillisecond);

void end_pose(benchmark::State& state) {
  const RodTree tree = chain(1, Vec3::Zero(), 64, stiffness(4.8e6, 1.2e7, 1, .8));
  RodConditions conditions;
  conditions.supports = {clamp(0), clamp(64)};
  conditions.supports[1].motion = {Vec3(1, 1, .3).normalized() * (std::numbers::pi / 3),
                                   {.05, .1, -.2}};
  report(state, tree, conditions);
}
BENCHMARK(end_pose)->Unit(benchmark::kMillisecond);

void long_bend(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const RodTree tree =
      chain(25 * std::numbers::pi, {0, .01, 0}, n, stiffness(5e6, 1e7, 1e7 / 12, 833333.3));
  report(state, tree, cantilever(tree, {0, 600, 0}));
}
BENCHMARK(long_bend)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);

// One factorisation and one back substitution; then the cost of only reading and writing the same
// memory.
void sweep(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  std::vector<RodLink> links(static_cast<std::size_t>(n));
  std::vector<Pose> poses(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i < n; ++i) {
    RodLink& link = links[static_cast<std::size_t>(i)];
    link.parent = i;
    link.length = 1. / n;
    link.natural << 0, 0, link.length, 0, 0, 0;
    link.stiffness = stiffness(1e4, 1e4, 1, 1) / link.length;
    poses[static_cast<std::size_t>(i) + 1] =
        poses[static_cast<std::size_t>(i)] *
        exp_motion(Vec6(link.length * Vec6(0.1 * Vec6::Ones())) + link.natural);
  }
  std::vector<Vec6> strain;
  for (std::size_t k = 0; k < links.size(); ++k) strain.push_back(link_strain(links, poses, k));
  NodeCondition root;
  root.fixed.fill(true);
  RodElimination elimination(links, {root});
  std::vector<Vec6> stress(links.size(), Vec6(0.1 * Vec6::Ones())), step, next, stretch;
  for (auto _ : state) {
    elimination.factor(poses, strain, stress);
    elimination.solve(step, next, stretch);
    benchmark::DoNotOptimize(step.data());
  }
  state.counters["us_per_node"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * n * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(sweep)->Arg(80)->Arg(10000)->Unit(benchmark::kMicrosecond);

void stream(benchmark::State& state) {
  // Stored per node between the two passes: 6 x 8, 15, two 3 x 3, two 6 and a 3; in addition S, g
  // and C/L, the pose, strain and stress that are read, and the twist, stretch and stress that are
  // written.
  constexpr std::size_t doubles = 48 + 15 + 18 + 12 + 3 + 36 + 6 + 36 + 12 + 6 + 6 + 18;
  const std::size_t n = static_cast<std::size_t>(state.range(0)) * doubles;
  std::vector<double> blocks(n, 1.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) blocks[i] = blocks[i] * 0.999 + 0.001;
    benchmark::ClobberMemory();
  }
  state.counters["us_per_node"] =
      benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)) * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(stream)->Arg(80)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
