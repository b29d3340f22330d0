#include "rod/scaled_rod.h"

#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "rod/conditions.h"

namespace vasorod {

Pose ScaledRod::original(const Pose& p) const {
  return {nearest_rotation(p.rotation), origin + length * p.position};
}

ScaledRod scale(const RodTree& tree) {
  ScaledRod rod;
  rod.length = length_scale(tree);
  rod.origin = tree.rest[0].position;
  double weight = 0, bending = 0;
  for (const RodElement& e : tree.elements) {
    bending += e.length * 0.5 * (e.stiffness(3, 3) + e.stiffness(4, 4));
    weight += e.length;
  }
  rod.moment = bending / weight / rod.length;

  const int n = tree.node_count();
  // elements that leave each node, in order: those of node i are leaving[first_of[i]] to
  // leaving[first_of[i + 1]]
  std::vector<int> first_of(index(n) + 1, 0), leaving(tree.elements.size());
  for (const RodElement& e : tree.elements) ++first_of[index(e.first) + 1];
  for (std::size_t i = 0; i < index(n); ++i) first_of[i + 1] += first_of[i];
  std::vector<int> next(first_of.begin(), first_of.end() - 1);
  for (std::size_t e = 0; e < tree.elements.size(); ++e)
    leaving[index(next[index(tree.elements[e].first)]++)] = static_cast<int>(e);
  rod.new_of.assign(index(n), -1);
  std::vector<int>
      waiting;  // elements whose first node is numbered; depth first keeps a branch together
  const auto number = [&](int node) {
    rod.new_of[index(node)] = static_cast<int>(rod.node_of.size());
    rod.node_of.push_back(node);
    for (int at = first_of[index(node) + 1]; at-- > first_of[index(node)];)
      waiting.push_back(leaving[index(at)]);
  };
  rod.node_of.reserve(index(n));
  rod.element_of.reserve(tree.elements.size());
  number(0);
  while (!waiting.empty()) {
    const int e = waiting.back();
    waiting.pop_back();
    rod.element_of.push_back(e);
    number(tree.elements[index(e)].second);
  }
  return rod;
}

Mat6 ScaledRod::stiffness(const RodElement& element) const {
  Vec6 unit;  // units of strain over the square root of the unit of energy
  unit << Vec3::Constant(length), Vec3::Ones();
  unit /= std::sqrt(moment * element.length);
  return unit.asDiagonal() * element.stiffness * unit.asDiagonal();
}

// The lumen's energy -p . xi is linear: with it the link is at ease at n + C^-1 p.
void ScaledRod::set_stiffness(const RodElement& element, const Mat6& stiffness,
                              RodLink& link) const {
  link.stiffness = stiffness;
  link.natural << link.length * element.natural_strain.head<3>(),
      element.length * element.natural_strain.tail<3>();
  link.lumen << element.lumen.head<3>() / force(), element.lumen.tail<3>() / moment;
  if (!link.lumen.isZero(0)) link.natural += elastic_strain(link, link.lumen);
}

std::vector<RodLink> scaled_links(const RodTree& tree, const ScaledRod& rod) {
  std::vector<RodLink> links;
  links.reserve(rod.element_of.size());
  for (const int e : rod.element_of) {
    const RodElement& element = tree.elements[index(e)];
    RodLink& link = links.emplace_back();
    link.parent = rod.new_of[index(element.first)];
    link.length = element.length / rod.length;
    link.start = {element.start.rotation, element.start.position / rod.length};
    link.starts_at_node = element.start.rotation.isIdentity(0) && element.start.position.isZero(0);
    rod.set_stiffness(element, rod.stiffness(element), link);
  }
  return links;
}

Vec6 link_strain(const std::vector<RodLink>& links, const std::vector<Pose>& poses, std::size_t k) {
  return log_motion(link_start(links[k], poses[index(links[k].parent)]).inverse() * poses[k + 1]);
}

Vec6 wrench_on_second(const Pose& second, const Vec6& strain, const Vec6& stress) {
  const Vec6 body = right_jacobian_inverse(strain).transpose() * stress;
  Vec6 w;
  w << second.rotation * body.head<3>(), second.rotation * body.tail<3>();
  return w;
}

Vec6 wrench_on_first(const std::vector<RodLink>& links, const std::vector<Pose>& poses,
                     std::size_t k, const Vec6& on_second) {
  Vec6 w = -on_second;
  w.tail<3>() -=
      (poses[k + 1].position - poses[index(links[k].parent)].position).cross(on_second.head<3>());
  return w;
}

}  // namespace vasorod
