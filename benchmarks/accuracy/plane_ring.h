// A tube in plane strain as a ring.
#pragma once

#include "accuracy/held_tube.h"

namespace vasorod::bench {

/// Energy under the radial load p cos 2 theta with free rims, over the thin ring's
/// p^2 R^5 pi L / (18 D). For tubes straight at rest.
double ring_energy(const HeldTube& tube);

}  // namespace vasorod::bench
