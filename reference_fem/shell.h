// Seven-parameter shell on the mid-surface (Bischoff and Ramm 1997; Gfrerer and Schanz 2019):
// displacement u, director difference w and linear thickness strain beta, each FE_Q(p), with the
// same three-dimensional laws as the solid.
//
//   x(zeta) = R + u + zeta (D + w),  dx/dzeta = (1 + zeta beta) (D + w),  zeta in [-t/2, t/2]
//   G = P + zeta grad D + D n^T
//   F = [P + grad u + zeta (grad D + grad w) + (1 + zeta beta) (D + w) n^T] G^-1
//
// P is the projector onto the surface, n its normal, grad the surface gradient,
// dV = det G dzeta dA. No parameter is a rotation, so a rigid section is plain data for u and w.
#pragma once

#include <functional>

#include "reference_fem/mesh.h"
#include "reference_fem/solid.h"
#include "reference_fem/vessel_model.h"

namespace vasorod::fem {

/// Wall properties as functions of the surface's parameters.
struct ShellBody {
  std::function<Vec3(const Vec3&)> director;     ///< D: unit, from inside to outside
  std::function<double(const Vec3&)> thickness;  ///< along D, length
  Axes axes;                                     ///< local material axes, third the fibre
};

class Shell final : public VesselModel {
 public:
  /// Through-thickness Gauss points, 2, 3 or 5: 2 integrate S = C : E; other laws need 3, and 5 in
  /// folds as sharp as the wall is thick.
  Shell(Mesh mesh, const MaterialLaw& law, const ShellBody& body, int depth_points);

  const Mesh& mesh() const override { return mesh_; }
  const Points& directors() const { return directors_; }  ///< per node
  int node_count() const override { return mesh_.node_count(); }
  int components() const override { return 7; }  ///< u, w (director difference), beta (1/length)
  int cell_count() const override { return mesh_.cell_count(); }
  int owner(int cell) const override { return mesh_.owner[static_cast<std::size_t>(cell)]; }
  void set_pressure(const LumenPressure& pressure) override { pressure_ = pressure; }
  bool symmetric() const override { return pressure_.scan == 0 && pressure_.after == 0; }
  std::vector<int> dofs(int cell) const override;
  bool evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                CellTerms& terms) const override;

 private:
  /// The parameters of a cell's nodes and their directors at rest, a row each.
  struct NodeValues {
    Eigen::MatrixX3d u, w, D;
    Eigen::VectorXd beta;
  };
  NodeValues values_of(std::size_t cell, const DofValues& u) const;
  void press(int cell, const DofValues& u, double load, bool want_tangent, CellTerms& terms) const;
  const MaterialLaw& law() const override { return law_; }
  std::vector<LocalGradient> local_gradients(std::size_t cell, const DofValues& u) const override;
  CellPrestress prestress_of(std::size_t cell, double axial_stretch,
                             const DofValues& u) const override;

  struct Point {
    double zeta = 0, weight = 0;  ///< weight: volume
    Mat3 pull;                    ///< G^-1 Q, Q the local axes
    Mat3 axes;                    ///< Q
  };
  Mesh mesh_;
  MaterialLaw law_;
  int depth_points_;
  Points directors_;
  LumenPressure pressure_;
  std::vector<Eigen::VectorXd> thickness_;  ///< per cell and surface point, length
  std::vector<std::vector<Point>> points_;  ///< per cell: depth_points_ per surface point
};

}  // namespace vasorod::fem
