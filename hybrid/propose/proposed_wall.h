// What a vessel probably is, by its name, and a wall for it.
#pragma once

#include <string>

namespace vasorod {

/// The vessels that a proposal knows.
enum class VesselKind { superior_vena_cava, pulmonary_artery, aorta, other };

/// By the words of a name, which other characters than letters separate: svc, rpa, aorta...
VesselKind kind_of(const std::string& name);

/// In words, for a reader.
std::string to_string(VesselKind kind);

/// A wall, isotropic.
struct ProposedWall {
  double thickness = 0;  ///< in the unit of the radius, two digits
  double young = 0;      ///< MPa
  double poisson = 0.45;
  std::string source;  ///< where the thickness comes from, "; ", where Young's modulus does
};

/// `radius`: twice the vessel's volume over its area; `millimetres`: mm per unit of it.
ProposedWall propose_wall(VesselKind kind, double radius, double millimetres);

}  // namespace vasorod
