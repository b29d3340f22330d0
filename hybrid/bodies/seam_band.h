// The band along a seam in which contact with another wall counts less, because the two walls are
// meant to meet there.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Marks the vertices within two edges of a seam vertex, and those whose shortest edge path to a
/// seam vertex is at most `width` plus two mean edges (length). `seam` lists vertices of `surface`.
/// Returns one entry per vertex.
std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width);

/// The share of a wall's thickness that contact with the other wall of its seam counts: the path to
/// the seam over the width of that band, 1 beyond it. So the walls may meet at the seam, at an
/// angle that grows with their thickness, and not pass through each other beside it. 0 at the seam
/// and up to `edges` edges from it, where contact is left out.
std::vector<double> seam_share(const TriangleSurface& surface, const std::vector<int>& seam,
                               double width, int edges = 1);

}  // namespace vasorod
