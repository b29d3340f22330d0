#include "sections/section_shape.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sections/banded_cholesky.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The section at u (3 modes), or its derivative along.
VectorXd section_at(const SectionShape& shape, double u, int derivative) {
  const AxialBasis::Values basis = shape.space.along.at(u);
  const Eigen::Index functions = basis.values.cols();
  return shape.coefficients.middleCols(basis.first, functions) *
         basis.values.row(derivative).transpose();
}

Vec3 around(const SectionShape& shape, const VectorXd& section, double theta, int derivative) {
  const MatrixXd values =
      harmonic_values(VectorXd::Constant(1, theta), shape.space.harmonics, derivative);
  return (values * section.reshaped(shape.space.modes(), 3)).transpose();
}

}  // namespace

Vec3 SectionShape::point(double u, double theta) const {
  return around(*this, section_at(*this, u, 0), theta, 0);
}

SurfaceJet SectionShape::jet(double u, double theta) const {
  const VectorXd here = section_at(*this, u, 0), first = section_at(*this, u, 1),
                 second = section_at(*this, u, 2);
  SurfaceJet jet;
  jet << around(*this, first, theta, 0), around(*this, here, theta, 1),
      around(*this, second, theta, 0), around(*this, first, theta, 1),
      around(*this, here, theta, 2);
  return jet;
}

SectionShape in_space(const SectionShape& shape, const SectionSpace& space) {
  // Interpolation by its normal equations, whose band is as narrow.
  const VectorXd points = space.along.interpolation_points();
  const Eigen::Index count = points.size(), functions = space.along.degree() + 1;
  const int shared = std::min(shape.space.modes(), space.modes());
  BandMatrix normal(static_cast<int>(count), space.along.degree());
  MatrixXd sections = MatrixXd::Zero(count, space.row_size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const AxialBasis::Values basis = space.along.at(points[i]);
    const VectorXd values = basis.values.row(0).transpose();
    normal.add(basis.first, basis.first, values * values.transpose());
    const VectorXd section = section_at(shape, points[i], 0);
    for (int k = 0; k < 3; ++k)
      sections.middleRows(basis.first, functions).middleCols(k * space.modes(), shared) +=
          values * section.segment(k * shape.space.modes(), shared).transpose();
  }
  normal.factorise();
  normal.solve(sections);
  return {space, sections.transpose()};
}

Mat3 surface_frame(const SurfaceJet& jet) {
  Mat3 frame;
  frame.col(0) = jet.col(1).cross(jet.col(0)).normalized();
  frame.col(1) = jet.col(1).normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

}  // namespace vasorod
