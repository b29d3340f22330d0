// The stress of a wall given by harmonics as it was seen: that of a linear displacement, as of
// wall/wall_prestress.cpp. Each space has its own, as each has its own shape at rest.
#pragma once

#include "sections/section_system.h"

namespace vasorod {

/// The linear displacement, in coefficients, under the pressure of the scan and the axial
/// prestretch, without prestress. All freedoms of `ends` are held at rest. For
/// SectionEnergy::set_prestress: with it the wall at rest is in equilibrium with both. Throws
/// InputError if nothing holds the wall; `name` begins its sentence.
Eigen::MatrixXd scan_displacement(const SectionWall& wall, HeldEnds ends, double scan_pressure,
                                  double axial_prestretch, const std::string& name);

}  // namespace vasorod
