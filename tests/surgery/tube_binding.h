// Exact rod coordinates of the vertices of a noisy_tube, independent of the fitting and binding
// code.
#pragma once

#include "geometry/noisy_tube.h"
#include "rod/binding.h"

namespace vasorod::testing {

/// One element along the tube's axis.
inline RodTree tube_rod(const TubeShape& shape) {
  RodTree rod;
  rod.rest = {tube_frame(shape, 0), tube_frame(shape, shape.length)};
  RodElement element;
  element.second = 1;
  element.length = shape.length;
  rod.elements = {element};
  rod.branches = {{"tube", {0, 1}, {0}, -1}};
  return rod;
}

inline Binding tube_binding(const TubeShape& shape, const Points& points) {
  Binding binding;
  for (int v = 0; v < points.rows(); ++v) {
    const Vec3 p = points.row(v);
    RodCoordinates c;
    if (shape.bend == 0) {
      c.s = p.z();
      c.local = {p.x(), p.y(), 0};
    } else {
      const double arc = shape.length / shape.bend;
      c.s = arc * std::atan2(p.z(), arc - p.x());
      c.local = {arc - std::hypot(arc - p.x(), p.z()), p.y(), 0};
    }
    binding.push_back(c);
  }
  return binding;
}

}  // namespace vasorod::testing
