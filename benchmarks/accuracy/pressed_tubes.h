// Tubes pressed onto other bodies, solved by the coupled minimum, and the accuracy of their
// contact.
#pragma once

#include <optional>

#include <vasorod/types.h>

namespace vasorod::bench {

/// Errors of one contact solution.
struct PressedTubes {
  bool settled = false;  ///< converged and certified
  int vertices = 0;      ///< of the deformable bodies
  Vec3 force = Vec3::Zero();
  double support_misfit = 0;  ///< |supports + contact| over the force; two tubes: of the pair
  double newton_misfit = 0;   ///< |force on a + force on b| over the force
  /// |sum of pressure times area times normal + supports| over the force, if the normals are known.
  std::optional<double> pressure_misfit;
  double penetration = 0;  ///< largest penetration over the mean edge
};

/// A tube R 8, L 60, t 1.2 between rigid ends, pressed by 3 onto a perpendicular rigid cylinder of
/// radius 12. `stiffness`: CoupledOptions::contact_stiffness.
PressedTubes pressed_on_cylinder(int around, double stiffness);

/// How two tubes meet.
enum class Meeting {
  across,                  ///< between rigid ends
  side_by_side,            ///< between ends held in the mean only, which deform
  side_by_side_rigid_ends  ///< the ends overlap; contact beside them is left out
};
/// Two such tubes (the other with t .8), both deformable, pressed by 3 into each other.
PressedTubes two_tubes(Meeting meeting, int around);

/// A short tube (R 8, t .2, L 4) held at its ends' mean positions, pressed onto a plate. For an
/// inextensional motion a_n cos(n theta) the energy is pi/2 (E I / R^3) (n^2 - 1)^2 a_n^2. The
/// contact line therefore moves relative to the ring's mean by
/// P R^3 / (pi E I) sum_{n >= 2} 1 / (n^2 - 1)^2 = P R^3 / (pi E I) (pi^2/12 - 11/16).
struct RingOnPlate {
  bool settled = false;
  int vertices = 0;
  double force = 0, closed_form = 0;
  double pressure_sum = 0;  ///< sum of pressure times area
};
RingOnPlate ring_on_plate(int around, double sink);

}  // namespace vasorod::bench
