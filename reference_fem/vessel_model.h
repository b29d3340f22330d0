// A model of one vessel's wall: its lumen may be under pressure, and the wall as it was seen may
// carry a stress.
#pragma once

#include <vector>

#include <vasorod/material.h>

#include "reference_fem/law.h"
#include "reference_fem/model.h"

namespace vasorod::fem {

class VesselModel : public Model {
 public:
  /// The follower pressure on the inner face: `scan` at load 0, `after` at load 1; stress. A solid
  /// needs faces for it (Solid::add_pressure).
  virtual void set_pressure(const LumenPressure& pressure) = 0;
  /// At rest the wall carries the stress s = C : e. The strain e is that of the linear displacement
  /// `u` and of an axial stretch under which the wall is free to contract across its axis. The
  /// energy has s : Y (law.h) in addition, and the constant s : e / 2.
  virtual void set_prestress(double axial_stretch, const DofValues& u) = 0;
};

/// A pressure at a load.
inline double pressure_at(const LumenPressure& pressure, double load) {
  return pressure.scan + load * (pressure.after - pressure.scan);
}

/// The stress at rest at each quadrature point of a cell.
struct CellPrestress {
  Eigen::Matrix<double, 6, Eigen::Dynamic> stress;  ///< local axes
  double stored = 0;                                ///< its energy at rest
};

}  // namespace vasorod::fem
