// Lays the lines of a strip around an elliptic hole. The strip stays a grid: the part of its first
// line between the hole's tips becomes the rim, at an even pace of arc length; far away nothing
// moves.
#pragma once

#include <vasorod/types.h>

namespace vasorod::fem {

/// An ellipse in a tube's wall, drawn on the wall as unrolled about the hole's middle, which lies
/// on the strip's first line. Lengths in one unit.
struct HoleChart {
  double half_length = 1;   ///< half the axis along the tube
  double half_width = 0.5;  ///< half the axis across it
  double middle = 0.5;      ///< fraction of the tube's axis
  double line = 10;         ///< length of the first line from the tube's start to its end
  double half_around = 3;   ///< half the circumference

  double perimeter() const;  ///< of the hole
  /// The point of the rim's quarter at a share of its arc length from the tip, from the middle.
  Vec2 rim(double share) const;
  /// Where the point of the strip (share of the circumference, fraction of the axis) is laid, in
  /// the same parameters. The hole's tips keep their places on the first line.
  Vec2 place(double share, double fraction) const;
};

}  // namespace vasorod::fem
