// Pairs of neighbouring triangles that share one shear strain.
//
// A linear triangle bent in its own plane shears although the wall does not (parasitic shear, of
// order h): where the shear modulus is far above Young's that locks bending. The mean over two
// triangles that make a parallelogram is free of it to second order, as in selective reduced
// integration (Hughes 2000, 4.4). A triangle has at most one partner.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Per triangle its partner, or -1. Among neighbours the nearest to a parallelogram goes first, but
/// none is left alone that has one free neighbour (Karp and Sipser 1981).
std::vector<int> shear_pairs(const TriangleSurface& surface);

}  // namespace vasorod
