#include "rod/strains.h"

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "rod/energy.h"

namespace vasorod {

std::vector<Vec6> element_strains(const RodTree& tree, const RodPoses& poses) {
  std::vector<Vec6> strains;
  strains.reserve(tree.elements.size());
  for (const RodElement& e : tree.elements)
    strains.push_back(element_strain(e, poses[index(e.first)], poses[index(e.second)]));
  return strains;
}

std::vector<Vec6> branch_node_values(const RodTree& tree, const RodBranch& branch,
                                     const std::vector<Vec6>& per_element) {
  const std::vector<int>& elements = branch.elements;
  std::vector<Vec6> values{per_element[index(elements.front())]};
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    const std::size_t a = index(elements[i]), b = index(elements[i + 1]);
    const double la = tree.elements[a].length, lb = tree.elements[b].length;
    values.push_back((la * per_element[a] + lb * per_element[b]) / (la + lb));
  }
  values.push_back(per_element[index(elements.back())]);
  return values;
}

Vec6 start_wrench(const RodElement& element, const RodPoses& poses, const Vec6& stress) {
  const Pose &first = poses[index(element.first)], &second = poses[index(element.second)];
  const Vec6 xi = element.length * element_strain(element, first, second);
  const Vec6 body = right_jacobian_inverse(xi).transpose() * stress;
  const Vec3 force = second.rotation * body.head<3>(), moment = second.rotation * body.tail<3>();
  Vec6 wrench;
  wrench << -force, -moment - (second.position - first.position).cross(force);
  return wrench;
}

}  // namespace vasorod
