// The stress of the solid at rest from a linear displacement: s = C : e at every Gauss point, with
// e = sym(Q^T grad u) in local axes Q. By a split law, s is that of the cell's projected volume
// change, so that the forces of s are the stiffness at rest times u there as well.
#include "reference_fem/solid.h"

namespace vasorod::fem {

using std::size_t;

std::vector<Solid::LocalGradient> Solid::local_gradients(size_t c, const DofValues& u) const {
  // row 3 q + J, column i: du_i/dX_J
  const Eigen::MatrixX3d slope = mesh_.gradient[c] * triples_of(u, mesh_.cell_nodes[c], 3);
  std::vector<LocalGradient> local;
  for (size_t q = 0; q < axes_[c].size(); ++q)
    local.push_back(
        {(slope.middleRows<3>(3 * static_cast<Eigen::Index>(q)) * axes_[c][q]).transpose(),
         mesh_.weights[c][static_cast<Eigen::Index>(q)]});
  return local;
}

Solid::CellPrestress Solid::prestress_of(size_t c, double axial_stretch, const DofValues& u) const {
  CellPrestress out;
  const Eigen::VectorXd& weights = mesh_.weights[c];
  const std::vector<LocalGradient> gradients = local_gradients(c, u);
  Eigen::Matrix<double, 6, Eigen::Dynamic> strain(6, weights.size());
  Eigen::VectorXd volume(weights.size());
  for (Eigen::Index q = 0; q < weights.size(); ++q) {
    const Mat3& local = gradients[static_cast<size_t>(q)].value;
    strain.col(q) =
        law_.uniaxial_strain(axial_stretch) + strain_components(0.5 * (local + local.transpose()));
    volume[q] = strain.col(q).head<3>().sum();
  }
  if (projection_) {
    const Mat6 isochoric = law_.isochoric(Mat3::Identity()).tangent;
    const VolumeProjection::Terms projected =
        projection_->evaluate(weights, Eigen::VectorXd::Ones(weights.size()), law_);
    const Eigen::VectorXd moments = projection_->basis().transpose() * weights.cwiseProduct(volume),
                          pressure = projection_->basis() * (projected.curvature * moments);
    out.stress = isochoric * strain;
    out.stress.topRows<3>().rowwise() += pressure.transpose();
  } else {
    out.stress = law_.linear_stiffness() * strain;
  }
  out.stored = 0.5 * weights.dot(out.stress.cwiseProduct(strain).colwise().sum().transpose());
  return out;
}

}  // namespace vasorod::fem
