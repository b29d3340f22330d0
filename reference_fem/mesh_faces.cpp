// Faces of a mesh with their quadrature; location of points of the parameter cube in the mesh.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <vasorod/error.h>

#include "reference_fem/make_mesh.h"

namespace vasorod::fem {
namespace {

using std::size_t;

template <int dim>
const std::vector<dealii::Point<dim>>& support_points(unsigned degree) {
  static thread_local std::vector<std::vector<dealii::Point<dim>>> known(9);
  if (known[degree].empty()) known[degree] = dealii::FE_Q<dim>(degree).get_unit_support_points();
  return known[degree];
}

/// Values and slopes at one point of the Lagrange basis on [0, 1], nodes in increasing order.
struct Basis {
  Eigen::VectorXd value, slope;
};

Basis basis_at(unsigned degree, double place) {
  const dealii::FE_Q<1> fe(degree);
  std::vector<std::pair<double, unsigned>> order;
  for (unsigned i = 0; i < fe.n_dofs_per_cell(); ++i)
    order.emplace_back(fe.get_unit_support_points()[i][0], i);
  std::sort(order.begin(), order.end());
  Basis basis{Eigen::VectorXd(degree + 1), Eigen::VectorXd(degree + 1)};
  for (unsigned k = 0; k <= degree; ++k) {
    basis.value[k] = fe.shape_value(order[k].second, dealii::Point<1>(place));
    basis.slope[k] = fe.shape_grad(order[k].second, dealii::Point<1>(place))[0];
  }
  return basis;
}

/// Nodes of the unit cell's face (normal direction, side); the face's first direction runs fastest.
template <int dim>
std::vector<unsigned> face_nodes(unsigned degree, unsigned normal, int side, unsigned a,
                                 unsigned b) {
  const auto& points = support_points<dim>(degree);
  std::vector<unsigned> local;
  for (unsigned i = 0; i < points.size(); ++i)
    if (std::abs(points[i][normal] - side) < 1e-9) local.push_back(i);
  std::sort(local.begin(), local.end(), [&](unsigned i, unsigned k) {
    if (dim == 3 && std::abs(points[i][b] - points[k][b]) > 1e-9)
      return points[i][b] < points[k][b];
    return points[i][a] < points[k][a];
  });
  return local;
}

template <int dim>
void collect(const Mesh& mesh, int direction, int side, FaceMesh& face) {
  const auto degree = static_cast<unsigned>(mesh.degree);
  for (int c = 0; c < mesh.cell_count(); ++c) {
    const Eigen::Matrix3Xd& corners = mesh.corners[static_cast<size_t>(c)];
    for (unsigned normal = 0; normal < dim; ++normal)
      for (int local_side = 0; local_side < 2; ++local_side) {
        std::vector<Eigen::Index> own;  // corners of this face
        for (Eigen::Index v = 0; v < corners.cols(); ++v)
          if ((v >> normal & 1) == local_side) own.push_back(v);
        bool on = true;
        for (const Eigen::Index v : own) on = on && std::abs(corners(direction, v) - side) < 1e-9;
        if (!on) continue;
        // (a, b, outward normal) right-handed
        unsigned a = (normal + 1) % dim, b = (normal + 2) % dim;
        if (dim == 3 && local_side == 0) std::swap(a, b);
        std::vector<int> numbers;
        for (const unsigned i : face_nodes<dim>(degree, normal, local_side, a, b))
          numbers.push_back(mesh.cell_nodes[static_cast<size_t>(c)][i]);
        face.cell.push_back(c);
        face.nodes.push_back(std::move(numbers));
        const Vec3 first = corners.col(own[1]) - corners.col(own[0]);
        face.extent.push_back(
            dim == 3 ? first.cross(Vec3(corners.col(own[2]) - corners.col(own[0]))).norm()
                     : first.norm());
      }
  }
}

template <int dim>
std::vector<CellRow> rows(const Mesh& mesh, const std::vector<Vec3>& at) {
  const dealii::FE_Q<dim> fe(static_cast<unsigned>(mesh.degree));
  std::vector<Eigen::Matrix<double, 3, 2>> box;
  for (const auto& corners : mesh.corners) {
    box.emplace_back();
    box.back() << corners.rowwise().minCoeff(), corners.rowwise().maxCoeff();
  }
  constexpr double slack = 1e-9;
  std::vector<CellRow> out;
  for (const Vec3& wanted : at) {
    CellRow row;
    row.cell = -1;
    for (int c = 0; c < mesh.cell_count() && row.cell < 0; ++c)
      for (const int shift : {0, 1, -1}) {
        if (shift != 0 && !mesh.closed) break;
        Vec3 p = wanted;
        p[0] += shift;
        const auto& [lo, hi] = std::pair<Vec3, Vec3>(box[static_cast<size_t>(c)].col(0),
                                                     box[static_cast<size_t>(c)].col(1));
        if ((p - lo).head<dim>().minCoeff() < -slack || (hi - p).head<dim>().minCoeff() < -slack)
          continue;
        // Newton on the multilinear interpolation: one step in a cell with straight, parallel sides
        const Eigen::Matrix3Xd& corners = mesh.corners[static_cast<size_t>(c)];
        Vec3 unit(0.5, 0.5, dim == 3 ? 0.5 : 0);
        for (int i = 0; i < 20; ++i) {
          Eigen::Matrix<double, dim, dim> slope;
          const Vec3 here = inside(corners, unit);
          for (int d = 0; d < dim; ++d) {
            Vec3 ahead = unit, behind = unit;  // linear along each direction: differences are exact
            ahead[d] = 1;
            behind[d] = 0;
            slope.col(d) = (inside(corners, ahead) - inside(corners, behind)).template head<dim>();
          }
          const Eigen::Matrix<double, dim, 1> step =
              slope.inverse() * (p - here).template head<dim>();
          unit.head<dim>() += step;
          if (!step.allFinite() || step.norm() < 1e-14) break;
        }
        if (!(unit.head<dim>().minCoeff() > -1e-7 && unit.head<dim>().maxCoeff() < 1 + 1e-7))
          continue;
        row.cell = c;
        dealii::Point<dim> point;
        for (unsigned d = 0; d < dim; ++d) point[d] = unit[d];
        row.shape.resize(fe.n_dofs_per_cell());
        for (unsigned i = 0; i < fe.n_dofs_per_cell(); ++i) row.shape[i] = fe.shape_value(i, point);
        break;
      }
    if (row.cell < 0)
      throw InputError("mesh: found a gap; expected cells that fill the whole wall");
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace

std::vector<CellRow> Mesh::rows_at(const std::vector<Vec3>& at) const {
  return dim == 3 ? rows<3>(*this, at) : rows<2>(*this, at);
}

FaceMesh face_of(const Mesh& mesh, int direction, int side) {
  const auto degree = static_cast<unsigned>(mesh.degree);
  FaceMesh face;
  if (mesh.dim == 3)
    collect<3>(mesh, direction, side, face);
  else
    collect<2>(mesh, direction, side, face);

  const dealii::QGauss<1> rule(degree + 1);
  const auto n = static_cast<Eigen::Index>(degree + 1), second = mesh.dim == 3 ? n : 1;
  face.shape.resize(n * second, n * second);
  face.slope[0] = face.shape;
  if (mesh.dim == 3) face.slope[1] = face.shape;
  face.weights.resize(n * second);
  for (Eigen::Index j = 0; j < second; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto at = [&](Eigen::Index k) { return rule.point(static_cast<unsigned>(k))[0]; };
      const auto weight = [&](Eigen::Index k) { return rule.weight(static_cast<unsigned>(k)); };
      const Eigen::Index q = i + n * j;
      const Basis a = basis_at(degree, at(i));
      if (mesh.dim == 2) {
        face.weights[q] = weight(i);
        face.shape.row(q) = a.value;
        face.slope[0].row(q) = a.slope;
        continue;
      }
      const Basis b = basis_at(degree, at(j));
      face.weights[q] = weight(i) * weight(j);
      for (Eigen::Index l = 0; l < n; ++l) {
        face.shape.row(q).segment(l * n, n) = b.value[l] * a.value;
        face.slope[0].row(q).segment(l * n, n) = b.value[l] * a.slope;
        face.slope[1].row(q).segment(l * n, n) = b.slope[l] * a.value;
      }
    }
  return face;
}

}  // namespace vasorod::fem
