// A stretch of the wall along its fibre.
#pragma once

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// The strain (11, 22, 2*12) of a wall stretched along its fibre, and free to contract across it.
Vec3 strain_of_stretch(const Material& material, double stretch);

}  // namespace vasorod
