// Reads the geometry of a result folder that a comparison needs.
#pragma once

#include <filesystem>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// NAME.vtp: the points at rest and in the result, and the triangles (polygons are cut into fans).
struct ReadVessel {
  Points rest, current;
  Triangles triangles;
};

/// NAME_centerline.vtp: the nodes and the polylines through them.
struct ReadCenterline {
  Points rest, current;
  std::vector<double> radius;  ///< empty: the file has none
  std::vector<std::vector<int>> lines;
};

/// Both throw InputError (one sentence) if the file is missing, damaged or without RestPosition.
ReadVessel read_vessel_vtp(const std::filesystem::path& file);
ReadCenterline read_centerline_vtp(const std::filesystem::path& file);

}  // namespace vasorod
