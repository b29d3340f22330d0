#include "reference_fem/volume_projection.h"

#include <Eigen/Cholesky>

namespace vasorod::fem {

VolumeProjection::VolumeProjection(const Mesh& mesh) {
  const int top = mesh.degree - 1;
  const auto points = mesh.unit_points.cols();
  basis_.resize(points, (top + 1) * (top + 2) * (top + 3) / 6);
  // Legendre polynomials of 2 x - 1: M is well conditioned
  const auto legendre = [&](Eigen::Index q, Eigen::Index d, int k) {
    const double t = 2 * mesh.unit_points(d, q) - 1;
    double before = 1, now = t;
    if (k == 0) return 1.0;
    for (int n = 1; n < k; ++n) {
      const double next = ((2 * n + 1) * t * now - n * before) / (n + 1);
      before = now;
      now = next;
    }
    return now;
  };
  for (Eigen::Index q = 0; q < points; ++q) {
    Eigen::Index column = 0;
    for (int i = 0; i <= top; ++i)
      for (int j = 0; i + j <= top; ++j)
        for (int k = 0; i + j + k <= top; ++k)
          basis_(q, column++) = legendre(q, 0, i) * legendre(q, 1, j) * legendre(q, 2, k);
  }
}

VolumeProjection::Terms VolumeProjection::evaluate(const Eigen::VectorXd& weights,
                                                   const Eigen::VectorXd& J,
                                                   const MaterialLaw& law) const {
  const Eigen::MatrixXd weighted = weights.asDiagonal() * basis_;
  const Eigen::LLT<Eigen::MatrixXd> mass(basis_.transpose() * weighted);
  const Eigen::VectorXd projected = basis_ * mass.solve(weighted.transpose() * J);
  Eigen::VectorXd slope(J.size()), curvature(J.size());
  Terms terms;
  for (Eigen::Index q = 0; q < J.size(); ++q) {
    const Volumetric u = law.volumetric(projected[q]);
    terms.energy += weights[q] * u.energy;
    slope[q] = u.slope;
    curvature[q] = u.curvature;
  }
  terms.pressure = basis_ * mass.solve(weighted.transpose() * slope);
  const Eigen::MatrixXd inner = weighted.transpose() * curvature.asDiagonal() * basis_;
  terms.curvature = mass.solve(mass.solve(inner).transpose());
  return terms;
}

}  // namespace vasorod::fem
