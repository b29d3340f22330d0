// Finds the section of a rod's rest shape that passes through a point [6].
#pragma once

#include <span>

#include "rod/binding.h"

namespace vasorod {

/// The closest section of a rod tree through a point.
struct RodHit {
  RodCoordinates at;
  int branch = 0;
  double distance = 0;  ///< length of (x, y, z), length unit
  /// Length of the fibre through the point over the axis length, v3 + u1 y - u2 x. If it is <= 0,
  /// the section plane passes through or beyond the centre of curvature.
  double stretch = 0;
};

/// Search for sections of one rod tree at rest. `tree` must outlive this.
class RodSearch {
 public:
  explicit RodSearch(const RodTree& tree);

  /// The closest of the sections through `point` on these branches. If no section passes through
  /// the point, the closest node with z different from zero. `relative`: distances are divided by
  /// the local radius (needs RodTree::radius).
  RodHit find(const Vec3& point, std::span<const int> branches, bool relative = false) const;

  /// Whether the element starts a branch at a fork, where the direction of the axis may change
  /// within one element.
  bool at_fork(int element) const { return at_fork_[static_cast<size_t>(element)] != 0; }

 private:
  const RodTree& tree_;
  std::vector<char> at_fork_;
};

}  // namespace vasorod
