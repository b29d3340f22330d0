// Strain of one triangle of a deformed surface.
#pragma once

#include <array>

#include <vasorod/types.h>

namespace vasorod {

/// The largest |lambda - 1| of the triangle's two principal stretches. `corner`: its vertices.
/// Infinite where the triangle has no area at rest.
double triangle_strain(const Points& rest, const Points& current, const std::array<int, 3>& corner);

}  // namespace vasorod
