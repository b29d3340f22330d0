// One picture of a result, from a chosen side and in chosen colours: for figures, and for results
// that are to be seen side by side.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/result.h>

namespace vasorod {

struct DrawOptions {
  std::string colour = "vessel";  ///< each vessel its own colour, or the name of a field
  /// Values of the first and the last colour, pressures in the scene's unit of stress; empty: the
  /// range of the report's picture of this result.
  std::optional<std::array<double, 2>> range;
  std::vector<std::string> only;  ///< names of the vessels to draw; empty: all. One alone is solid.
  std::optional<Vec3> from, up;   ///< towards the eye; what is up; empty: as in the report
  std::optional<Vec3> centre;     ///< what is in the middle, length; empty: everything fits
  std::optional<double> height;   ///< of what is visible at the centre, length; with `centre`
  std::vector<Vec3> marks;        ///< places that a small red ball marks, length
  int stripes = 0;        ///< along each vessel, as if painted at rest; with the colour vessel only
  bool rest = false,      ///< the shape at rest in place of the result
      mesh = false,       ///< the edges of the triangles
      rod = false,        ///< transparent walls, the rods and their directors inside
      lettering = false;  ///< names, a scale bar and, where the space is known, the patient's axes
  std::array<int, 2> size{760, 540};  ///< width and height, pixels
};

/// The names that `DrawOptions::colour` may have.
std::vector<std::string> drawable_colours();

/// The picture as the bytes of a PNG file. Throws InputError (one sentence) where a vessel or a
/// field is asked for that the result has not, or a direction is none.
std::string draw_result(const Result& result, const DrawOptions& options = {});

}  // namespace vasorod
