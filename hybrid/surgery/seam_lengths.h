// Where the knots of a seam lie on its two loops, so that both loops are divided in the same
// proportions.
#pragma once

#include <vector>

#include "geometry/loops.h"
#include "surgery/seam_knots.h"

namespace vasorod {

/// A loop of the seam, passed through in the mouth's direction.
struct SeamCurve {
  LoopCurve loop;
  double start = 0;       ///< fraction of the loop's length at the first tip
  bool reversed = false;  ///< the rim runs against the mouth

  /// Fraction of the loop's length at a fraction of the way around from the first tip.
  double fraction(double way) const { return start + (reversed ? -way : way); }
};

/// Per knot the fraction of the way around each curve, from the first tip.
struct SeamPlaces {
  std::vector<double> mouth, rim;
};

/// A loop's new polygon: knots with a vertex of the loop (`slides`) lie on its old polygon, the
/// others on the straight line between the two such knots beside them.
Points knot_points(const SeamCurve& curve, const std::vector<char>& slides,
                   const std::vector<double>& ways);

/// Places the knots so that the k-th segment's share in its loop's length is the same on both
/// loops, to rounding, where lengths are those of the new polygons. (A polygon whose vertices slide
/// along an older one is shorter, so equal fractions of the old lengths are not enough.) Both tips
/// stay at the slit's tips; the mouth's vertices stay where the knots say, except at the other tip.
SeamPlaces equal_shares(const SeamCurve& mouth, const SeamCurve& rim,
                        const std::vector<SeamKnot>& knots, int other_tip);

}  // namespace vasorod
