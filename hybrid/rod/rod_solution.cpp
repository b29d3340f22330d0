#include "rod/rod_solution.h"

#include <algorithm>

namespace vasorod {

RodSolution report_solution(RodProblem& problem, const RodState& state, const RodSummary& summary) {
  RodSolution solution;
  solution.summary = summary;
  solution.summary.counts.factorisations = problem.elimination().factorisations();
  solution.summary.counts.solves = problem.elimination().solves();
  const ScaledRod& rod = problem.rod();
  const std::vector<RodLink>& links = problem.links();
  const std::vector<Pose>& poses = state.poses;
  // the imbalance is measured relative to the largest wrench
  double largest = 0, unbalanced = 0, misfit = 0, energy = 0;
  std::vector<Vec6> sum(poses.size(), Vec6::Zero());
  for (std::size_t k = 0; k < links.size(); ++k) {
    const Vec6 second = wrench_on_second(poses[k + 1], state.strain[k], state.stress[k]);
    sum[k + 1] += second;
    sum[index(links[k].parent)] += wrench_on_first(links, poses, k, second);
    largest = std::max(largest, second.squaredNorm());
    const Vec6 strain = elastic_strain(links[k], state.stress[k]);
    const Vec6 of_wall = state.stress[k] + links[k].lumen;
    energy += 0.5 * elastic_strain(links[k], of_wall).dot(of_wall);
    misfit = std::max(misfit, (state.strain[k] - links[k].natural - strain).squaredNorm());
  }
  largest = std::sqrt(largest);
  misfit = std::sqrt(misfit);
  for (const NodeCondition& c : problem.conditions()) {
    Vec6& s = sum[index(c.node)];
    const Vec6 load = c.load(poses[index(c.node)]);
    s -= load;
    largest = std::max({largest, load.head<3>().norm(), load.tail<3>().norm()});
    for (int i = 0; i < 6; ++i) {
      if (!c.fixed[index(i)]) continue;
      const Vec3 axis = c.frame.col(i % 3);
      const int at = i < 3 ? 0 : 3;
      s.segment<3>(at) -= axis * axis.dot(s.segment<3>(at));
    }
  }
  for (const Vec6& s : sum) unbalanced = std::max(unbalanced, s.squaredNorm());
  unbalanced = std::sqrt(unbalanced);
  solution.summary.residual = std::max(largest > 0 ? unbalanced / largest : 0., misfit);
  solution.summary.energy = energy * rod.moment;

  solution.poses.resize(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k)
    solution.poses[index(rod.node_of[k])] = rod.original(poses[k]);
  solution.stress.resize(state.stress.size());
  for (std::size_t k = 0; k < state.stress.size(); ++k)
    solution.stress[index(rod.element_of[k])] << state.stress[k].head<3>() * rod.force(),
        state.stress[k].tail<3>() * rod.moment;
  problem.update_carried(state, true);
  const std::vector<RodSupport>& supports = problem.given().supports;
  for (std::size_t c = 0; c < supports.size(); ++c) {
    const NodeCondition& condition = problem.conditions()[c];
    const Vec6 reaction = condition.carried - condition.load(poses[index(condition.node)]);
    const int node = supports[c].node;
    solution.reactions.push_back({node, reaction.head<3>() * rod.force(),
                                  reaction.tail<3>() * rod.moment,
                                  solution.poses[index(node)].position});
  }
  return solution;
}

}  // namespace vasorod
