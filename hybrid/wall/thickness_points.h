// Gauss points through the thickness of a wall.
#pragma once

#include <array>
#include <cstddef>

namespace vasorod {

inline constexpr size_t thickness_point_count = 5;

/// On [-1, 1]: five points integrate the thin wall exactly, and 1/Z to 1e-6 at t/R = 0.5.
inline constexpr std::array<double, thickness_point_count> thickness_abscissa{
    0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
inline constexpr std::array<double, thickness_point_count> thickness_weight{
    0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
    0.2369268850561891};

}  // namespace vasorod
