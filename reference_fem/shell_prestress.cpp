// The stress of the shell at rest from linear changes of its seven parameters: s = C : e at every
// quadrature point of every depth, with e = sym(Q^T dF) in local axes Q and
//
//   dF = [grad u + zeta grad w + (w + zeta beta D) n^T] G^-1
#include "reference_fem/shell.h"

namespace vasorod::fem {

using std::size_t;

std::vector<Shell::LocalGradient> Shell::local_gradients(size_t c, const DofValues& u) const {
  const auto [ue, we, De, be] = values_of(c, u);
  std::vector<LocalGradient> local;
  for (Eigen::Index q = 0; q < mesh_.point_count(); ++q) {
    const auto gradient = mesh_.gradient[c].middleRows<3>(3 * q);
    const Eigen::RowVectorXd N = mesh_.shape.row(q);
    const Mat3 du = (gradient * ue).transpose(), dw = (gradient * we).transpose();
    const Vec3 w = (N * we).transpose(), D = (N * De).transpose();
    const double beta = N * be;
    for (int k = 0; k < depth_points_; ++k) {
      const Eigen::Index at = q * depth_points_ + k;
      const Point& point = points_[c][static_cast<size_t>(at)];
      const Mat3 change = (du + point.zeta * dw +
                           (w + point.zeta * beta * D) * mesh_.normal[c].col(q).transpose()) *
                          point.pull;
      local.push_back({point.axes.transpose() * change, point.weight});
    }
  }
  return local;
}

Shell::CellPrestress Shell::prestress_of(size_t c, double axial_stretch, const DofValues& u) const {
  CellPrestress out;
  const std::vector<LocalGradient> gradients = local_gradients(c, u);
  out.stress.resize(6, std::ssize(gradients));
  for (size_t at = 0; at < gradients.size(); ++at) {
    const Mat3& local = gradients[at].value;
    const Vec6 strain =
        law_.uniaxial_strain(axial_stretch) + strain_components(0.5 * (local + local.transpose()));
    const Vec6 stress = law_.linear_stiffness() * strain;
    out.stress.col(static_cast<Eigen::Index>(at)) = stress;
    out.stored += 0.5 * points_[c][at].weight * stress.dot(strain);
  }
  return out;
}

}  // namespace vasorod::fem
