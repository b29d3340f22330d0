#include "reference_fem/strip_mesh.h"

#include <algorithm>
#include <deal.II/grid/tria.h>
#include <stdexcept>

#include "reference_fem/make_mesh.h"

namespace vasorod::fem {
namespace {

using std::size_t;

template <int dim>
Mesh make(const Strip& strip, const Chart& chart, const Processes& processes) {
  const size_t columns = strip.around.size(), rows = strip.along.size(),
               layers = static_cast<size_t>(strip.layers);
  const auto parameter = [&](size_t i, size_t j, size_t k) {
    return Vec3(strip.around[i], strip.along[j],
                dim == 2 ? 0.5 : static_cast<double>(k) / strip.layers);
  };
  std::vector<dealii::Point<3>> vertices;
  std::vector<unsigned> number((layers + 1) * rows * columns);
  const auto at = [&](size_t i, size_t j, size_t k) -> unsigned& {
    return number[(k * rows + j) * columns + i];
  };
  for (size_t k = 0; k <= layers; ++k)
    for (size_t j = 0; j < rows; ++j)
      for (size_t i = 0; i < columns; ++i) {
        if (i + 1 == columns && strip.welded[j] != 0) {
          at(i, j, k) = at(0, j, k);
          continue;
        }
        const Vec3 x = chart(parameter(i, j, k));
        at(i, j, k) = static_cast<unsigned>(vertices.size());
        vertices.emplace_back(x[0], x[1], x[2]);
      }
  std::vector<dealii::CellData<dim>> cells;
  std::vector<Eigen::Matrix3Xd> corners;
  constexpr unsigned count = dealii::GeometryInfo<dim>::vertices_per_cell;
  for (size_t k = 0; k < std::max<size_t>(layers, 1); ++k)
    for (size_t j = 0; j + 1 < rows; ++j)
      for (size_t i = 0; i + 1 < columns; ++i) {
        dealii::CellData<dim> cell;
        Eigen::Matrix3Xd own(3, count);
        for (unsigned v = 0; v < count; ++v) {
          const size_t a = i + (v & 1u), b = j + (v >> 1 & 1u), c = k + (v >> 2 & 1u);
          cell.vertices[v] = at(a, b, c);
          own.col(v) = parameter(a, b, c);
        }
        cells.push_back(cell);
        corners.push_back(std::move(own));
      }
  dealii::Triangulation<dim, 3> tria;
  tria.create_triangulation(vertices, cells, dealii::SubCellData());
  return make_mesh<dim>(tria, std::move(corners), chart, false, strip.degree, processes);
}

}  // namespace

Mesh make_strip(const Strip& strip, const Chart& chart, const Processes& processes) {
  if (strip.around.size() < 2 || strip.along.size() < 2 ||
      strip.welded.size() != strip.along.size() || strip.layers < 0)
    throw std::logic_error("make_strip: a strip has a cell and a mark per station");
  return strip.layers > 0 ? make<3>(strip, chart, processes) : make<2>(strip, chart, processes);
}

}  // namespace vasorod::fem
