// A wall of a law for large strains: the energy of a triangle as a function of its six strains,
// integrated through the thickness.
//
// U = I + e is the stretch of the given surface and b = b0 + c its second fundamental form, pulled
// back to rest. A fibre at height z has the gradient (Kirchhoff and Love)
//
//   F(z) = (U + z U^-1 b) Z^-1 = I + (e + z U^-1 (c - e b0)) Z^-1,   Z = I + z b0
//
// For small strains its symmetric part is the strain of wall_section.h. The stretch across the wall
// enters through plane stress, not through z: a wall that thins keeps its lever arms. (Bent to a
// radius of its thickness, an incompressible strip has 13 % more energy than in Rivlin's solution.)
//
// What triangle_stiffness.h corrects in the stiffness K of the linear wall (arcs, shear across the
// thickness, softness of the triangle) is here a linear map from y to (e, c), so that the Hessian
// at rest is K.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// One triangle. All lengths in one unit, all stresses in one unit.
struct LargeStrainWall {
  double inner = 0, outer = 0;    ///< heights of its faces over the given surface, outward positive
  Vec3 curvature = Vec3::Zero();  ///< b0 (11, 22, 12), 1/length
  double shear = 0;               ///< mu, stress
  double poisson = 0;             ///< nu
  Mat6 strains = Mat6::Identity();  ///< (e11, e22, 2 e12, c11, c22, 2 c12) from y
  double area = 0;                  ///< of the piece of wall, length^2
};

/// The energy of the neo-Hookean law (force * length) with its derivatives with respect to y.
struct LargeStrainEnergy {
  double value = 0;
  Vec6 stress = Vec6::Zero();
  Mat6 tangent = Mat6::Zero();  ///< only if requested
};

LargeStrainEnergy large_strain_energy(const LargeStrainWall& wall, const Vec6& y,
                                      bool with_tangent);

/// Least and largest principal stretch of the wall's two faces.
struct FaceStretches {
  double least = 1, largest = 1;
};

/// `strain`: Biot's strain of the given surface (11, 22, 2*12); `bend`: the change of its second
/// fundamental form, same order; `curvature`: b0 (11, 22, 12).
FaceStretches face_stretches(double inner, double outer, const Vec3& curvature, const Vec3& strain,
                             const Vec3& bend);

}  // namespace vasorod
