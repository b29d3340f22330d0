// The elastic energy of a vessel's wall as a function of the coefficients of its surface
// (section_shape.h), by Gauss points along each span and equally spaced points around; and that of
// a pressure p in its lumen, -p V, with the volume V between the lids over its ends
// (lumen_point.h, section_lid.h). The sums around are exact for V, those along for the area of the
// surface, so that V does not depend on the origin.
//
// Gradient and Hessian are summed factor by factor: around the section first, then along the span,
// as products of dense matrices.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sections/block_band.h"
#include "sections/lumen_point.h"
#include "sections/section_lid.h"
#include "sections/wall_point.h"

namespace vasorod {

/// A wall at rest, as a surface of two parameters.
struct SectionWall {
  SectionShape rest;                        ///< the given surface
  std::function<double(double)> thickness;  ///< at u, length
  double mid_offset = 0;                    ///< from the given surface outward to mid-wall
  Material material;
};

/// The energy of one wall.
class SectionEnergy {
 public:
  explicit SectionEnergy(const SectionWall& wall);

  const SectionSpace& space() const { return space_; }
  int unknowns() const { return space_.row_size() * space_.along.count(); }

  /// At rest the wall carries the stress of this linear displacement, in coefficients, and of this
  /// stretch along its axis (wall/wall_energy.h).
  void set_prestress(const Eigen::MatrixXd& displacement, double axial_prestretch);
  /// RMS over the surface of the prestress's strain: WallEnergy::rms_prestrain.
  double rms_prestrain() const;
  /// The wall without stress has the shape at rest less this displacement, and is then shorter by
  /// the stretch along its axis: WallInput::from_stress_free_shape.
  void set_stress_free_shape(const Eigen::MatrixXd& displacement, double axial_prestretch);
  /// In the lumen, stress; at first 0.
  void set_pressure(double pressure);
  double pressure() const { return pressure_; }
  /// From the given surface inwards to the inner face at rest, length.
  double depth(double u) const { return wall_.thickness(u) / 2 - wall_.mid_offset; }

  /// Returns the energy (force * length) at these coefficients and writes its gradient, of the same
  /// size. `size`: the length of the gradients of all points, which nearly cancel at a minimum.
  double gradient(const Eigen::MatrixXd& coefficients, Eigen::MatrixXd& gradient,
                  double& size) const;
  /// The Hessian; blocks of SectionSpace::row_size(). `stress_share`: as in WallPoint::energy.
  void hessian(const Eigen::MatrixXd& coefficients, BlockBand& hessian,
               double stress_share = 1) const;
  BlockBand empty_hessian() const;

  /// The wall's energies and extremes of its strain in one state.
  struct Report {
    double membrane = 0, bending = 0;
    FaceStretches faces;
    Vec3 least_place = Vec3::Zero(), largest_place = Vec3::Zero();  ///< at rest, length
  };
  Report report(const Eigen::MatrixXd& coefficients) const;

 private:
  struct Station {                  // one Gauss point along
    int first = 0;                  // of its B-splines
    Eigen::MatrixXd basis;          // 3 x degree + 1
    double u = 0, measure = 0;      // du dtheta of a point
    std::vector<WallPoint> points;  // around
    std::vector<LumenPoint> lumen;  // the same, once there is a pressure
  };
  /// As many as the degree: measured, one more changes no digit that counts.
  int stations_per_span() const { return space_.along.degree(); }
  /// Vectors of the jets: those of the wall, and the point itself where there is a pressure.
  int vectors() const { return pressure_ == 0 ? 5 : 6; }
  void set_points(Station& station, const Eigen::MatrixXd& shape, const Vec2& stretch) const;
  void set_products(int vectors);
  void set_lumen();
  struct Jets;
  Jets jets(const Eigen::MatrixXd& coefficients, const Station& station) const;
  std::array<SectionLid, 2> lids() const;

  SectionSpace space_;
  SectionWall wall_;
  double pressure_ = 0;
  std::vector<Station> stations_;          // stations_per_span() for each span
  std::array<Eigen::MatrixXd, 3> around_;  // points x modes, by derivative
  // Per pair of orders along (00, 01, 02, 11, 12, 22) the products of two harmonics at all points:
  // modes^2 x (pairs of the jet's vectors * points). Those with the point itself come last.
  std::array<Eigen::MatrixXd, 6> products_;
};

}  // namespace vasorod
