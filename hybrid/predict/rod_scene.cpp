#include "predict/rod_scene.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "data/scene_place.h"
#include "geometry/rigid_motion.h"
#include "predict/result_parts.h"
#include "predict/stopwatch.h"
#include "rod/strains.h"

namespace vasorod {
namespace {

/// Second-order errors cancel in (4 fine - coarse) / 3. Poses are extrapolated along the screw from
/// coarse to fine.
RodSolution extrapolated(const RodTree& coarse_tree, const RodSolution& coarse,
                         const RodTree& fine_tree, const RodSolution& fine) {
  const auto mix = [](const auto& c, const auto& f) { return ((4 * f - c) / 3).eval(); };
  RodSolution result = fine;
  result.poses = coarse.poses;
  result.stress = coarse.stress;
  for (std::size_t b = 0; b < coarse_tree.branches.size(); ++b) {
    const RodBranch &small = coarse_tree.branches[b], &large = fine_tree.branches[b];
    for (std::size_t i = 0; i < small.nodes.size(); ++i) {
      const Pose& c = coarse.poses[index(small.nodes[i])];
      const Pose& f = fine.poses[index(large.nodes[2 * i])];
      result.poses[index(small.nodes[i])] = f * exp_motion(log_motion(c.inverse() * f) / 3);
    }
    for (std::size_t i = 0; i < small.elements.size(); ++i) {
      const Vec6 f = 0.5 * (fine.stress[index(large.elements[2 * i])] +
                            fine.stress[index(large.elements[2 * i + 1])]);
      result.stress[index(small.elements[i])] = mix(coarse.stress[index(small.elements[i])], f);
    }
  }
  for (std::size_t i = 0; i < result.reactions.size(); ++i) {
    RodReaction& r = result.reactions[i];
    r.node = coarse.reactions[i].node;
    r.force = mix(coarse.reactions[i].force, fine.reactions[i].force);
    r.moment = mix(coarse.reactions[i].moment, fine.reactions[i].moment);
    r.center = result.poses[index(r.node)].position;
  }
  result.summary.energy = (4 * fine.summary.energy - coarse.summary.energy) / 3;
  result.summary.iterations += coarse.summary.iterations;
  result.summary.counts += coarse.summary.counts;
  result.summary.residual = worst_of(coarse.summary.residual, fine.summary.residual);
  result.summary.status = worse(coarse.summary.status, fine.summary.status);
  return result;
}

/// Values per element of a whole tree.
struct ElementValues {
  std::vector<Vec6> strain, rest, stress;
};

CenterlineResult centerline(const RodTree& tree, const RodBranch& branch, const RodPoses& poses,
                            const ElementValues& values) {
  CenterlineResult line;
  const auto n = static_cast<Eigen::Index>(branch.nodes.size());
  line.rest.resize(n, 3);
  line.current.resize(n, 3);
  line.lines.emplace_back();
  double s = 0;
  const std::vector<Vec6> now = branch_node_values(tree, branch, values.strain);
  const std::vector<Vec6> then = branch_node_values(tree, branch, values.rest);
  const std::vector<Vec6> stress = branch_node_values(tree, branch, values.stress);
  for (std::size_t i = 0; i < branch.nodes.size(); ++i) {
    const std::size_t node = index(branch.nodes[i]);
    const auto row = static_cast<Eigen::Index>(i);
    line.rest.row(row) = tree.rest[node].position.transpose();
    line.current.row(row) = poses[node].position.transpose();
    if (i > 0) s += tree.elements[index(branch.elements[i - 1])].length;
    line.abscissa.push_back(s);
    line.directors.push_back(poses[node].rotation);
    line.v.push_back(now[i].head<3>());
    line.u.push_back(now[i].tail<3>());
    line.v0.push_back(then[i].head<3>());
    line.u0.push_back(then[i].tail<3>());
    line.force.push_back(stress[i].head<3>());
    line.moment.push_back(stress[i].tail<3>());
    line.lines.back().push_back(static_cast<int>(i));
  }
  return line;
}

VesselMetrics metrics(const std::string& name, const CenterlineResult& line) {
  VesselMetrics m;
  m.vessel = name;
  m.stretch = {line.v[0].z(), line.v[0].z()};
  for (const char* extreme : {"smallest_stretch", "largest_stretch", "largest_curvature"})
    m.where[extreme] = line.current.row(0);
  for (std::size_t i = 0; i < line.v.size(); ++i) {
    const Vec3 here = line.current.row(static_cast<Eigen::Index>(i));
    if (line.v[i].z() < m.stretch[0]) {
      m.stretch[0] = line.v[i].z();
      m.where["smallest_stretch"] = here;
    }
    if (line.v[i].z() > m.stretch[1]) {
      m.stretch[1] = line.v[i].z();
      m.where["largest_stretch"] = here;
    }
    if (const double curvature = line.u[i].head<2>().norm(); curvature > m.largest_curvature) {
      m.largest_curvature = curvature;
      m.where["largest_curvature"] = here;
    }
  }
  return m;
}

/// Forces on each branch: supports, loads, and the forces of adjoining branches. `residual` is set
/// to the largest single force, or the largest moment over the length.
std::vector<Balance> forces_on_branches(const RodAssembly& assembly, const RodSolution& solution) {
  const RodTree& tree = assembly.tree;
  std::vector<Balance> balance(tree.branches.size());
  std::vector<int> branch_of(tree.rest.size(), 0);  // of a node: the branch it ends, or the root's
  for (std::size_t b = 0; b < tree.branches.size(); ++b) {
    balance[b].vessel = assembly.vessels[b];
    for (std::size_t i = 1; i < tree.branches[b].nodes.size(); ++i)
      branch_of[index(tree.branches[b].nodes[i])] = static_cast<int>(b);
  }
  const auto add = [](Balance& on, Vec3 Balance::*kind, const Vec3& force) {
    on.*kind += force;
    on.residual = std::max(on.residual, force.norm());
  };
  for (const RodReaction& r : solution.reactions)
    add(balance[index(branch_of[index(r.node)])], &Balance::support, r.force);
  for (const RodLoad& l : assembly.conditions.loads)
    add(balance[index(branch_of[index(l.node)])], &Balance::load, l.force);
  for (std::size_t b = 0; b < tree.branches.size(); ++b) {
    // Without forces, a moment over the branch's length sets the scale of the round-off.
    double length = 0, moment = 0;
    for (const int e : tree.branches[b].elements) {
      length += tree.elements[index(e)].length;
      moment = std::max(moment, solution.stress[index(e)].tail<3>().norm());
    }
    balance[b].residual = std::max(balance[b].residual, moment / length);
    if (tree.branches[b].parent < 0) continue;
    const std::size_t e = index(tree.branches[b].elements.front());
    const Vec3 force = start_wrench(tree.elements[e], solution.poses, solution.stress[e]).head<3>();
    add(balance[b], &Balance::join, force);
    add(balance[index(tree.branches[b].parent)], &Balance::join, -force);
  }
  return balance;
}

void add(const RodAssembly& assembly, const RodSolution& solution,
         const std::vector<Balance>& balance, Result& result) {
  const RodTree& tree = assembly.tree;
  add_rod(assembly.vessels.front(), solution.summary, true, result);
  *result.counts += solution.summary.counts;
  result.model.rod_nodes += tree.node_count();
  for (const RodAssembly::End& end : assembly.ends) {
    EndReaction reaction;
    reaction.vessel = end.vessel;
    reaction.end = end.name;
    reaction.center = solution.poses[index(end.node)].position;
    if (end.support >= 0) {
      reaction.force = solution.reactions[index(end.support)].force;
      reaction.moment = solution.reactions[index(end.support)].moment;
    }
    result.ends.push_back(reaction);
  }
  for (Balance b : balance) {
    if (b.residual > 0) b.residual = (b.support + b.load + b.join).norm() / b.residual;
    result.balance.push_back(b);
  }
  ElementValues values{element_strains(tree, solution.poses), {}, solution.stress};
  for (const RodElement& e : tree.elements) values.rest.push_back(e.rest_strain);
  for (std::size_t b = 0; b < tree.branches.size(); ++b) {
    VesselResult vessel;
    vessel.name = assembly.vessels[b];
    vessel.centerline = centerline(tree, tree.branches[b], solution.poses, values);
    for (std::size_t i = 0; i < vessel.centerline->v.size(); ++i)
      result.validity.largest_strain =
          worst_of(result.validity.largest_strain,
                   (vessel.centerline->v[i] - vessel.centerline->v0[i]).norm());
    result.metrics.push_back(metrics(vessel.name, *vessel.centerline));
    result.vessels.push_back(std::move(vessel));
  }
}

}  // namespace

Result solve_rod_scene(const Scene& scene, const SolveOptions& options) {
  Stopwatch watch;
  Result result = begin_result(scene.name, "rod", scene.units, options.threads);
  result.counts.emplace();
  result.model.terms = {"rod"};
  result.model.left_out = {{"surface", "the vessels are bare rods"},
                           {"contact", "bare rods have no surface"},
                           {"kinking and wrinkling", "bare rods have no wall"}};
  RodOptions rod_options;
  rod_options.stop = options.stop;
  const std::vector<RodAssembly> rods = assemble_rods(scene);
  const std::vector<RodAssembly> halves =
      scene.extrapolate ? assemble_rods(scene, 2) : std::vector<RodAssembly>{};
  for (std::size_t r = 0; r < rods.size(); ++r) {
    const std::string where = place_in(scene) + ": rod '" + rods[r].vessels.front() + "'";
    if (options.progress) options.progress("rod of " + rods[r].vessels.front());
    check_tree(rods[r].tree, where);
    check_conditions(rods[r].tree, rods[r].conditions, where);
    RodSolution solution = solve_rod(rods[r].tree, rods[r].conditions, rod_options);
    std::vector<Balance> balance = forces_on_branches(rods[r], solution);
    if (scene.extrapolate) {
      const RodSolution fine = solve_rod(halves[r].tree, halves[r].conditions, rod_options);
      const std::vector<Balance> fine_balance = forces_on_branches(halves[r], fine);
      for (std::size_t b = 0; b < balance.size(); ++b) {
        balance[b].support = (4 * fine_balance[b].support - balance[b].support) / 3;
        balance[b].join = (4 * fine_balance[b].join - balance[b].join) / 3;
      }
      solution = extrapolated(rods[r].tree, solution, halves[r].tree, fine);
    }
    add(rods[r], solution, balance, result);
  }
  watch.lap("solve");
  if (options.solved) options.solved();
  result.seconds = watch.seconds();
  return result;
}

}  // namespace vasorod
