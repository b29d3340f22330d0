// Reads the geometry of a result folder, for comparisons and pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// NAME.vtp: the points at rest and in the result, and the triangles (polygons are cut into fans).
struct ReadVessel {
  Points rest, current;
  Triangles triangles;
  /// Per vertex; empty: the file has none.
  Eigen::VectorXd axial_stretch, twist_shear, contact_pressure;
  std::string space;  ///< SPACE: LPS or RAS; empty: the file does not say
};

/// NAME_centerline.vtp: the nodes and the polylines through them.
struct ReadCenterline {
  Points rest, current;
  std::vector<double> radius,   ///< empty: the file has none
      abscissa;                 ///< arc length; empty: the file has none
  std::vector<Mat3> directors;  ///< columns d1 d2 d3; empty: the file has none
  /// Strains and sections as in CenterlineResult; empty: the file has none.
  std::vector<Vec3> u, v, u0, v0;
  std::vector<double> lumen_area, flattening;
  std::vector<std::vector<int>> lines;
};

/// Both throw InputError (one sentence) if the file is missing, damaged or without RestPosition.
ReadVessel read_vessel_vtp(const std::filesystem::path& file);
ReadCenterline read_centerline_vtp(const std::filesystem::path& file);

/// NAME_stump.vtp: points and triangles alone. Throws InputError as the others do.
TriangleSurface read_stump_vtp(const std::filesystem::path& file);

}  // namespace vasorod
