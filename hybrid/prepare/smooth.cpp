#include "prepare/smooth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include "geometry/triangle_surface.h"
#include "surface_file/check_surface.h"

namespace vasorod {

bool has_stairs(const TriangleSurface& surface) {
  constexpr int fewest = 1000;  // a coarse tube has facets in few directions too
  if (surface.triangles.rows() < fewest) return false;
  double aligned = 0, all = 0;
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 a = surface.points.row(surface.triangles(t, 0)),
               b = surface.points.row(surface.triangles(t, 1)),
               c = surface.points.row(surface.triangles(t, 2));
    const Vec3 normal = (b - a).cross(c - a);
    const double area = normal.norm();
    if (area == 0) continue;
    // The nearest of the 26 directions: components of at least half the largest count.
    const Vec3 size = normal.cwiseAbs();
    const Vec3 nearest =
        size.unaryExpr([&](double x) { return x > 0.5 * size.maxCoeff() ? 1.0 : 0.0; });
    all += area;
    if (size.dot(nearest.normalized()) > std::cos(3 * M_PI / 180) * area) aligned += area;
  }
  return aligned > 0.9 * all;
}

void smooth(TriangleSurface& surface) {
  const double volume = lidded_volume(surface);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
    points->InsertNextPoint(surface.points(i, 0), surface.points(i, 1), surface.points(i, 2));
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    cells->InsertNextCell(3);
    for (int k = 0; k < 3; ++k) cells->InsertCellPoint(surface.triangles(t, k));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(data);
  filter->SetNumberOfIterations(40);
  filter->SetPassBand(0.02);
  filter->NormalizeCoordinatesOn();
  filter->FeatureEdgeSmoothingOff();
  filter->BoundarySmoothingOff();
  filter->NonManifoldSmoothingOff();
  filter->Update();
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    Vec3 p;
    filter->GetOutput()->GetPoint(i, p.data());
    surface.points.row(i) = p;
  }
  std::vector<char> boundary(static_cast<std::size_t>(surface.points.rows()), 0);
  for (const auto& loop : boundary_loops(surface.triangles))
    for (const int v : loop) boundary[static_cast<std::size_t>(v)] = 1;
  for (int round = 0; round < 3; ++round) {
    const double step = (volume - lidded_volume(surface)) / total_area(surface);
    const Points normals = vertex_normals(surface);
    for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
      if (!boundary[static_cast<std::size_t>(i)]) surface.points.row(i) += step * normals.row(i);
  }
}

}  // namespace vasorod
