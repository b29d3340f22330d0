#include "reference_fem/mesh.h"

#include <algorithm>
#include <cmath>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>

#include <vasorod/error.h>

#include "reference_fem/make_mesh.h"

namespace vasorod::fem {
namespace {

using std::size_t;

template <int dim>
Vec3 unit_point(const dealii::Point<dim>& p) {
  Vec3 v = Vec3::Zero();
  for (int d = 0; d < dim; ++d) v[d] = p[static_cast<unsigned>(d)];
  return v;
}

/// Cells of a block, and the parameters of their corners.
template <int dim>
std::vector<Eigen::Matrix3Xd> triangulate(const Block& block, const Chart& chart,
                                          dealii::Triangulation<dim, 3>& tria) {
  const int n0 = block.cells[0], n1 = block.cells[1], n2 = dim == 3 ? block.cells[2] : 0;
  const int row = block.closed ? n0 : n0 + 1;
  const auto vertex = [&](int i, int j, int k) {
    return static_cast<unsigned>((block.closed ? i % n0 : i) + row * (j + (n1 + 1) * k));
  };
  const auto parameter = [&](int i, int j, int k) {
    return Vec3(static_cast<double>(i) / n0, static_cast<double>(j) / n1,
                dim == 3 ? static_cast<double>(k) / n2 : 0);
  };
  std::vector<dealii::Point<3>> vertices;
  for (int k = 0; k <= n2; ++k)
    for (int j = 0; j <= n1; ++j)
      for (int i = 0; i < row; ++i) {
        const Vec3 x = chart(parameter(i, j, k));
        vertices.emplace_back(x[0], x[1], x[2]);
      }
  std::vector<dealii::CellData<dim>> cells;
  std::vector<Eigen::Matrix3Xd> corners;
  constexpr unsigned count = dealii::GeometryInfo<dim>::vertices_per_cell;
  for (int k = 0; k < std::max(n2, 1); ++k)
    for (int j = 0; j < n1; ++j)
      for (int i = 0; i < n0; ++i) {
        dealii::CellData<dim> data;
        Eigen::Matrix3Xd own(3, count);
        for (unsigned v = 0; v < count; ++v) {
          const int a = i + static_cast<int>(v & 1u), b = j + static_cast<int>(v >> 1 & 1u),
                    c = k + static_cast<int>(v >> 2 & 1u);
          data.vertices[v] = vertex(a, b, c);
          own.col(v) = parameter(a, b, c);
        }
        cells.push_back(data);
        corners.push_back(std::move(own));
      }
  tria.create_triangulation(vertices, cells, dealii::SubCellData());
  return corners;
}

/// Divides the cells into equal slices along the second parameter, which have the shortest
/// interfaces on a tube.
template <int dim>
void share_out(dealii::Triangulation<dim, 3>& tria, const std::vector<Eigen::Matrix3Xd>& corners,
               int parts) {
  std::vector<std::pair<double, size_t>> order;
  for (size_t c = 0; c < corners.size(); ++c) order.emplace_back(corners[c].row(1).mean(), c);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first - 1e-9; });
  std::vector<unsigned> part(corners.size());
  for (size_t k = 0; k < order.size(); ++k)
    part[order[k].second] = static_cast<unsigned>(k * static_cast<size_t>(parts) / order.size());
  for (const auto& cell : tria.active_cell_iterators())
    cell->set_subdomain_id(part[cell->active_cell_index()]);
}

template <int dim>
Mesh make(const Block& block, const Chart& chart, const Processes& processes) {
  for (int d = 0; d < dim; ++d)
    if (block.cells[static_cast<size_t>(d)] < (d == 0 && block.closed ? 3 : 1))
      throw InputError("mesh: found " + std::to_string(block.cells[static_cast<size_t>(d)]) +
                       " cells in one direction; expected at least 1, and 3 around a tube");
  dealii::Triangulation<dim, 3> tria;
  std::vector<Eigen::Matrix3Xd> corners = triangulate<dim>(block, chart, tria);
  return make_mesh<dim>(tria, std::move(corners), chart, block.closed, block.degree, processes);
}

}  // namespace

template <int dim>
Mesh make_mesh(dealii::Triangulation<dim, 3>& tria, std::vector<Eigen::Matrix3Xd> corners,
               const Chart& chart, bool closed, int p, const Processes& processes) {
  if (p < 1 || p > 8) throw InputError("degree: found " + std::to_string(p) + "; expected 1 to 8");
  const auto degree = static_cast<unsigned>(p);
  const dealii::FE_Q<dim, 3> fe(degree);
  dealii::MappingQCache<dim, 3> mapping(degree);
  // mapping points sit at the Gauss-Lobatto points in FE_Q's order
  const dealii::FE_Q<dim> lobatto(degree);
  const auto& support = lobatto.get_unit_support_points();
  mapping.initialize(tria, [&](const typename dealii::Triangulation<dim, 3>::cell_iterator& cell) {
    std::vector<dealii::Point<3>> points;
    for (const auto& s : support) {
      const Vec3 x = chart(inside(corners[cell->active_cell_index()], unit_point<dim>(s)));
      points.emplace_back(x[0], x[1], x[2]);
    }
    return points;
  });
  if (processes.size() > 1) share_out<dim>(tria, corners, processes.size());
  dealii::DoFHandler<dim, 3> dofs(tria);
  dofs.distribute_dofs(fe);
  // so that a process owns most of the rows that its cells contribute to
  if (processes.size() > 1) dealii::DoFRenumbering::subdomain_wise(dofs);

  Mesh mesh;
  mesh.dim = dim;
  mesh.degree = p;
  mesh.closed = closed;
  mesh.nodes.resize(dofs.n_dofs(), 3);
  mesh.parameters.resize(dofs.n_dofs(), 3);

  const dealii::QGauss<dim> quadrature(degree + 1);
  const unsigned points = quadrature.size(), local = fe.n_dofs_per_cell();
  auto flags = dealii::update_gradients | dealii::update_JxW_values;
  if (dim == 2) flags |= dealii::update_normal_vectors;
  dealii::FEValues<dim, 3> values(mapping, fe, quadrature, flags);
  mesh.shape.resize(points, local);
  mesh.unit_points.resize(3, points);
  for (unsigned q = 0; q < points; ++q)
    mesh.unit_points.col(q) = unit_point<dim>(quadrature.point(q));
  for (unsigned q = 0; q < points; ++q)
    for (unsigned a = 0; a < local; ++a) mesh.shape(q, a) = fe.shape_value(a, quadrature.point(q));

  std::vector<dealii::types::global_dof_index> indices(local);
  for (const auto& cell : dofs.active_cell_iterators()) {
    const Eigen::Matrix3Xd& own = corners[cell->active_cell_index()];
    cell->get_dof_indices(indices);
    std::vector<int> numbers(indices.begin(), indices.end());
    for (unsigned a = 0; a < local; ++a) {
      Vec3 at = inside(own, unit_point<dim>(support[a]));
      mesh.nodes.row(numbers[a]) = chart(at);
      if (closed && at[0] > 1 - 1e-12) at[0] = std::max(0.0, at[0] - 1);
      if (closed && at[0] < -1e-12) at[0] += 1;
      mesh.parameters.row(numbers[a]) = at;
    }
    mesh.cell_nodes.push_back(std::move(numbers));
    mesh.owner.push_back(processes.size() > 1 ? static_cast<int>(cell->subdomain_id()) : 0);
    Eigen::VectorXd weights;
    Eigen::MatrixXd gradient;
    Eigen::Matrix3Xd normal, parameters;
    if (mesh.owner.back() == processes.rank()) {
      values.reinit(cell);
      weights.resize(points);
      gradient.resize(3 * points, local);
      normal.resize(3, dim == 2 ? points : 0);
      parameters.resize(3, points);
      for (unsigned q = 0; q < points; ++q) {
        weights[q] = values.JxW(q);
        for (unsigned a = 0; a < local; ++a)
          for (unsigned J = 0; J < 3; ++J) gradient(3 * q + J, a) = values.shape_grad(a, q)[J];
        if (dim == 2)
          for (unsigned J = 0; J < 3; ++J) normal(J, q) = values.normal_vector(q)[J];
        parameters.col(q) = inside(own, unit_point<dim>(quadrature.point(q)));
      }
    }
    mesh.weights.push_back(std::move(weights));
    mesh.gradient.push_back(std::move(gradient));
    mesh.normal.push_back(std::move(normal));
    mesh.point_parameters.push_back(std::move(parameters));
  }
  mesh.corners = std::move(corners);
  return mesh;
}

template Mesh make_mesh<2>(dealii::Triangulation<2, 3>&, std::vector<Eigen::Matrix3Xd>,
                           const Chart&, bool, int, const Processes&);
template Mesh make_mesh<3>(dealii::Triangulation<3, 3>&, std::vector<Eigen::Matrix3Xd>,
                           const Chart&, bool, int, const Processes&);

Mesh make_solid(const Block& block, const Chart& chart, const Processes& processes) {
  return make<3>(block, chart, processes);
}

Mesh make_surface(const Block& block, const Chart& chart, const Processes& processes) {
  return make<2>(block, chart, processes);
}

std::vector<int> Mesh::nodes_on(int direction, double value) const {
  std::vector<int> found;
  for (int i = 0; i < node_count(); ++i)
    if (std::abs(parameters(i, direction) - value) < 1e-9) found.push_back(i);
  return found;
}

int Mesh::nearest_node(const Vec3& parameter) const {
  int best = 0;
  double least = 1e300;
  for (int i = 0; i < node_count(); ++i) {
    Vec3 d = parameters.row(i).transpose() - parameter;
    if (closed) d[0] -= std::round(d[0]);
    if (d.squaredNorm() < least) {
      least = d.squaredNorm();
      best = i;
    }
  }
  return best;
}

}  // namespace vasorod::fem
