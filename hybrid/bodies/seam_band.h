// The band beside a seam that is left out of contact: there the two walls are meant to meet.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Marks the vertices within two edges of a seam vertex, and those whose shortest way along edges
/// to one is at most `width` plus two mean edges (length unit). `seam` lists vertices of `surface`.
std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width);

}  // namespace vasorod
