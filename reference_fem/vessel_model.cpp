#include "reference_fem/vessel_model.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace vasorod::fem {
namespace {

// The local axes in the shape that `shape` takes them to: the fibre, its third, is the line of
// matter that it is as seen; the second stays beside it.
Mat3 axes_in(const Mat3& shape) {
  Mat3 axes;
  axes.col(2) = shape.col(2).normalized();
  axes.col(0) = shape.col(1).cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

bool VesselModel::set_stress_free_shape(double axial_stretch, const DofValues& u) {
  prestress_.clear();
  unloading_.assign(mesh().cell_nodes.size(), {});
  const Mat3 stretch = law().uniaxial_stretches(axial_stretch).asDiagonal();
  for (std::size_t c = 0; c < unloading_.size(); ++c) {
    if (mesh().weights[c].size() == 0) continue;
    for (const LocalGradient& gradient : local_gradients(c, u)) {
      const Mat3 shape = Mat3::Identity() - gradient.value;
      if (!(shape.determinant() > 0)) {
        unloading_.clear();
        return false;
      }
      unloading_[c].push_back(shape.inverse() * axes_in(shape) * stretch);
    }
  }
  return true;
}

double VesselModel::rms_prestrain(double axial_stretch, const DofValues& u,
                                  const Processes& processes) const {
  const Vec6 stretch = law().uniaxial_strain(axial_stretch);
  std::array<double, 2> sums{};  // of the squared strain, of the volume
  for (std::size_t c = 0; c < mesh().cell_nodes.size(); ++c) {
    if (mesh().weights[c].size() == 0) continue;
    for (const LocalGradient& local : local_gradients(c, u)) {
      const Mat3 e = stress_tensor(stretch) + 0.5 * (local.value + local.value.transpose());
      sums[0] += local.volume * e.bottomRightCorner<2, 2>().squaredNorm();
      sums[1] += local.volume;
    }
  }
  processes.sum(sums.data(), sums.size());
  return std::sqrt(sums[0] / sums[1]);
}

}  // namespace vasorod::fem
