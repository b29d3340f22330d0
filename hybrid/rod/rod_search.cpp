#include "rod/rod_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

double axial(const Pose& frame, const Vec3& p) {
  return frame.rotation.col(2).dot(p - frame.position);
}

double fibre_stretch(const RodElement& e, const Vec3& local) {
  return e.rest_strain[2] + e.rest_strain[3] * local.y() - e.rest_strain[4] * local.x();
}

// Finds the section of the element that passes through p, given that the axial coordinate changes
// from positive to negative within it. Newton with d(axial)/ds = -fibre stretch, inside a shrinking
// bracket.
RodCoordinates solve_in_element(const RodTree& tree, int index, const Vec3& p, double first_axial,
                                double second_axial) {
  const RodElement& e = tree.elements[static_cast<size_t>(index)];
  const Vec3 q = tree.rest[static_cast<size_t>(e.first)].inverse() * p;
  double low = 0, high = e.length;
  double s = e.length * first_axial / (first_axial - second_axial);
  Vec3 local = q;
  for (int k = 0; k < 30; ++k) {
    local = exp_motion(-s * e.rest_strain) * q;
    (local.z() > 0 ? low : high) = s;
    const double stretch = fibre_stretch(e, local);
    double next = stretch > 0 ? s + local.z() / stretch : 0.5 * (low + high);
    if (next < low || next > high) next = 0.5 * (low + high);
    const double step = std::abs(next - s);
    s = next;
    if (step <= 1e-15 * e.length) break;
  }
  local = exp_motion(-s * e.rest_strain) * q;
  local.z() = 0;
  return {index, s, local};
}

}  // namespace

RodSearch::RodSearch(const RodTree& tree) : tree_(tree), at_fork_(leaves_fork(tree)) {}

RodHit RodSearch::find(const Vec3& point, std::span<const int> branches, bool relative) const {
  RodHit best;
  double best_score = std::numeric_limits<double>::infinity();
  auto scale = [&](int element) {
    if (!relative) return 1.0;
    const RodElement& e = tree_.elements[static_cast<size_t>(element)];
    return 2 / (tree_.radius[static_cast<size_t>(e.first)] +
                tree_.radius[static_cast<size_t>(e.second)]);
  };
  auto offer = [&](int branch, const RodCoordinates& at) {
    // A section through the point is preferred to a neighbouring node, even if a wider branch ends
    // at that node.
    const double distance = at.local.norm();
    const double score = distance * scale(at.element) * (at.local.z() == 0 ? 1 : 1.25);
    if (score >= best_score) return;
    best_score = score;
    best = {at, branch, distance,
            fibre_stretch(tree_.elements[static_cast<size_t>(at.element)], at.local)};
  };
  for (const int b : branches) {
    const RodBranch& branch = tree_.branches[static_cast<size_t>(b)];
    const Pose& front = tree_.rest[static_cast<size_t>(branch.nodes.front())];
    const Pose& back = tree_.rest[static_cast<size_t>(branch.nodes.back())];
    double previous = axial(front, point);
    if (previous <= 0) offer(b, {branch.elements.front(), 0, front.inverse() * point});
    for (size_t k = 0; k < branch.elements.size(); ++k) {
      const int index = branch.elements[k];
      const double next = axial(tree_.rest[static_cast<size_t>(branch.nodes[k + 1])], point);
      if (previous > 0 && next <= 0)
        offer(b, solve_in_element(tree_, index, point, previous, next));
      previous = next;
    }
    if (previous > 0) {
      const int last = branch.elements.back();
      offer(b, {last, tree_.elements[static_cast<size_t>(last)].length, back.inverse() * point});
    }
  }
  return best;
}

}  // namespace vasorod
