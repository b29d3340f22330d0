// A model of one vessel's wall: its lumen may be under pressure, and the wall as it was seen may
// carry a stress.
#pragma once

#include <vector>

#include <vasorod/material.h>

#include "reference_fem/law.h"
#include "reference_fem/mesh.h"
#include "reference_fem/model.h"
#include "reference_fem/processes.h"

namespace vasorod::fem {

class VesselModel : public Model {
 public:
  /// The follower pressure on the inner face: `scan` at load 0, `after` at load 1; stress. A solid
  /// needs faces for it (Solid::add_pressure).
  virtual void set_pressure(const LumenPressure& pressure) = 0;
  /// At rest the wall carries the stress s = C : e. The strain e is that of the linear displacement
  /// `u` and of an axial stretch under which the wall is free to contract across its axis. The
  /// energy has s : Y (law.h) in addition, and the constant s : e / 2.
  void set_prestress(double axial_stretch, const DofValues& u) {
    unloading_.clear();
    prestress_.assign(mesh().cell_nodes.size(), {});
    for (std::size_t c = 0; c < prestress_.size(); ++c)
      if (mesh().weights[c].size() > 0)  // no other process evaluates the cell
        prestress_[c] = prestress_of(c, axial_stretch, u);
  }
  /// The wall without stress has the shape at rest displaced by -u, and is then shorter by the
  /// axial stretch: its law is evaluated from there. Returns false, and leaves the wall without a
  /// stress at rest, if that shape is turned inside out somewhere in a cell of this process.
  bool set_stress_free_shape(double axial_stretch, const DofValues& u);
  /// RMS over the wall's volume of the strain e of set_prestress() in the wall's surface,
  /// sqrt(e_22^2 + e_33^2 + 2 e_23^2) in local axes.
  double rms_prestrain(double axial_stretch, const DofValues& u, const Processes& processes) const;
  virtual const Mesh& mesh() const = 0;

 protected:
  /// The stress at rest at each quadrature point of a cell.
  struct CellPrestress {
    Eigen::Matrix<double, 6, Eigen::Dynamic> stress;  ///< local axes
    double stored = 0;                                ///< its energy at rest
  };
  /// Of the displacement at a quadrature point, linear in u, in local axes.
  struct LocalGradient {
    Mat3 value;
    double volume = 0;  ///< of the point
  };
  std::vector<CellPrestress> prestress_;  ///< per cell; empty: none
  /// Per cell and quadrature point: A of from_stress_free_shape(). Empty: the shape at rest.
  std::vector<std::vector<Mat3>> unloading_;

 private:
  virtual const MaterialLaw& law() const = 0;
  /// Per quadrature point of a cell.
  virtual std::vector<LocalGradient> local_gradients(std::size_t cell,
                                                     const DofValues& u) const = 0;
  virtual CellPrestress prestress_of(std::size_t cell, double axial_stretch,
                                     const DofValues& u) const = 0;
};

/// A pressure at a load.
inline double pressure_at(const LumenPressure& pressure, double load) {
  return pressure.scan + load * (pressure.after - pressure.scan);
}

}  // namespace vasorod::fem
