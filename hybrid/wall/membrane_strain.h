// In-plane strain of a triangle from its right Cauchy-Green tensor C = F^T F (2 x 2), and its
// derivatives.
//
// A symmetric tensor C is stored as (C11, C22, C12), a strain e as (e11, e22, 2 e12).
#pragma once

#include <vasorod/types.h>

#include "wall/plane_stress.h"

namespace vasorod {

/// C of a deformation gradient F.
inline Vec3 metric_of(const Eigen::Matrix<double, 3, 2>& f) {
  return {f.col(0).squaredNorm(), f.col(1).squaredNorm(), f.col(0).dot(f.col(1))};
}

/// A strain and its derivative.
struct MembraneStrain {
  Vec3 strain;      ///< Biot U - I, or (C - I) / 2
  Mat3 derivative;  ///< d strain / d C
};

/// The strain of `law`, Biot's for the neo-Hookean law (large_strain_wall.h); `c` holds
/// (C11, C22, C12).
MembraneStrain membrane_strain(Law law, const Vec3& c);

/// Sum over i of stress_i d^2 strain_i / dC dC, with the stress in the order (11, 22, 12).
Mat3 membrane_strain_hessian(Law law, const Vec3& c, const Vec3& stress);

}  // namespace vasorod
