// Cells that are smallest at a point and grow away from it: near the tip of a slit the fold's
// radius is that of the wall's thickness, a diameter further on the wall is hardly bent.
#pragma once

#include <vector>

namespace vasorod::fem {

/// At the distance x from the point, a unit of length holds 1 / (smallest + growth x) + 1 / largest
/// cells, times a factor that sets their number.
struct Grading {
  double smallest = 0.03, growth = 0.4, largest = 0.8;

  /// Number of cells from the point to a distance, before that factor.
  double cells(double distance) const;
  /// Distances 0 to `length` of the ends of `count` cells. Three for two cells halve the cells'
  /// sizes everywhere by the same ratio.
  std::vector<double> stations(double length, int count) const;
};

}  // namespace vasorod::fem
