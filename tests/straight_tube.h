// A generated tube by its four numbers.
#pragma once

#include <vasorod/tube.h>

namespace vasorod::testing {

/// Straight, along z from the origin.
inline TubeSpec straight_tube(double length, double radius, int around, int along) {
  TubeSpec spec;
  spec.length = length;
  spec.radius = radius;
  spec.around = around;
  spec.along = along;
  return spec;
}

}  // namespace vasorod::testing
