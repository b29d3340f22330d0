// Converts a deal.II triangulation whose corners are parameters of a chart to a Mesh. Only for the
// .cpp files that make meshes: deal.II's headers compile slowly.
#pragma once

#include <deal.II/grid/tria.h>

#include "reference_fem/mesh.h"

namespace vasorod::fem {

/// `corners` as in Mesh, by active cell index. All cells of `tria` have the same level.
template <int dim>
Mesh make_mesh(dealii::Triangulation<dim, 3>& tria, std::vector<Eigen::Matrix3Xd> corners,
               const Chart& chart, bool closed, int degree, const Processes& processes);

/// Multilinear interpolation of a cell's corners at a point of the unit cell.
inline Vec3 inside(const Eigen::Matrix3Xd& corners, const Vec3& unit) {
  Vec3 p = Vec3::Zero();
  for (Eigen::Index v = 0; v < corners.cols(); ++v) {
    double share = v & 1 ? unit[0] : 1 - unit[0];
    share *= v & 2 ? unit[1] : 1 - unit[1];
    if (corners.cols() == 8) share *= v & 4 ? unit[2] : 1 - unit[2];
    p += share * corners.col(v);
  }
  return p;
}

}  // namespace vasorod::fem
