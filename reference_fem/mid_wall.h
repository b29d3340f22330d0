// The deformed mid-wall of a tube on a grid of points, dimensionless.
#pragma once

#include <vector>

#include "reference_fem/mesh.h"
#include "reference_fem/model.h"

namespace vasorod::fem {

/// Rows of points around the tube, at stations along its axis.
struct MidWall {
  int around = 0, along = 0;     ///< points around, stations along
  std::vector<double> fraction;  ///< of the axis, per station
  Points rest, current;          ///< row: station * around + point
  /// A slit along the first line: per station whether it is open there; empty: none. The first
  /// point of an open station lies on one lip, the next row of `other_lip` on the other.
  std::vector<char> open;
  Points other_lip_rest, other_lip_current;

  bool open_at(int station) const {
    return !open.empty() && open[static_cast<std::size_t>(station)] != 0;
  }
};

/// Rest and current positions at points of a mesh. `u`: the degrees of freedom of the mesh's nodes,
/// `components` each.
struct WallPoints {
  Points rest, current;
};
WallPoints wall_points(const Mesh& mesh, const DofValues& u, int components,
                       const std::vector<Vec3>& parameters);

}  // namespace vasorod::fem
