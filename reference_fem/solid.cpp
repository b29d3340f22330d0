#include "reference_fem/solid.h"

#include <Eigen/Dense>
#include <algorithm>

#include "geometry/rigid_motion.h"
#include "reference_fem/point_tangent.h"
#include "reference_fem/section.h"
#include "reference_fem/transposed_product.h"

namespace vasorod::fem {

using std::size_t;

Solid::Solid(Mesh mesh, const MaterialLaw& law, const Axes& axes)
    : mesh_(std::move(mesh)), law_(law) {
  if (law_.splits()) projection_.emplace(mesh_);
  for (size_t c = 0; c < mesh_.gradient.size(); ++c) {
    std::vector<Mat3> local;
    for (Eigen::Index q = 0; q < mesh_.weights[c].size(); ++q) {
      local.push_back(axes(mesh_.point_parameters[c].col(q)));
      auto gradient = mesh_.gradient[c].middleRows<3>(3 * q);
      gradient = (local.back().transpose() * gradient).eval();
    }
    axes_.push_back(std::move(local));
  }
}

void Solid::add_pressure(int direction, int side, double pressure) {
  pressures_.push_back({face_of(mesh_, direction, side), {0, pressure}});
}

void Solid::set_pressure(const LumenPressure& pressure) {
  for (Pressure& face : pressures_) face.value = pressure;
}

bool Solid::symmetric() const {
  return std::none_of(pressures_.begin(), pressures_.end(), [](const Pressure& face) {
    return face.value.scan != 0 || face.value.after != 0;
  });
}

int Solid::cell_count() const {
  int count = mesh_.cell_count();
  for (const Pressure& p : pressures_) count += static_cast<int>(p.face.nodes.size());
  return count;
}

const Solid::Pressure* Solid::face_cell(int cell, size_t& index) const {
  index = static_cast<size_t>(cell - mesh_.cell_count());
  for (const Pressure& p : pressures_) {
    if (index < p.face.nodes.size()) return &p;
    index -= p.face.nodes.size();
  }
  return nullptr;
}

int Solid::owner(int cell) const {
  size_t index = 0;
  if (cell >= mesh_.cell_count()) cell = face_cell(cell, index)->face.cell[index];
  return mesh_.owner[static_cast<size_t>(cell)];
}

std::vector<int> Solid::dofs(int cell) const {
  size_t index = 0;
  const std::vector<int>& nodes = cell < mesh_.cell_count()
                                      ? mesh_.cell_nodes[static_cast<size_t>(cell)]
                                      : face_cell(cell, index)->face.nodes[index];
  std::vector<int> out;
  for (int component = 0; component < 3; ++component)
    for (const int node : nodes) out.push_back(3 * node + component);
  return out;
}

bool Solid::evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                     CellTerms& terms) const {
  if (cell >= mesh_.cell_count()) {
    size_t index = 0;
    const Pressure* pressure = face_cell(cell, index);
    evaluate_face(*pressure, pressure->face.nodes[index], u, load, terms);
    return true;
  }
  const auto c = static_cast<size_t>(cell);
  const std::vector<int>& nodes = mesh_.cell_nodes[c];
  const auto n = static_cast<Eigen::Index>(nodes.size());
  const Eigen::MatrixXd& gradient = mesh_.gradient[c];
  // row 3 q + J, column i: du_i/dX_J
  const Eigen::MatrixX3d slope = gradient * triples_of(u, nodes, 3);

  const int points = mesh_.point_count();
  Eigen::MatrixX3d stress(3 * points, 3);  // row 3 q + J, column i: w P_iJ
  static thread_local std::vector<Mat9> tangents;
  tangents.resize(static_cast<size_t>(points));
  static thread_local std::vector<Mat3> gradients;
  gradients.resize(static_cast<size_t>(points));
  // From the shape without stress: the ratio of volumes, and the points' own volumes there.
  Eigen::VectorXd volume(points), weights = mesh_.weights[c];
  for (int q = 0; q < points; ++q) {
    Mat3& F = gradients[static_cast<size_t>(q)];
    F = axes_[c][static_cast<size_t>(q)] + slope.middleRows<3>(3 * q).transpose();
    volume[q] = F.determinant();
    if (!(volume[q] > 0)) return false;
    if (unloading_.empty()) continue;
    const double unloaded = unloading_[c][static_cast<size_t>(q)].determinant();
    volume[q] *= unloaded;
    weights[q] /= unloaded;
  }
  VolumeProjection::Terms projected;
  if (projection_) projected = projection_->evaluate(weights, volume, law_);
  terms.energy = projected.energy;
  if (!prestress_.empty()) terms.energy += prestress_[c].stored;
  for (int q = 0; q < points; ++q) {
    const Mat3& F = gradients[static_cast<size_t>(q)];
    const Mat3* A = unloading_.empty() ? nullptr : &unloading_[c][static_cast<size_t>(q)];
    const Mat3 unloaded = A ? Mat3(F * *A) : F;  // from the shape without stress
    Response response = projection_ ? law_.isochoric(unloaded) : law_.evaluate(unloaded);
    if (projection_) {
      const Response held = pressure_response(unloaded, projected.pressure[q]);
      response.stress += held.stress;
      response.tangent += held.tangent;
    }
    if (A) response = from_stress_free_shape(response, *A);
    if (!prestress_.empty()) response += law_.of_prestress(F, prestress_[c].stress.col(q));
    const double w = mesh_.weights[c][q];
    terms.energy += w * response.energy;
    stress.middleRows<3>(3 * q) = w * (F * stress_tensor(response.stress)).transpose();
    if (want_tangent) tangents[static_cast<size_t>(q)] = w * first_tangent(F, response);
  }
  const Eigen::MatrixX3d residual = gradient.transpose() * stress;
  terms.residual = Eigen::Map<const Eigen::VectorXd>(residual.data(), 3 * n);
  if (!want_tangent) return true;

  terms.tangent.resize(3 * n, 3 * n);
  static thread_local Eigen::MatrixXd weighted;
  weighted.resize(3 * points, n);
  for (int i = 0; i < 3; ++i)
    for (int k = i; k < 3; ++k) {
      for (int q = 0; q < points; ++q)
        weighted.middleRows<3>(3 * q).noalias() = tangents[static_cast<size_t>(q)]
                                                      .block<3, 3>(3 * i, 3 * k)
                                                      .lazyProduct(gradient.middleRows<3>(3 * q));
      auto block = terms.tangent.block(i * n, k * n, n, n);
      transposed_product(gradient, weighted, block);
      if (k > i) terms.tangent.block(k * n, i * n, n, n) = block.transpose();
    }
  if (projection_) {  // J changes by cof F : dF
    Eigen::MatrixXd change(points, 3 * n);
    for (int q = 0; q < points; ++q) {
      const Mat3 cofactor = volume[q] * gradients[static_cast<size_t>(q)].inverse().transpose();
      for (int i = 0; i < 3; ++i)
        change.block(q, i * n, 1, n) = weights[q] * cofactor.row(i) * gradient.middleRows<3>(3 * q);
    }
    const Eigen::MatrixXd moments = projection_->basis().transpose() * change;
    terms.tangent.noalias() += moments.transpose() * projected.curvature * moments;
  }
  return true;
}

// The pressure's force on node a is -p N_a n da = -p N_a (x,1 x x,2) w with the outward normal. The
// residual contains the opposite force.
void Solid::evaluate_face(const Pressure& pressure, const std::vector<int>& nodes,
                          const DofValues& u, double load, CellTerms& terms) const {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  const FaceMesh& face = pressure.face;
  Eigen::Matrix3Xd x(3, n);
  for (Eigen::Index a = 0; a < n; ++a) {
    const int node = nodes[static_cast<size_t>(a)];
    x.col(a) = mesh_.nodes.row(node).transpose() + u.segment<3>(3 * node);
  }
  terms.energy = 0;
  terms.residual = Eigen::VectorXd::Zero(3 * n);
  terms.tangent = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Eigen::Index q = 0; q < face.weights.size(); ++q) {
    const Vec3 along = x * face.slope[0].row(q).transpose(),
               across = x * face.slope[1].row(q).transpose();
    const double w = pressure_at(pressure.value, load) * face.weights[q];
    const Vec3 area = along.cross(across);
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index i = 0; i < 3; ++i)
        terms.residual[i * n + a] += w * face.shape(q, a) * area[i];
    for (Eigen::Index b = 0; b < n; ++b) {
      const Mat3 change = face.slope[1](q, b) * hat(along) - face.slope[0](q, b) * hat(across);
      for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index i = 0; i < 3; ++i)
          for (Eigen::Index k = 0; k < 3; ++k)
            terms.tangent(i * n + a, k * n + b) += w * face.shape(q, a) * change(i, k);
    }
  }
}

}  // namespace vasorod::fem
