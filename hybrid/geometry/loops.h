// Closed polygons by arc length: parametrisation, interpolation, and the best match of two
// polygons.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A closed polygon with its arc length.
class LoopCurve {
 public:
  explicit LoopCurve(Points corners);  ///< n x 3, in order, n >= 3; closed from last to first

  double length() const { return position_.back(); }
  int count() const { return static_cast<int>(corners_.rows()); }
  /// Arc length from corner 0 to corner k, length unit; k = count() gives the total length.
  double position(int k) const { return position_[static_cast<size_t>(k)]; }
  /// A point of the polygon: (1 - along) corner[edge] + along corner[edge + 1], cyclic.
  struct Place {
    int edge = 0;
    double along = 0;  ///< in [0, 1)
  };
  /// The place at a fraction of the length (any real number, taken modulo 1). Within 1e-12 of the
  /// length of a corner it is that corner.
  Place place(double fraction) const;
  Vec3 at(const Place& place) const;
  /// The point at a fraction of the length.
  Vec3 at(double fraction) const;

 private:
  Points corners_;
  std::vector<double> position_;
};

/// The offset for which two loops of opposite orientation are closest: it minimises the mean over u
/// of |a(u) - b(offset - u)|^2, where u and offset are fractions of arc length. In [0, 1), exact to
/// about 1e-8, the rounding limit of a minimum.
double opposite_offset(const LoopCurve& a, const LoopCurve& b);

/// The mean of |a(u) - b(offset - u)|^2 over u, length^2, exact.
double opposite_distance(const LoopCurve& a, const LoopCurve& b, double offset);

}  // namespace vasorod
