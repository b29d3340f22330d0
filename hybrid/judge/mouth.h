// The mouth of an operation: the opening inside the seam, through which the vein drains.
#pragma once

#include <array>
#include <vector>

#include <vasorod/result.h>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Measures the mouth on the solved walls of the vein (`vein_now`) and the recipient
/// (`recipient_now`), one row per vertex. `pairs`: {vertex of the vein, vertex of the recipient},
/// in order around the seam. The mouth's curve runs midway between the two vertices of each pair;
/// areas and widths are those of its projection along its area vector. All numbers are of the
/// vein's mid-wall, but for the lumen (half the vein's thickness further inwards). The vein's lumen
/// at rest, to which the mouth's is compared, is that across `axis`, the vein's axis at its cut
/// end, also where the cut is oblique. Of two vessels joined end to end, the vein is the narrower.
MouthReport measure_mouth(const PreparedVessel& vein, const Points& vein_now,
                          const Points& recipient_now, const std::vector<std::array<int, 2>>& pairs,
                          const Vec3& axis);

/// Counts the mouth among the vein's sections, and warns of a lumen ratio below 0.6 (a strong
/// warning below 0.4). These two thresholds are conventions of this program: no measured ones are
/// known.
void judge_mouth(const std::string& vein, const MouthReport& mouth, VesselMetrics& metrics,
                 Validity& validity);

/// The recipient's rod elements over the incision, one flag per element: there the section is open,
/// and what happens to it is told by the mouth.
std::vector<char> opened_elements(const PreparedVessel& recipient,
                                  const std::vector<std::array<int, 2>>& pairs);

}  // namespace vasorod
