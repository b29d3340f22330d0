// The way along a vessel's axis from one of its ends to another.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "vessel/vessel.h"

namespace vasorod {

/// A place on a rod tree.
struct AxisPlace {
  int element = 0;  ///< index into RodTree::elements
  double s = 0;     ///< arc length within the element, length unit
};

/// The two ends of a way along a vessel's axis, indices into Vessel::ends: from, to.
using RouteEnds = std::array<int, 2>;

/// The one way through a rod tree between two of its nodes.
class AxisRoute {
 public:
  /// `rod` must outlive this.
  AxisRoute(const RodTree& rod, int from_node, int to_node);
  /// Between two ends of a vessel, which must outlive this.
  AxisRoute(const Vessel& vessel, const RouteEnds& ends);

  double length() const { return length_; }  ///< arc length, length unit

  /// The place at that arc length from the first node, which is clamped to the route.
  AxisPlace at(double distance) const;

  /// Arc length from the first node to the place; empty if the place is not on the route.
  std::optional<double> distance_to(const AxisPlace& place) const;

 private:
  struct Piece {
    int element = 0;
    bool backwards = false;  // towards the tree's root
    double start = 0;        // arc length from the first node
  };
  const RodTree* rod_;
  std::vector<Piece> pieces_;
  double length_ = 0;
};

/// The end (index into Vessel::ends) that is farthest along the axis from `end`.
int farthest_end(const Vessel& vessel, int end);

/// All other ends, the farthest first, then in their order.
std::vector<int> other_ends(const Vessel& vessel, int end);

}  // namespace vasorod
