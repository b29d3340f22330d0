// Closed polygons by arc length: parametrisation, points between the corners, and the best match of
// two of them.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A closed polygon with its arc length.
class LoopCurve {
 public:
  explicit LoopCurve(Points corners);  ///< n x 3, in order, n >= 3; the last is joined to the first

  double length() const { return position_.back(); }
  int count() const { return static_cast<int>(corners_.rows()); }
  /// Arc length from corner 0 to corner k, length unit; k = count() is the whole length.
  double position(int k) const { return position_[static_cast<size_t>(k)]; }
  /// The point at a fraction of the length (any real number, taken modulo 1).
  Vec3 at(double fraction) const;

 private:
  Points corners_;
  std::vector<double> position_;
};

/// The offset for which the loops, run through in opposite senses, lie closest: it minimises the
/// mean over u of |a(u) - b(offset - u)|^2, u and offset being fractions of arc length. In [0, 1),
/// exact to about 1e-8 (what rounding leaves of a minimum).
double opposite_offset(const LoopCurve& a, const LoopCurve& b);

/// That mean, length^2, by the trapezoidal rule.
double opposite_distance(const LoopCurve& a, const LoopCurve& b, double offset);

}  // namespace vasorod
