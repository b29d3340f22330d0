// The band along a seam in which contact is left out, because the two walls are meant to meet
// there.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Marks the vertices within two edges of a seam vertex, and those whose shortest edge path to a
/// seam vertex is at most `width` plus two mean edges (length). `seam` lists vertices of `surface`.
/// Returns one entry per vertex.
std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width);

}  // namespace vasorod
