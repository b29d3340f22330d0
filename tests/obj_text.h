// A surface as the text of an OBJ file, one of the formats that are read, with all digits.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

#include "geometry/triangle_surface.h"

namespace vasorod::testing {

inline std::string obj_text(const TriangleSurface& surface) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
    text << "v " << surface.points(i, 0) << ' ' << surface.points(i, 1) << ' '
         << surface.points(i, 2) << '\n';
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t)
    text << "f " << surface.triangles(t, 0) + 1 << ' ' << surface.triangles(t, 1) + 1 << ' '
         << surface.triangles(t, 2) + 1 << '\n';
  return text.str();
}

}  // namespace vasorod::testing
