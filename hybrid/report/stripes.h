// Stripes along a vessel, as if painted on the wall at rest: they show how far it is twisted.
#pragma once

#include <vasorod/result.h>

namespace vasorod {

/// Per vertex 1 on a stripe and 0 beside it, less at its edges; `count` stripes, as wide as the
/// gaps between them. The directions from which they are counted run along the centerline at rest
/// without twist. Empty where the vessel has no surface or no centerline.
Eigen::VectorXd stripes(const VesselResult& vessel, int count);

}  // namespace vasorod
