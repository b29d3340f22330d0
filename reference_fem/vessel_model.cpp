#include "reference_fem/vessel_model.h"

#include <Eigen/Eigenvalues>

namespace vasorod::fem {

bool VesselModel::set_stress_free_shape(double axial_stretch, const DofValues& u) {
  prestress_.clear();
  unloading_.assign(mesh().cell_nodes.size(), {});
  const Mat3 stretch = law().uniaxial_stretches(axial_stretch).asDiagonal();
  for (std::size_t c = 0; c < unloading_.size(); ++c) {
    if (mesh().weights[c].size() == 0) continue;
    for (const Mat3& gradient : local_gradients(c, u)) {
      const Mat3 shape = Mat3::Identity() - gradient;
      if (!(shape.determinant() > 0)) {
        unloading_.clear();
        return false;
      }
      // The local axes turn with the shape.
      const Eigen::SelfAdjointEigenSolver<Mat3> squared(shape.transpose() * shape);
      unloading_[c].push_back(squared.operatorInverseSqrt() * stretch);
    }
  }
  return true;
}

}  // namespace vasorod::fem
