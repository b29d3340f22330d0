#include "rod/scan_stress.h"

#include "rod/rod_problem.h"

namespace vasorod {

std::vector<Vec6> scan_stress(const RodTree& tree, const RodConditions& conditions) {
  RodConditions still = conditions;
  for (RodSupport& support : still.supports) support.motion = {};
  RodProblem problem(tree, still);
  const RodState rest = problem.state_at(tree.rest);
  problem.elimination().factor(rest.poses, rest.strain, rest.stress);
  RodStep step;
  problem.elimination().solve(step.twist, step.stress, step.stretch);
  std::vector<Vec6> stress(tree.elements.size());
  for (std::size_t k = 0; k < step.stress.size(); ++k)
    stress[index(problem.rod().element_of[k])] << step.stress[k].head<3>() * problem.rod().force(),
        step.stress[k].tail<3>() * problem.rod().moment;
  return stress;
}

}  // namespace vasorod
