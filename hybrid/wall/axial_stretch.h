// A stretch of the wall along its fibre.
#pragma once

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// The strain (11, 22, 2*12) of a wall stretched along its fibre, and free to contract across it.
Vec3 strain_of_stretch(const Material& material, double stretch);

/// The stretches along the fibre and across it of that wall by its law, large too: that strain by
/// `biot`; across k^-n by the others, with n the contraction of a small strain, which is exact of
/// an incompressible wall.
Vec2 stretches_along_and_across(const Material& material, double stretch);

}  // namespace vasorod
