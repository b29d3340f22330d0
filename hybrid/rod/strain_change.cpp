#include "rod/strain_change.h"

#include "rod/energy.h"

namespace vasorod {

double ElementChange::stretch() const {
  const Vec6 rest = strain - change;
  return at_fork ? strain.head<3>().norm() / rest.head<3>().norm() : strain[2] / rest[2];
}

std::vector<ElementChange> element_changes(const RodTree& rod, const RodPoses& poses) {
  std::vector<ElementChange> changes;
  const std::vector<char> at_fork = leaves_fork(rod);
  for (size_t e = 0; e < rod.elements.size(); ++e) {
    const RodElement& element = rod.elements[e];
    const auto first = static_cast<size_t>(element.first),
               second = static_cast<size_t>(element.second);
    ElementChange change;
    change.at_fork = at_fork[e];
    change.strain = element_strain(element, poses[first], poses[second]);
    change.change = change.strain - element.rest_strain;
    if (!rod.radius.empty()) change.radius = 0.5 * (rod.radius[first] + rod.radius[second]);
    change.rest_middle = 0.5 * (rod.rest[first].position + rod.rest[second].position);
    change.middle = 0.5 * (poses[first].position + poses[second].position);
    changes.push_back(change);
  }
  return changes;
}

std::vector<ElementChange> node_changes(const RodTree& rod,
                                        const std::vector<ElementChange>& elements) {
  std::vector<ElementChange> nodes(rod.rest.size());
  std::vector<int> count(rod.rest.size(), 0);
  const auto add = [&](size_t node, const ElementChange& element) {
    nodes[node].strain += element.strain;
    nodes[node].change += element.change;
    ++count[node];
  };
  for (size_t e = 0; e < elements.size(); ++e)
    if (!elements[e].at_fork)
      for (const int node : {rod.elements[e].first, rod.elements[e].second})
        add(static_cast<size_t>(node), elements[e]);
  // A side branch of one element has no other element at its end node.
  for (size_t e = 0; e < elements.size(); ++e)
    for (const int node : {rod.elements[e].first, rod.elements[e].second})
      if (count[static_cast<size_t>(node)] == 0) add(static_cast<size_t>(node), elements[e]);
  for (size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].strain /= count[i];
    nodes[i].change /= count[i];
    if (!rod.radius.empty()) nodes[i].radius = rod.radius[i];
  }
  return nodes;
}

}  // namespace vasorod
