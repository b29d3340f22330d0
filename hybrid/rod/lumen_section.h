// What a pressure in the lumen does to the annular section of a tube, and to the rod made of such
// sections (Haringx 1948). The rod's lumen has the volume V = integral of A v3; pressure and
// Poisson's effect change the section's radius, so that at constant pressure
//
//   dV / dv3 = A0 (1 + e) (1 + e - 2 nu_LT),   e = (p - p_scan) de/dp
//
// docs/rod.md derives this.
#pragma once

#include "rod/section.h"

namespace vasorod {

/// Strain along the circumference at radius r (length) per pressure in the lumen, 1/stress, of a
/// tube whose length is held: Lame's solution in plane strain, with the fibre along the tube.
double hoop_strain_per_pressure(const AnnularSection& section, const Material& material, double r);

/// A section of a vessel seen at one pressure, at another pressure.
struct LumenSection {
  double area = 0;          ///< of the lumen at that pressure, with the length as seen, length^2
  double thrust = 0;        ///< pressure times dV / dv3, force
  double inner_strain = 0,  ///< e: along the inner face's circumference, since the scan
      mid_strain = 0;       ///< the same at mid-wall
};

LumenSection lumen_section(const AnnularSection& section, const Material& material, double scan,
                           double pressure);

/// RodElement::lumen, or an axial stress, of size 1: (0, 0, 1, 0, 0, 0). The first element of a
/// side branch (`at_fork`) turns from the parent's direction into its own; its lumen ends there in
/// a disk across its second node's axis and pushes that node along the axis.
Vec6 unit_thrust(const RodElement& element, bool at_fork);

}  // namespace vasorod
