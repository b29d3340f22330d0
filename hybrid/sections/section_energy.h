// The elastic energy of a vessel's wall as a function of the coefficients of its surface
// (section_shape.h), by Gauss points along each span and equally spaced points around.
//
// Gradient and Hessian are summed factor by factor: around the section first, then along the span,
// as products of dense matrices.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sections/block_band.h"
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

  /// Returns the energy (force * length) at these coefficients and writes its gradient, of the same
  /// size. `size`: the length of the gradients of all points, which nearly cancel at a minimum.
  double gradient(const Eigen::MatrixXd& coefficients, Eigen::MatrixXd& gradient,
                  double& size) const;
  /// The Hessian; blocks of SectionSpace::row_size(). `stress_share`: as in WallPoint::energy.
  void hessian(const Eigen::MatrixXd& coefficients, BlockBand& hessian,
               double stress_share = 1) const;
  BlockBand empty_hessian() const;

  /// Energies and extremes of the strain in one state.
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
    std::vector<WallPoint> points;  // around
  };
  /// As many as the degree: measured, one more changes no digit that counts.
  int stations_per_span() const { return space_.along.degree(); }
  struct Jets;
  Jets jets(const Eigen::MatrixXd& coefficients, const Station& station) const;

  SectionSpace space_;
  SectionShape rest_;
  std::vector<Station> stations_;          // stations_per_span() for each span
  std::array<Eigen::MatrixXd, 3> around_;  // points x modes, by derivative
  // Per pair of orders along (00, 01, 02, 11, 12, 22) the products of two harmonics at all points:
  // modes^2 x (pairs of the jet's vectors * points).
  std::array<Eigen::MatrixXd, 6> products_;
};

}  // namespace vasorod
