// Total Lagrangian solid: FE_Q(p)^3 hexahedra, full Gauss quadrature, any law (for a split law with
// projected volume ratio, volume_projection.h); optional follower pressure on the walls.
#pragma once

#include <functional>
#include <optional>

#include "reference_fem/law.h"
#include "reference_fem/mesh.h"
#include "reference_fem/vessel_model.h"
#include "reference_fem/volume_projection.h"

namespace vasorod::fem {

/// Local material axes (columns, third = fibre) at a point of the parameter cube.
using Axes = std::function<Mat3(const Vec3&)>;

class Solid final : public VesselModel {
 public:
  Solid(Mesh mesh, const MaterialLaw& law, const Axes& axes);
  /// Adds a follower pressure (stress, scaled by the load) on the faces where the parameter in
  /// `direction` is 0 or 1.
  void add_pressure(int direction, int side, double pressure);
  void set_pressure(const LumenPressure& pressure) override;

  const Mesh& mesh() const override { return mesh_; }
  int node_count() const override { return mesh_.node_count(); }
  int components() const override { return 3; }
  int cell_count() const override;
  int owner(int cell) const override;
  std::vector<int> dofs(int cell) const override;
  bool evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                CellTerms& terms) const override;
  bool symmetric() const override;

 private:
  struct Pressure {
    FaceMesh face;
    LumenPressure value;
  };
  void evaluate_face(const Pressure& pressure, const std::vector<int>& nodes, const DofValues& u,
                     double load, CellTerms& terms) const;
  const Pressure* face_cell(int cell, std::size_t& index) const;
  const MaterialLaw& law() const override { return law_; }
  std::vector<LocalGradient> local_gradients(std::size_t cell, const DofValues& u) const override;
  CellPrestress prestress_of(std::size_t cell, double axial_stretch,
                             const DofValues& u) const override;

  Mesh mesh_;
  MaterialLaw law_;
  /// Per cell and point; mesh_.gradient refers to these axes.
  std::vector<std::vector<Mat3>> axes_;
  std::vector<Pressure> pressures_;
  std::optional<VolumeProjection> projection_;  ///< split laws only
};

}  // namespace vasorod::fem
