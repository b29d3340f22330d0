// Keeps nearly incompressible cells from locking. The volumetric energy U is a function not of J =
// det F but of its L2 projection on each cell's complete polynomials of degree p - 1:
//
//   W = int W_iso(F) + U(J'),  J' = psi^T M^-1 int psi J,  M = int psi psi^T
//
// which is the three-field (u, p, J) principle of Simo, Taylor and Pister (1985) with discontinuous
// pressure and volume ratio, Q_p / P_(p-1), eliminated in each cell: stable, and without a further
// unknown. For p = 1 it is the mean dilatation.
#pragma once

#include "reference_fem/law.h"
#include "reference_fem/mesh.h"

namespace vasorod::fem {

class VolumeProjection {
 public:
  explicit VolumeProjection(const Mesh& mesh);

  struct Terms {
    double energy = 0;         ///< int U(J')
    Eigen::VectorXd pressure;  ///< per point: the projection of U'(J'), conjugate to J; stress
    Eigen::MatrixXd
        curvature;  ///< d(moments of p) / d(moments of J), against psi: M^-1 (int U'' psi psi) M^-1
  };
  /// `weights` and `J` per point of a cell.
  Terms evaluate(const Eigen::VectorXd& weights, const Eigen::VectorXd& J,
                 const MaterialLaw& law) const;
  const Eigen::MatrixXd& basis() const { return basis_; }  ///< points x polynomials

 private:
  Eigen::MatrixXd basis_;
};

}  // namespace vasorod::fem
