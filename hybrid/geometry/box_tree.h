// A binary tree of axis-parallel boxes, one box for each item, for searches that first ask boxes.
// CGAL's box_intersection_d and AABB tree answer the same questions; for walls that are new with
// every option, each asked a few times, sorting and building those takes longer than the answers.
// Nor does that AABB tree follow a wall that moves: it is built anew.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <vasorod/types.h>

#include "data/in_parallel.h"

namespace vasorod {

/// An axis-parallel box with its faces, length.
struct Box {
  Vec3 low = Vec3::Constant(1e300);    ///< smallest coordinates
  Vec3 high = Vec3::Constant(-1e300);  ///< largest coordinates

  /// Widens the box by what `other` covers.
  void add(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  /// Whether the two have a point in common.
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  /// From `point` to the nearest point of the box, squared; 0 inside.
  double squared_distance(const Vec3& point) const {
    return (point - point.cwiseMax(low).cwiseMin(high)).squaredNorm();
  }
};

/// The boxes of a surface's triangles.
std::vector<Box> triangle_boxes(const TriangleSurface& surface);

/// The items in the order of their centres on a Z-order curve (Morton 1966), halved down to a few.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Gives the items other boxes, as many as before; their order stays. Searches are as right as
  /// before, and slower where items have moved far against each other.
  void refit(const std::vector<Box>& boxes);

  /// The item nearest to `point`, of equally near ones the first; -1 where there is none nearer
  /// than infinity. squared_distance(item) is asked for items whose box is no farther than the
  /// nearest item so far. `first`: an item to ask first, as a near one saves others, or -1; the
  /// answer does not depend on it.
  template <class SquaredDistance>
  int nearest(const Vec3& point, SquaredDistance&& squared_distance, int first = -1) const;

  /// Calls take(item) for every item for whose box, and for all boxes around it, touches(box) is
  /// true. The order is that of the tree.
  template <class Touches, class Take>
  void visit(Touches&& touches, Take&& take) const {
    if (nodes_.empty()) return;
    std::array<int, 80> open{0};  // halved each time, 2^31 items are 31 levels deep
    for (std::size_t count = 1; count > 0;) {
      const int n = open[--count];
      const Node& node = nodes_[static_cast<std::size_t>(n)];
      if (!touches(node.box)) continue;
      if (node.right >= 0) {
        open[count++] = node.right;
        open[count++] = n + 1;
        continue;
      }
      for (int k = node.first; k < node.last; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (touches(boxes_[at])) take(items_[at]);
      }
    }
  }

  /// Calls take(i, j) once for every two items whose boxes meet and of which at least one is
  /// marked; `marked`: one entry for each item. `take` returns false to end the search.
  template <class Take>
  void meeting_pairs(const std::vector<char>& marked, Take&& take) const {
    meeting_pairs(marked, marked_nodes(marked), {0, 0}, take);
  }

  /// The same search on up to `threads` threads: take(part, i, j), where the pairs of a part are
  /// asked one after the other on one thread, and false ends this part alone. begin(parts) is
  /// called first. The pairs of one part after those of another are in meeting_pairs()' order; the
  /// parts are the same for any number of threads.
  template <class Begin, class Take>
  void meeting_pairs(const std::vector<char>& marked, int threads, Begin&& begin,
                     Take&& take) const {
    const std::vector<char> marks = marked_nodes(marked);
    const std::vector<NodePair> parts = parts_of_search(marks);
    begin(parts.size());
    in_parallel(threads, static_cast<int>(parts.size()), [&](int p) {
      const auto part = static_cast<std::size_t>(p);
      meeting_pairs(marked, marks, parts[part], [&](int i, int j) { return take(part, i, j); });
    });
  }

 private:
  // Items first to last - 1; the left child follows its parent. right -1: a leaf.
  struct Node {
    Box box;
    int first = 0, last = 0, right = -1;
  };

  // Two nodes whose items are asked against each other; the same twice: among themselves.
  using NodePair = std::pair<int, int>;

  int build(int first, int last);
  void fit_boxes();
  std::vector<char> marked_nodes(const std::vector<char>& marked) const;
  std::vector<NodePair> parts_of_search(const std::vector<char>& marks) const;
  template <class Later>
  bool divide(NodePair nodes, const std::vector<char>& marks, Later&& later) const;
  template <class Take>
  void meeting_pairs(const std::vector<char>& marked, const std::vector<char>& marks, NodePair part,
                     Take&& take) const;

  std::vector<Box> boxes_;  // in the order of items_
  std::vector<int> items_;
  std::vector<Node> nodes_;
};

template <class SquaredDistance>
int BoxTree::nearest(const Vec3& point, SquaredDistance&& squared_distance, int first) const {
  struct Open {
    int node;
    double squared;  // from the point to the node's box
  };
  if (nodes_.empty()) return -1;
  // Of two items at the same distance but for rounding the search would else miss one or not,
  // depending on where it begins.
  const Box& all = nodes_[0].box;
  const double rounding =
      1e-14 * std::max({point.cwiseAbs().maxCoeff(), all.low.cwiseAbs().maxCoeff(),
                        all.high.cwiseAbs().maxCoeff()});
  double least = std::numeric_limits<double>::infinity(), limit = least;
  int found = -1;
  const auto ask = [&](int item) {
    const double squared = squared_distance(item);
    if (!(squared < least) && !(squared == least && item < found)) return;
    least = squared;
    found = item;
    const double far = std::sqrt(squared) + rounding;
    limit = far * far;
  };
  if (first >= 0) ask(first);
  std::array<Open, 80> open{};  // as in visit()
  open[0] = {0, nodes_[0].box.squared_distance(point)};
  for (std::size_t count = 1; count > 0;) {
    const Open now = open[--count];
    if (now.squared > limit) continue;
    const Node& node = nodes_[static_cast<std::size_t>(now.node)];
    if (node.right < 0) {
      for (int k = node.first; k < node.last; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (items_[at] != first && boxes_[at].squared_distance(point) <= limit) ask(items_[at]);
      }
      continue;
    }
    const auto child = [&](int n) {
      return Open{n, nodes_[static_cast<std::size_t>(n)].box.squared_distance(point)};
    };
    Open near = child(now.node + 1), far = child(node.right);
    if (far.squared < near.squared) std::swap(near, far);
    if (far.squared <= limit) open[count++] = far;
    if (near.squared <= limit) open[count++] = near;
  }
  return found;
}

// Calls later(pair) with the pairs of nodes of which `nodes` consists and that may have items to
// ask; false: there are no nodes below them.
template <class Later>
bool BoxTree::divide(NodePair nodes, const std::vector<char>& marks, Later&& later) const {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto [a, b] = nodes;
  const Node &one = nodes_[at(a)], &two = nodes_[at(b)];
  const auto meet = [&](int c, int d) {
    if ((marks[at(c)] || marks[at(d)]) && (c == d || nodes_[at(c)].box.meets(nodes_[at(d)].box)))
      later(NodePair(c, d));
  };
  if (one.right >= 0 && (two.right < 0 || one.last - one.first >= two.last - two.first)) {
    if (a == b) {
      meet(a + 1, a + 1);
      meet(one.right, one.right);
      meet(a + 1, one.right);
    } else {
      meet(a + 1, b);
      meet(one.right, b);
    }
    return true;
  }
  if (two.right < 0) return false;
  meet(a, b + 1);
  meet(a, two.right);
  return true;
}

template <class Take>
void BoxTree::meeting_pairs(const std::vector<char>& marked, const std::vector<char>& marks,
                            NodePair part, Take&& take) const {
  if (nodes_.empty() || !marks[0]) return;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<NodePair> open{part};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (divide({a, b}, marks, [&](NodePair nodes) { open.push_back(nodes); })) continue;
    const Node &one = nodes_[at(a)], &two = nodes_[at(b)];
    for (int k = one.first; k < one.last; ++k) {
      if (a != b && !boxes_[at(k)].meets(two.box)) continue;
      for (int l = a == b ? k + 1 : two.first; l < two.last; ++l) {
        if (!boxes_[at(k)].meets(boxes_[at(l)])) continue;
        const int i = items_[at(k)], j = items_[at(l)];
        if ((marked[at(i)] || marked[at(j)]) && !take(i, j)) return;
      }
    }
  }
}

}  // namespace vasorod
