// Prevents locking of nearly incompressible cells. The volumetric energy U is a function of the L2
// projection of J = det F on each cell's complete polynomials of degree p - 1:
//
//   W = int W_iso(F) + U(J'),  J' = psi^T M^-1 int psi J,  M = int psi psi^T
//
// This is the three-field (u, p, J) principle of Simo, Taylor and Pister (1985) with discontinuous
// pressure and volume ratio, Q_p / P_(p-1), eliminated in each cell: stable and without additional
// unknowns. For p = 1 it is the mean dilatation.
// unknown. For p = 1 it is the mean dilatation.
#pragma once

#include "reference_fem/law.h"
#include "reference_fem/mesh.h"

namespace vasorod::fem {

/// The projection on one mesh.
class VolumeProjection {
 public:
  explicit VolumeProjection(const Mesh& mesh);

  /// Energy and derivatives of one cell.
  struct Terms {
    double energy = 0;         ///< int U(J')
    Eigen::VectorXd pressure;  ///< per point: the projection of U'(J'), conjugate to J; stress
    /// d(moments of p) / d(moments of J), in terms of psi: M^-1 (int U'' psi psi) M^-1.
    Eigen::MatrixXd curvature;
  };
  /// `weights` and `J` per point of a cell.
  Terms evaluate(const Eigen::VectorXd& weights, const Eigen::VectorXd& J,
                 const MaterialLaw& law) const;
  const Eigen::MatrixXd& basis() const { return basis_; }  ///< points x polynomials

 private:
  Eigen::MatrixXd basis_;
};

}  // namespace vasorod::fem
