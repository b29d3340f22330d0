// The stress of a wall given by harmonics as it was seen, as in coupled/scan_displacement.h. Each
// space has its own, as each has its own shape at rest.
#pragma once

#include <functional>
#include <optional>

#include "sections/section_system.h"

namespace vasorod {

struct SeenSections {
  Eigen::MatrixXd displacement;  ///< in coefficients
  std::optional<int> steps;      ///< as in ScanDisplacement
};

/// The displacement under the pressure of the scan and the axial prestretch, of which the wall at
/// rest is in equilibrium with both: linear where its strain (SectionEnergy::rms_prestrain) is at
/// most `largest_linear`, else from the shape without stress, if that is found. All freedoms of
/// `ends` are held at rest. Throws InputError if nothing holds the wall; `name` begins its
/// sentence.
SeenSections seen_sections(const SectionWall& wall, const HeldEnds& ends, double scan_pressure,
                           double axial_prestretch, const std::string& name, double largest_linear,
                           const std::function<bool()>& stop = {});

/// Gives a system of the wall that stress.
void give_prestress(const SeenSections& seen, double axial_prestretch, SectionSystem& system);

}  // namespace vasorod
