#include "geometry/box_tree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "data/index.h"

namespace vasorod {

namespace {

constexpr int most_in_leaf = 4;
constexpr int bits = 10;  // of each coordinate

// Every third bit from those of a number of 10 bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000ffU;
  x = (x | (x << 8)) & 0x0300f00fU;
  x = (x | (x << 4)) & 0x030c30c3U;
  return (x | (x << 2)) & 0x09249249U;
}

// Where no place is finite, as in a wall that a solver has lost, any order will do.
std::uint32_t whole(double cell, std::uint32_t cells) {
  return cell > 0 ? static_cast<std::uint32_t>(std::min(cell, cells - 1.0)) : 0;
}

struct Coded {
  std::uint32_t code;
  int item;
};

// The items sorted by where the curve passes their centres; of alike ones the first is first.
std::vector<int> in_curve_order(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.add(box);
  constexpr std::uint32_t cells = 1U << bits;
  const double size = boxes.empty() ? 0 : (all.high - all.low).maxCoeff();
  const double scale = size > 0 ? 0.5 * (cells - 1) / size : 0;
  std::vector<Coded> coded, sorted(boxes.size());
  coded.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 cell = scale * (boxes[i].low + boxes[i].high - 2 * all.low);
    coded.push_back({spread(whole(cell.x(), cells)) | (spread(whole(cell.y(), cells)) << 1) |
                         (spread(whole(cell.z(), cells)) << 2),
                     static_cast<int>(i)});
  }
  // By digits of 10 bits, the last one first.
  for (int shift = 0; shift < 3 * bits; shift += bits) {
    const auto digit = [&](const Coded& one) { return (one.code >> shift) & (cells - 1); };
    std::array<std::size_t, cells + 1> next{};
    for (const Coded& one : coded) ++next[digit(one) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Coded& one : coded) sorted[next[digit(one)]++] = one;
    coded.swap(sorted);
  }
  std::vector<int> items;
  items.reserve(coded.size());
  for (const Coded& one : coded) items.push_back(one.item);
  return items;
}

}  // namespace

std::vector<Box> triangle_boxes(const TriangleSurface& surface) {
  std::vector<Box> boxes(index(surface.triangles.rows()));
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 corner = surface.points.row(surface.triangles(t, k));
      boxes[index(t)].add({corner, corner});
    }
  return boxes;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) : items_(in_curve_order(boxes)) {
  if (boxes.empty()) return;
  boxes_.reserve(boxes.size());
  for (const int item : items_) boxes_.push_back(boxes[index(item)]);
  nodes_.reserve(boxes.size());
  build(0, static_cast<int>(items_.size()));
  fit_boxes();
}

int BoxTree::build(int first, int last) {
  const int here = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, first, last, -1});
  if (last - first > most_in_leaf) {
    const int middle = first + (last - first) / 2;
    build(first, middle);
    const int right = build(middle, last);
    nodes_[index(here)].right = right;
  }
  return here;
}

void BoxTree::refit(const std::vector<Box>& boxes) {
  for (std::size_t k = 0; k < items_.size(); ++k) boxes_[k] = boxes[index(items_[k])];
  fit_boxes();
}

void BoxTree::fit_boxes() {
  for (std::size_t n = nodes_.size(); n-- > 0;) {  // children follow their parent
    Node& node = nodes_[n];
    node.box = {};
    if (node.right >= 0) {
      node.box.add(nodes_[n + 1].box);
      node.box.add(nodes_[index(node.right)].box);
    } else {
      for (int k = node.first; k < node.last; ++k) node.box.add(boxes_[index(k)]);
    }
  }
}

std::vector<char> BoxTree::marked_nodes(const std::vector<char>& marked) const {
  std::vector<char> marks(nodes_.size(), 0);
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    if (node.right >= 0) {
      marks[n] = marks[n + 1] || marks[index(node.right)] ? 1 : 0;
      continue;
    }
    for (int k = node.first; k < node.last; ++k)
      if (marked[index(items_[index(k)])]) marks[n] = 1;
  }
  return marks;
}

// A search is shared where its parts take longer than to wake a thread.
std::vector<BoxTree::NodePair> BoxTree::parts_of_search(const std::vector<char>& marks) const {
  if (nodes_.empty() || !marks[0]) return {};
  const int most = std::max(1024, static_cast<int>(items_.size() / 16));  // items of a part
  const auto items = [&](int n) { return nodes_[index(n)].last - nodes_[index(n)].first; };
  std::vector<NodePair> open{{0, 0}}, parts;
  while (!open.empty()) {
    const NodePair nodes = open.back();
    open.pop_back();
    if (items(nodes.first) + items(nodes.second) <= most ||
        !divide(nodes, marks, [&](NodePair below) { open.push_back(below); }))
      parts.push_back(nodes);
  }
  return parts;
}

}  // namespace vasorod
