// The seam of an operation in its two vessels.
#pragma once

#include <string>
#include <vector>

#include <vasorod/result.h>

#include "surgery/join.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// The two vessels as they are now, for a picture.
Stage stage_of(const std::string& title, const PreparedVessel& first, const PreparedVessel& second);

/// The rim's points (n x 3) where a rod with these poses carries them.
Points carried_rim(const PreparedVessel& vessel, const RodPoses& poses,
                   const std::vector<int>& rim);

/// Gives the vessels the seam's surfaces and binds them again.
void sew(const JoinOutcome& seam, PreparedVessel& first, PreparedVessel& second);

}  // namespace vasorod
