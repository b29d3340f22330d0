#include "reference_fem/section.h"

#include <Eigen/Geometry>

namespace vasorod::fem {

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

Mat3 rotation_exp(const Vec3& v) {
  const double angle = v.norm();
  if (angle == 0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
}

Vec3 rotation_log(const Mat3& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

}  // namespace vasorod::fem
