// A tube's wall unrolled to a strip of quadrilaterals (the mid-wall) or hexahedra: the whole tube,
// the part between two planes of symmetry, or a tube with a slit along its first line.
#pragma once

#include <vector>

#include "reference_fem/mesh.h"

namespace vasorod::fem {

/// The strip's lines. Parameters of its mesh: share of the circumference from the first line of a
/// whole tube, fraction of the tube's axis, depth from inside 0 to outside 1.
struct Strip {
  std::vector<double> around, along;  ///< increasing
  /// Per station along: the first and the last line are the same there. Between two stations that
  /// are not both welded the strip is open.
  std::vector<char> welded;
  int layers = 0;  ///< of hexahedra; 0: the mid-wall as a surface
  int degree = 3;
};

/// The chart maps the parameters to the rest configuration; of a strip with welded stations it has
/// period 1 in the share.
Mesh make_strip(const Strip& strip, const Chart& chart, const Processes& processes = {});

}  // namespace vasorod::fem
