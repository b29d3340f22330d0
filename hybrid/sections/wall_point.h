// The wall at one point of a surface given by two parameters (u, theta): its energy per point as a
// function of the surface's first and second derivatives, after Kirchhoff and Love.
//
// The strains are those of wall_section.h: e of the given surface in the law's measure, from the
// metric a_AB = x_A . x_B, and c = b - b0 from the second fundamental form b_AB = -x_AB . n, both
// pulled back to the frame (fibre, across) of the wall at rest. n points outward; b is positive
// where the wall is convex.
//
// A prestress s adds s . y and a constant, as in wall/triangle_energy.h.
#pragma once

#include <array>
#include <memory>

#include <vasorod/material.h>
#include <vasorod/types.h>

#include "sections/section_shape.h"
#include "wall/large_strain_wall.h"
#include "wall/wall_section.h"

namespace vasorod {

/// The energy at a point as a function of its jet: with its derivatives with respect to the five
/// vectors, in SurfaceJet's order.
struct PointEnergy {
  double membrane = 0, bending = 0;  ///< their sum is the energy
  Eigen::Matrix<double, 3, 5> gradient = Eigen::Matrix<double, 3, 5>::Zero();
  Eigen::Matrix<double, 15, 15> hessian;  ///< only if requested
};

/// The wall at rest at one point, free of stress unless a prestress is set. Lengths in one unit,
/// moduli in one unit.
class WallPoint {
 public:
  /// `jet`: at rest. `fibre`: any length, not normal to the surface. `inner`, `outer`: heights of
  /// the wall's faces over the given surface. `measure`: du dtheta of the point. `stretch`: along
  /// and across the fibre, of `jet` from the state without stress.
  WallPoint(const SurfaceJet& jet, const Vec3& fibre, double inner, double outer, double measure,
            const Material& material, const Vec2& stretch = Vec2::Ones());

  /// At rest the point carries the stress of this linear displacement (of the rest jet, which is
  /// that of the constructor) and of `strain` (11, 22, 2*12).
  void set_prestress(const SurfaceJet& rest, const SurfaceJet& displacement, const Vec3& strain);

  /// `stress_share`: of the Hessian's part that is proportional to the present stress. Without it
  /// (0) the Hessian of a quadratic law has no negative curvature.
  PointEnergy energy(const SurfaceJet& jet, bool with_hessian, double stress_share = 1) const;
  /// The principal stretches of the wall's faces.
  FaceStretches faces(const SurfaceJet& jet) const;
  double area() const { return area_; }                             ///< at rest, of the point
  Vec3 membrane_prestrain() const { return prestrain_.head<3>(); }  ///< 11, 22, 2*12

 private:
  Vec6 strains(const SurfaceJet& jet) const;
  Mat6 strain_slopes(const Mat3& membrane) const;

  Law law_ = Law::biot;
  // From (x_uu', x_tt', x_ut') of a tensor in the parameters to (11, 22, 12) in the frame.
  Mat3 pull_;
  Vec3 bend_;  // b0 (11, 22, 12), 1/length
  double area_ = 0, inner_ = 0, outer_ = 0;
  Vec6 prestrain_ = Vec6::Zero(), prestress_ = Vec6::Zero();  // the stress per area
  Mat6 stiffness_;                                // per area, of the laws that are quadratic
  std::shared_ptr<const LargeStrainWall> large_;  // of the others
};

}  // namespace vasorod
