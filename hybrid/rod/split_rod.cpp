#include "rod/split_rod.h"

#include <algorithm>
#include <stdexcept>

#include "data/index.h"

namespace vasorod {
namespace {

// Branch and position of an element in its branch.
std::pair<size_t, size_t> branch_of_element(const RodTree& tree, int element) {
  for (size_t b = 0; b < tree.branches.size(); ++b) {
    const auto& elements = tree.branches[b].elements;
    const auto found = std::find(elements.begin(), elements.end(), element);
    if (found != elements.end()) return {b, static_cast<size_t>(found - elements.begin())};
  }
  throw std::logic_error("split_rod: the element is on no branch");
}

// Renumbers the tree's nodes and elements along its branches. Only nodes and elements that belong
// to a branch are kept.
RodPart renumbered(const RodTree& tree, int cut_node, size_t original_nodes) {
  RodPart part;
  std::vector<int> node_of(tree.rest.size(), -1);
  auto keep = [&](int node) {
    int& to = node_of[index(node)];
    if (to < 0) {
      to = part.tree.node_count();
      part.tree.rest.push_back(tree.rest[index(node)]);
      if (!tree.radius.empty()) part.tree.radius.push_back(tree.radius[index(node)]);
    }
    return to;
  };
  for (const RodBranch& branch : tree.branches) {
    RodBranch kept;
    kept.name = branch.name;
    kept.parent = branch.parent;
    for (const int node : branch.nodes) kept.nodes.push_back(keep(node));
    for (const int element : branch.elements) {
      RodElement e = tree.elements[index(element)];
      e.first = node_of[index(e.first)];
      e.second = node_of[index(e.second)];
      kept.elements.push_back(static_cast<int>(part.tree.elements.size()));
      part.tree.elements.push_back(e);
    }
    part.tree.branches.push_back(std::move(kept));
  }
  part.cut_node = node_of[index(cut_node)];
  part.node_of.assign(node_of.begin(),
                      node_of.begin() + static_cast<std::ptrdiff_t>(original_nodes));
  return part;
}

// Inserts a node at the cut without renumbering; returns the node.
int insert_node(RodTree& tree, int element, double s) {
  const RodElement before = tree.elements[index(element)];
  // A cut within round-off of a node is made at that node, because an element of zero length has no
  // strain.
  if (s <= 1e-9 * before.length) return before.first;
  if (s >= (1 - 1e-9) * before.length) return before.second;
  const int node = tree.node_count();
  const auto [b, at] = branch_of_element(tree, element);
  tree.rest.push_back(frame_at(tree, tree.rest, element, s));
  if (!tree.radius.empty()) {
    const double t = s / before.length;
    tree.radius.push_back((1 - t) * tree.radius[index(before.first)] +
                          t * tree.radius[index(before.second)]);
  }
  RodElement after = before;
  after.first = node;
  after.length = before.length - s;
  tree.elements[index(element)].second = node;
  tree.elements[index(element)].length = s;
  RodBranch& branch = tree.branches[b];
  branch.nodes.insert(branch.nodes.begin() + static_cast<std::ptrdiff_t>(at) + 1, node);
  branch.elements.insert(branch.elements.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                         static_cast<int>(tree.elements.size()));
  tree.elements.push_back(after);
  return node;
}

// Whether branch b is `ancestor` or descends from it.
bool descends(const RodTree& tree, size_t b, size_t ancestor) {
  for (int k = static_cast<int>(b); k >= 0; k = tree.branches[index(k)].parent)
    if (index(k) == ancestor) return true;
  return false;
}

}  // namespace

RodPart split_rod(const RodTree& tree, int element, double s) {
  RodTree split = tree;
  const int node = insert_node(split, element, s);
  return renumbered(split, node, tree.rest.size());
}

RodPart cut_rod(const RodTree& tree, int element, double s, RodSide side) {
  RodTree split = tree;
  const int node = insert_node(split, element, s);
  const size_t b = branch_of_element(split, element).first;
  RodBranch& cut = split.branches[b];
  const auto at = std::find(cut.nodes.begin(), cut.nodes.end(), node) - cut.nodes.begin();
  const bool root_side = side == RodSide::towards_root;
  const auto length = static_cast<std::ptrdiff_t>(cut.elements.size());
  if ((root_side && at == 0) || (!root_side && at == length))
    throw std::logic_error("cut_rod: nothing of the cut branch is left on the kept side");
  if (root_side) {
    cut.nodes.resize(static_cast<size_t>(at) + 1);
    cut.elements.resize(static_cast<size_t>(at));
  } else {
    cut.nodes.erase(cut.nodes.begin(), cut.nodes.begin() + at);
    cut.elements.erase(cut.elements.begin(), cut.elements.begin() + at);
  }
  std::vector<RodBranch> kept;
  std::vector<int> new_index(split.branches.size(), -1);
  for (size_t k = 0; k < split.branches.size(); ++k) {
    const bool behind = k != b && descends(split, k, b);
    if (k != b && (root_side ? behind : !behind)) continue;
    new_index[k] = static_cast<int>(kept.size());
    kept.push_back(split.branches[k]);
    int& parent = kept.back().parent;
    parent = (k == b && !root_side) || parent < 0 ? -1 : new_index[index(parent)];
  }
  split.branches = std::move(kept);
  return renumbered(split, node, tree.rest.size());
}

RodSide side_of(const RodTree& tree, int element, double s, int node) {
  const auto [b, at] = branch_of_element(tree, element);
  for (size_t k = 0; k < tree.branches.size(); ++k) {
    const auto& nodes = tree.branches[k].nodes;
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found == nodes.end()) continue;
    if (k == b) {
      const auto position = static_cast<size_t>(found - nodes.begin());
      const bool away = position > at || (position == at && s <= 0);
      return away ? RodSide::away_from_root : RodSide::towards_root;
    }
    // A branch that descends from the cut branch starts at its last node, which is on the far side.
    if (descends(tree, k, b)) return RodSide::away_from_root;
  }
  return RodSide::towards_root;
}

}  // namespace vasorod
