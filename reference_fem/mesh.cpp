#include "reference_fem/mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace vasorod::fem {
namespace {

using std::size_t;

/// Parameters of a point given by cell and position in it; wraps the closed direction.
Vec3 parameter_of(const Block& block, const std::array<int, 3>& cell, const Vec3& unit, int dim) {
  Vec3 p = Vec3::Zero();
  for (int d = 0; d < dim; ++d)
    p[d] = (cell[static_cast<size_t>(d)] + unit[d]) / block.cells[static_cast<size_t>(d)];
  return p;
}

std::array<int, 3> cell_position(const Block& block, int cell) {
  const int n0 = block.cells[0], n1 = block.cells[1];
  return {cell % n0, (cell / n0) % n1, cell / (n0 * n1)};
}

template <int dim>
Vec3 unit_point(const dealii::Point<dim>& p) {
  Vec3 v = Vec3::Zero();
  for (int d = 0; d < dim; ++d) v[d] = p[static_cast<unsigned>(d)];
  return v;
}

template <int dim>
void triangulate(const Block& block, const Chart& chart, dealii::Triangulation<dim, 3>& tria) {
  const int n0 = block.cells[0], n1 = block.cells[1], n2 = dim == 3 ? block.cells[2] : 0;
  const int row = block.closed ? n0 : n0 + 1;
  const auto vertex = [&](int i, int j, int k) {
    return static_cast<unsigned>((block.closed ? i % n0 : i) + row * (j + (n1 + 1) * k));
  };
  std::vector<dealii::Point<3>> vertices;
  for (int k = 0; k <= n2; ++k)
    for (int j = 0; j <= n1; ++j)
      for (int i = 0; i < row; ++i) {
        const Vec3 x = chart(parameter_of(block, {i, j, k}, Vec3::Zero(), dim));
        vertices.emplace_back(x[0], x[1], x[2]);
      }
  std::vector<dealii::CellData<dim>> cells;
  for (int k = 0; k < std::max(n2, 1); ++k)
    for (int j = 0; j < n1; ++j)
      for (int i = 0; i < n0; ++i) {
        dealii::CellData<dim> data;
        for (unsigned v = 0; v < dealii::GeometryInfo<dim>::vertices_per_cell; ++v)
          data.vertices[v] = vertex(i + static_cast<int>(v & 1u), j + static_cast<int>(v >> 1 & 1u),
                                    k + static_cast<int>(v >> 2 & 1u));
        cells.push_back(data);
      }
  tria.create_triangulation(vertices, cells, dealii::SubCellData());
}

template <int dim>
Mesh make(const Block& block, const Chart& chart) {
  for (int d = 0; d < dim; ++d)
    if (block.cells[static_cast<size_t>(d)] < (d == 0 && block.closed ? 3 : 1))
      throw InputError("mesh: found " + std::to_string(block.cells[static_cast<size_t>(d)]) +
                       " cells in one direction; expected at least 1, and 3 around a tube");
  if (block.degree < 1 || block.degree > 8)
    throw InputError("degree: found " + std::to_string(block.degree) + "; expected 1 to 8");

  dealii::Triangulation<dim, 3> tria;
  triangulate<dim>(block, chart, tria);
  const auto degree = static_cast<unsigned>(block.degree);
  const dealii::FE_Q<dim, 3> fe(degree);
  dealii::MappingQCache<dim, 3> mapping(degree);
  // mapping points sit at the Gauss-Lobatto points in FE_Q's order
  const dealii::FE_Q<dim> lobatto(degree);
  const auto& support = lobatto.get_unit_support_points();
  mapping.initialize(tria, [&](const typename dealii::Triangulation<dim, 3>::cell_iterator& cell) {
    std::vector<dealii::Point<3>> points;
    for (const auto& s : support) {
      const Vec3 x = chart(parameter_of(block, cell_position(block, cell->index()), unit_point<dim>(s), dim));
      points.emplace_back(x[0], x[1], x[2]);
    }
    return points;
  });
  dealii::DoFHandler<dim, 3> dofs(tria);
  dofs.distribute_dofs(fe);

  Mesh mesh;
  mesh.dim = dim;
  mesh.degree = block.degree;
  mesh.block = block;
  mesh.nodes.resize(dofs.n_dofs(), 3);
  mesh.parameters.resize(dofs.n_dofs(), 3);

  const dealii::QGauss<dim> quadrature(degree + 1);
  const unsigned points = quadrature.size(), local = fe.n_dofs_per_cell();
  auto flags = dealii::update_gradients | dealii::update_JxW_values;
  if (dim == 2) flags |= dealii::update_normal_vectors;
  dealii::FEValues<dim, 3> values(mapping, fe, quadrature, flags);
  mesh.shape.resize(points, local);
  for (unsigned q = 0; q < points; ++q)
    for (unsigned a = 0; a < local; ++a) mesh.shape(q, a) = fe.shape_value(a, quadrature.point(q));

  std::vector<dealii::types::global_dof_index> indices(local);
  for (const auto& cell : dofs.active_cell_iterators()) {
    const auto position = cell_position(block, cell->index());
    cell->get_dof_indices(indices);
    std::vector<int> numbers(indices.begin(), indices.end());
    for (unsigned a = 0; a < local; ++a) {
      Vec3 p = parameter_of(block, position, unit_point<dim>(support[a]), dim);
      const Vec3 x = chart(p);
      if (block.closed && p[0] > 1 - 1e-12) p[0] = 0;
      mesh.nodes.row(numbers[a]) = x;
      mesh.parameters.row(numbers[a]) = p;
    }
    values.reinit(cell);
    Eigen::VectorXd weights(points);
    Eigen::MatrixXd gradient(3 * points, local);
    Eigen::Matrix3Xd normal(3, dim == 2 ? points : 0), parameters(3, points);
    for (unsigned q = 0; q < points; ++q) {
      weights[q] = values.JxW(q);
      for (unsigned a = 0; a < local; ++a)
        for (unsigned J = 0; J < 3; ++J) gradient(3 * q + J, a) = values.shape_grad(a, q)[J];
      if (dim == 2)
        for (unsigned J = 0; J < 3; ++J) normal(J, q) = values.normal_vector(q)[J];
      parameters.col(q) = parameter_of(block, position, unit_point<dim>(quadrature.point(q)), dim);
    }
    mesh.cell_nodes.push_back(std::move(numbers));
    mesh.weights.push_back(std::move(weights));
    mesh.gradient.push_back(std::move(gradient));
    mesh.normal.push_back(std::move(normal));
    mesh.point_parameters.push_back(std::move(parameters));
  }
  return mesh;
}

template <int dim>
std::vector<CellRow> rows(const Mesh& mesh, const std::vector<Vec3>& at) {
  const dealii::FE_Q<dim> fe(static_cast<unsigned>(mesh.degree));
  std::vector<CellRow> out;
  for (const Vec3& parameter : at) {
    std::array<int, 3> position{0, 0, 0};
    dealii::Point<dim> unit;
    for (unsigned d = 0; d < dim; ++d) {
      const int n = mesh.block.cells[d];
      const double scaled = parameter[d] * n;
      position[d] = std::clamp(static_cast<int>(std::floor(scaled)), 0, n - 1);
      unit[d] = scaled - position[d];
    }
    CellRow row;
    row.cell = position[0] + mesh.block.cells[0] * (position[1] + mesh.block.cells[1] * position[2]);
    row.shape.resize(fe.n_dofs_per_cell());
    for (unsigned a = 0; a < fe.n_dofs_per_cell(); ++a) row.shape[a] = fe.shape_value(a, unit);
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace

std::vector<int> Mesh::nodes_on(int direction, double value) const {
  std::vector<int> on;
  for (int i = 0; i < node_count(); ++i)
    if (std::abs(parameters(i, direction) - value) < 1e-9) on.push_back(i);
  return on;
}

int Mesh::nearest_node(const Vec3& parameter) const {
  int best = 0;
  double least = 1e300;
  for (int i = 0; i < node_count(); ++i) {
    Vec3 d = parameters.row(i).transpose() - parameter;
    if (block.closed) d[0] -= std::round(d[0]);
    if (d.squaredNorm() < least) least = d.squaredNorm(), best = i;
  }
  return best;
}

std::vector<CellRow> Mesh::rows_at(const std::vector<Vec3>& at) const {
  return dim == 3 ? rows<3>(*this, at) : rows<2>(*this, at);
}

Mesh make_solid(const Block& block, const Chart& chart) {
  return make<3>(block, chart);
}
Mesh make_surface(const Block& block, const Chart& chart) {
  return make<2>(block, chart);
}

FaceMesh face_of(const Mesh& mesh, int direction, int side) {
  const auto degree = static_cast<unsigned>(mesh.degree);
  const dealii::FE_Q<3> fe(degree);
  const dealii::QGauss<2> quadrature(degree + 1);
  const auto normal = static_cast<unsigned>(direction);
  // (a, b, outward normal) right-handed
  unsigned a = (normal + 1) % 3, b = (normal + 2) % 3;
  if (side == 0) std::swap(a, b);

  FaceMesh face;
  std::vector<unsigned> local;
  for (unsigned i = 0; i < fe.n_dofs_per_cell(); ++i)
    if (std::abs(fe.get_unit_support_points()[i][normal] - side) < 1e-9) local.push_back(i);
  const auto points = quadrature.size();
  face.shape.resize(points, static_cast<Eigen::Index>(local.size()));
  face.slope[0] = face.slope[1] = face.shape;
  face.weights.resize(points);
  for (unsigned q = 0; q < points; ++q) {
    dealii::Point<3> at;
    at[normal] = side;
    at[a] = quadrature.point(q)[0];
    at[b] = quadrature.point(q)[1];
    face.weights[q] = quadrature.weight(q);
    for (size_t i = 0; i < local.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      face.shape(q, column) = fe.shape_value(local[i], at);
      face.slope[0](q, column) = fe.shape_grad(local[i], at)[a];
      face.slope[1](q, column) = fe.shape_grad(local[i], at)[b];
    }
  }
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const auto position = cell_position(mesh.block, c);
    if (position[static_cast<size_t>(direction)] !=
        (side == 0 ? 0 : mesh.block.cells[static_cast<size_t>(direction)] - 1))
      continue;
    std::vector<int> numbers;
    for (const unsigned i : local) numbers.push_back(mesh.cell_nodes[static_cast<size_t>(c)][i]);
    face.nodes.push_back(std::move(numbers));
  }
  return face;
}

}  // namespace vasorod::fem
