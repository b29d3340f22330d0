// What the readers take for a number that can be meant.
#pragma once

#include <array>

namespace vasorod {

// The solvers square lengths, cube them and multiply them by stiffness. Within these limits all of
// that stays far inside the range of a double, and nothing beyond them is a vessel in any unit.
constexpr double smallest_length = 1e-9, largest_length = 1e9;
constexpr double smallest_stiffness = 1e-30, largest_stiffness = 1e30;  ///< and stress and load

/// Of a Glenn operation: GlennSpec::incision_length, cuts' tilts in degrees,
/// IncisionEllipse::ratio.
constexpr std::array<double, 2> incision_lengths{0.25, 4}, cut_tilts_deg{-75, 75},
    ellipse_ratios{0.1, 1};

}  // namespace vasorod
