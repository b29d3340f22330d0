// Tubes as sections, for the tests of hybrid/sections.
#pragma once

#include <cmath>

#include "geometry/rigid_motion.h"
#include "sections/section_energy.h"

namespace vasorod::testing {

/// A straight tube along z as a shape.
inline SectionShape straight_shape(const SectionSpace& space, double radius, double length) {
  SectionShape shape{space, Eigen::MatrixXd::Zero(space.row_size(), space.along.count())};
  const Eigen::VectorXd points = space.along.interpolation_points();
  const int modes = space.modes();
  for (int i = 0; i < space.along.count(); ++i) {
    shape.coefficients(1, i) = radius;          // x: cos theta
    shape.coefficients(modes + 2, i) = radius;  // y: sin theta
    shape.coefficients(2 * modes, i) = length * points[i];
  }
  return shape;
}

/// The same with a smooth disturbance of all coefficients of this size, the same for each call.
inline SectionShape disturbed(SectionShape shape, double size) {
  for (Eigen::Index i = 0; i < shape.coefficients.cols(); ++i)
    for (Eigen::Index k = 0; k < shape.coefficients.rows(); ++k)
      shape.coefficients(k, i) +=
          size * std::sin(1.7 * static_cast<double>(k) + 0.9 * static_cast<double>(i));
  return shape;
}

/// A wall of this thickness, E = 1.
inline SectionWall wall_of_shape(const SectionShape& rest, double thickness, Law law = Law::biot,
                                 double mid_offset = 0, double poisson = 0.3) {
  SectionWall wall;
  wall.rest = rest;
  wall.thickness = [thickness](double) { return thickness; };
  wall.mid_offset = mid_offset;
  wall.material = Material::isotropic(1, poisson, law);
  return wall;
}

/// The shape moved rigidly.
inline Eigen::MatrixXd moved(const SectionShape& shape, const Pose& pose) {
  Eigen::MatrixXd result = shape.coefficients;
  const int modes = shape.space.modes();
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    Eigen::MatrixX3d row = result.col(i).reshaped(modes, 3) * pose.rotation.transpose();
    row.row(0) += pose.position.transpose();
    result.col(i) = row.reshaped();
  }
  return result;
}

}  // namespace vasorod::testing
