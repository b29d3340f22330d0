// The stress of a vessel's wall as it was seen: the first step of the modified updated Lagrangian
// formulation (Gee, Foerster and Wall, Int. J. Numer. Meth. Biomed. Engng. 26, 2010) in the
// additive form of Hsu and Bazilevs (Finite Elem. Anal. Des. 47, 2011).
//
// The linear displacement u of the wall without stress, its ends held, balances the pressure of the
// scan and the axial stretch: K u = f. With the stress s = C : e(u) of VesselModel::set_prestress,
// the forces of s are f: the wall is in equilibrium as it was seen, without iteration.
//
// Beyond small strains u leads from the shape without stress instead (Bols et al., J. Comput. Appl.
// Math. 246, 2013): it is changed by K^-1 times what is out of balance, accelerated, until the wall
// of that shape is in equilibrium where it was seen.
#pragma once

#include <optional>

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

struct SeenDisplacement {
  Eigen::VectorXd u;   ///< per degree of freedom
  double largest = 0;  ///< length of the largest at a node
  /// In which the shape without stress was found; 0: it was not; empty: it was not looked for.
  std::optional<int> steps;
};

/// The same in a result.
struct SeenShare {
  double largest = 0;  ///< over the vessel's radius
  std::optional<int> steps;
};

/// The displacement of a vessel as it was seen: linear if its strain (VesselModel::rms_prestrain)
/// is at most `largest_linear`, else from the shape without stress, if that is found. `supports`:
/// of the intact vessel; all its sections are held, their motions and loads are ignored. Prescribed
/// values are those of u. The model is left without a pressure, for give_prestress().
SeenDisplacement seen_displacement(VesselModel& intact, const SeenState& seen, Supports supports,
                                   double largest_linear, const Processes& processes);

/// Gives a model, of the same mesh or one that `u` was carried to, the stress of the displacement.
/// Throws InputError if the shape without stress is turned inside out.
void give_prestress(VesselModel& model, const SeenState& seen, const SeenDisplacement& found,
                    const Processes& processes);

}  // namespace vasorod::fem
