// The knots of a seam: which vertex of the mouth is sewn to which vertex of the rim, and where.
#pragma once

#include <map>
#include <utility>
#include <vector>

namespace vasorod {

/// The vertices of both loops in the mouth's order, as fractions of arc length from the slit's
/// first tip: ascending, in [0, 1). rim[0] = 0 is the first tip.
struct SeamCorners {
  std::vector<double> mouth, rim;
  int other_tip = 0;  ///< index into `rim` of the slit's other tip; none has it: no other tip
};

/// A vertex of both loops. Index -1: that loop has no vertex there, its edge is split.
struct SeamKnot {
  int mouth = -1, rim = -1;  ///< indices into `SeamCorners`
  double position = 0;       ///< fraction of arc length from the first tip
};

/// What the meshes beside the seam did not allow: the next choice leaves it out.
struct SeamRefusals {
  /// A pair meets at mouth + share * (rim - mouth); without an entry at the mouth's vertex, share
  /// 0. Above 1: not paired. Pairs with a tip meet at the tip.
  std::map<std::pair<int, int>, double> share;
  /// Vertices without a partner that must stay where they are.
  std::vector<char> mouth_stays, rim_stays;
};

/// Chooses the knots, the first one at the first tip. Every vertex of both loops belongs to one
/// knot, in order, so a loop's vertices slide along it and others are inserted. The choice has the
/// least sum of squared slides, where a vertex without a partner costs as much as a slide by 0.42
/// of the local edge, and short gaps between knots cost more. Knots closer than 0.45 of the
/// local edge are moved apart, tips excepted.
std::vector<SeamKnot> choose_knots(const SeamCorners& corners, const SeamRefusals& refusals = {});

}  // namespace vasorod
