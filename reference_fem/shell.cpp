#include "reference_fem/shell.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "reference_fem/point_tangent.h"
#include "reference_fem/transposed_product.h"

namespace vasorod::fem {

using std::size_t;

namespace {

struct Gauss {
  std::vector<double> at, weight;  ///< on [-1/2, 1/2]
};

Gauss gauss(int points) {
  if (points == 2) return {{-0.5 / std::sqrt(3.0), 0.5 / std::sqrt(3.0)}, {0.5, 0.5}};
  if (points == 5) {
    const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 6,
                 outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 6,
                 heavy = (322 + 13 * std::sqrt(70.0)) / 1800,
                 light = (322 - 13 * std::sqrt(70.0)) / 1800;
    return {{-outer, -inner, 0, inner, outer}, {light, heavy, 64.0 / 225, heavy, light}};
  }
  return {{-0.5 * std::sqrt(0.6), 0, 0.5 * std::sqrt(0.6)}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
}

}  // namespace

Shell::Shell(Mesh mesh, const MaterialLaw& law, const ShellBody& body, int depth_points)
    : mesh_(std::move(mesh)), law_(law), depth_points_(depth_points) {
  directors_.resize(mesh_.node_count(), 3);
  for (int i = 0; i < mesh_.node_count(); ++i)
    directors_.row(i) = body.director(mesh_.parameters.row(i));
  const Gauss rule = gauss(depth_points_);
  for (size_t c = 0; c < mesh_.cell_nodes.size(); ++c) {
    const auto n = static_cast<Eigen::Index>(mesh_.cell_nodes[c].size());
    Eigen::MatrixX3d D(n, 3);
    for (Eigen::Index a = 0; a < n; ++a)
      D.row(a) = directors_.row(mesh_.cell_nodes[c][static_cast<size_t>(a)]);
    std::vector<Point> points;
    thickness_.emplace_back(mesh_.weights[c].size());
    for (Eigen::Index q = 0; q < mesh_.weights[c].size(); ++q) {
      Vec3 normal = mesh_.normal[c].col(q);
      const Vec3 director = (mesh_.shape.row(q) * D).transpose();
      if (normal.dot(director) < 0) normal = -normal;
      mesh_.normal[c].col(q) = normal;
      const Mat3 slope = (mesh_.gradient[c].middleRows<3>(3 * q) * D).transpose();  // dD_i/dX_J
      const Vec3 parameter = mesh_.point_parameters[c].col(q);
      const double t = body.thickness(parameter);
      thickness_[c][q] = t;
      const Mat3 axes = body.axes(parameter);
      for (size_t k = 0; k < rule.at.size(); ++k) {
        const double zeta = rule.at[k] * t;
        const Mat3 G = Mat3::Identity() - normal * normal.transpose() + zeta * slope +
                       director * normal.transpose();
        points.push_back({zeta,
                          t * rule.weight[k] * std::abs(G.determinant()) * mesh_.weights[c][q],
                          G.inverse() * axes, axes});
      }
    }
    points_.push_back(std::move(points));
  }
}

Shell::NodeValues Shell::values_of(size_t cell, const DofValues& u) const {
  const std::vector<int>& nodes = mesh_.cell_nodes[cell];
  const auto n = static_cast<Eigen::Index>(nodes.size());
  NodeValues out{triples_of(u, nodes, 7), triples_of(u, nodes, 7, 3), Eigen::MatrixX3d(n, 3),
                 Eigen::VectorXd(n)};
  for (Eigen::Index a = 0; a < n; ++a) {
    const int node = nodes[static_cast<size_t>(a)];
    out.D.row(a) = directors_.row(node);
    out.beta[a] = u[7 * node + 6];
  }
  return out;
}

std::vector<int> Shell::dofs(int cell) const {
  std::vector<int> out;
  for (int component = 0; component < 7; ++component)
    for (const int node : mesh_.cell_nodes[static_cast<size_t>(cell)])
      out.push_back(7 * node + component);
  return out;
}

// Every variation of F (in local axes) is a (x) g:
//   u_i: e_i (x) g_u,  w_i: e_i (x) g_w,  beta: (D + w) (x) g_beta,
// with g_u = pull^T grad N, g_w = pull^T (zeta grad N + N (1 + zeta beta) n),
// g_beta = N zeta pull^T n.
bool Shell::evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                     CellTerms& terms) const {
  const auto c = static_cast<size_t>(cell);
  const auto n = static_cast<Eigen::Index>(mesh_.cell_nodes[c].size());
  const auto [ue, we, De, be] = values_of(c, u);
  const auto count = static_cast<Eigen::Index>(points_[c].size());
  // g_u and g_w side by side, three rows per point
  static thread_local Eigen::MatrixXd slopes, weighted;
  slopes.resize(3 * count, 2 * n);
  static thread_local std::vector<Mat9> tangents;
  tangents.resize(static_cast<size_t>(count));
  Eigen::MatrixX3d stress(3 * count, 3);
  terms.energy = prestress_.empty() ? 0 : prestress_[c].stored;
  terms.residual = Eigen::VectorXd::Zero(7 * n);
  if (want_tangent) terms.tangent = Eigen::MatrixXd::Zero(7 * n, 7 * n);

  for (int q = 0; q < mesh_.point_count(); ++q) {
    const auto gradient = mesh_.gradient[c].middleRows<3>(3 * q);
    const Eigen::RowVectorXd N = mesh_.shape.row(q);
    const Vec3 normal = mesh_.normal[c].col(q);
    const Mat3 du = (gradient * ue).transpose(), dw = (gradient * we).transpose();
    const Vec3 D = (N * De).transpose(), w = (N * we).transpose(), d = D + w;
    const double beta = N * be;
    for (int k = 0; k < depth_points_; ++k) {
      const Eigen::Index at = q * depth_points_ + k;
      const Point& point = points_[c][static_cast<size_t>(at)];
      const double zeta = point.zeta, grow = 1 + zeta * beta;
      const Mat3 F =
          point.axes + (du + zeta * dw + (w + zeta * beta * d) * normal.transpose()) * point.pull;
      if (!(F.determinant() > 0)) return false;
      Response response;
      if (unloading_.empty()) {
        response = law_.evaluate(F);
      } else {
        const Mat3& A = unloading_[c][static_cast<size_t>(at)];
        response = from_stress_free_shape(law_.evaluate(F * A), A);
      }
      if (!prestress_.empty()) response += law_.of_prestress(F, prestress_[c].stress.col(at));
      terms.energy += point.weight * response.energy;
      const Mat3 P = point.weight * F * stress_tensor(response.stress);
      stress.middleRows<3>(3 * at) = P.transpose();
      const Vec3 across = point.pull.transpose() * normal;
      auto g = slopes.middleRows<3>(3 * at);
      g.leftCols(n).noalias() = point.pull.transpose().lazyProduct(gradient);
      g.rightCols(n) = zeta * g.leftCols(n) + grow * across * N;
      const Vec3 traction = P * across;
      terms.residual.tail(n) += zeta * d.dot(traction) * N.transpose();
      if (!want_tangent) continue;

      Mat9& A = tangents[static_cast<size_t>(at)];
      A = point.weight * first_tangent(F, response);
      Eigen::Matrix<double, 9, 1> b;  // variation of F by beta, without the shape function
      for (int i = 0; i < 3; ++i) b.segment<3>(3 * i) = zeta * d[i] * across;
      const Eigen::Matrix<double, 9, 1> Ab = A * b;
      terms.tangent.bottomRightCorner(n, n).noalias() += b.dot(Ab) * N.transpose() * N;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::RowVectorXd row = Ab.segment<3>(3 * i).transpose() * g;
        terms.tangent.block(6 * n, i * n, n, n).noalias() += N.transpose() * row.head(n);
        terms.tangent.block(6 * n, (3 + i) * n, n, n).noalias() +=
            N.transpose() * (row.tail(n) + zeta * traction[i] * N);
      }
    }
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::VectorXd r = slopes.transpose() * stress.col(i);
    terms.residual.segment(i * n, n) = r.head(n);
    terms.residual.segment((3 + i) * n, n) = r.tail(n);
  }
  if (!want_tangent) {
    if (!symmetric()) press(cell, u, load, want_tangent, terms);
    return true;
  }

  weighted.resize(3 * count, 2 * n);
  Eigen::MatrixXd block(2 * n, 2 * n);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = i; k < 3; ++k) {
      for (Eigen::Index at = 0; at < count; ++at)
        weighted.middleRows<3>(3 * at).noalias() = tangents[static_cast<size_t>(at)]
                                                       .block<3, 3>(3 * i, 3 * k)
                                                       .lazyProduct(slopes.middleRows<3>(3 * at));
      transposed_product(slopes, weighted, block);
      for (const auto& [row, column, part] : {std::array<Eigen::Index, 3>{i, k, 0},
                                              {i, 3 + k, 1},
                                              {3 + i, k, 2},
                                              {3 + i, 3 + k, 3}}) {
        const auto piece = block.block((part / 2) * n, (part % 2) * n, n, n);
        terms.tangent.block(row * n, column * n, n, n) = piece;
        if (k > i) terms.tangent.block(column * n, row * n, n, n) = piece.transpose();
      }
    }
  terms.tangent.topRightCorner(6 * n, n) = terms.tangent.bottomLeftCorner(n, 6 * n).transpose();
  if (!symmetric()) press(cell, u, load, want_tangent, terms);
  return true;
}

}  // namespace vasorod::fem
