// The mouth of a join: the opening inside its seam. The same quantities as `vasorod` reports,
// measured independently.
#pragma once

#include <vasorod/result.h>

namespace vasorod::fem {

/// `seam`: the closed curve of the seam; `rest`: the vein's rim before the join, length. Area, span
/// and width are those of the projection along the curve's area vector. `thickness`: of the vein's
/// wall; the lumen is the area moved inwards by half of it.
MouthReport mouth_of(const Points& seam, const Points& rest, double thickness);

}  // namespace vasorod::fem
