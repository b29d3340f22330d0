// The stress of a vessel's wall as it was seen: the first step of the modified updated Lagrangian
// formulation (Gee, Foerster and Wall, Int. J. Numer. Meth. Biomed. Engng. 26, 2010) in the
// additive form of Hsu and Bazilevs (Finite Elem. Anal. Des. 47, 2011).
//
// The linear displacement u of the wall without stress, its ends held, balances the pressure of the
// scan and the axial stretch: K u = f. With the stress s = C : e(u) of VesselModel::set_prestress,
// the forces of s are f: the wall is in equilibrium as it was seen, without iteration.
#pragma once

#include "reference_fem/system.h"
#include "reference_fem/vessel_model.h"

namespace vasorod::fem {

/// What a vessel carried when it was seen, and the pressure afterwards; dimensionless.
struct SeenState {
  LumenPressure pressure;
  double axial_stretch = 1;

  bool pressed() const { return pressure.scan != 0 || pressure.after != 0; }
  bool stressed() const { return pressure.scan != 0 || axial_stretch != 1; }
};

/// The displacement u, per degree of freedom, of a vessel as it was seen. `supports`: of the intact
/// vessel; all its sections are held, their motions and loads are ignored. Prescribed values are
/// those of u. The model is left without a pressure and with the stress of the axial stretch alone.
Eigen::VectorXd seen_displacement(VesselModel& intact, const SeenState& seen, Supports supports,
                                  const Processes& processes);

/// The length of its largest displacement at a node.
double largest_displacement(const Eigen::VectorXd& u, int components);

}  // namespace vasorod::fem
