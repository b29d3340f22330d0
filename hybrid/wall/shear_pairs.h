// Pairs of neighbouring triangles that share one shear strain.
//
// A linear triangle bent in its own plane shears although the wall does not (parasitic shear, of
// order h). Where the shear modulus is far above Young's modulus, bending locks. The mean over two
// triangles that form a parallelogram is free of parasitic shear to second order, as in selective
// reduced integration (Hughes 2000, 4.4). A triangle has at most one partner.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Per triangle its partner, or -1. Neighbours closest to a parallelogram are paired first, except
/// that a triangle with only one free neighbour left is paired immediately (Karp and Sipser 1981).
std::vector<int> shear_pairs(const TriangleSurface& surface);

}  // namespace vasorod
