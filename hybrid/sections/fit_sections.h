// The surface of a vessel without branches as sections of harmonics: parameters of its vertices,
// and the shape nearest to them.
#pragma once

#include <string>

#include "sections/section_shape.h"
#include "vessel/vessel.h"

namespace vasorod {

/// Parameters of the vertices: u along, 0 and 1 on the rims, and the angle about the axis. At a rim
/// that is not normal to the axis the lines of constant u follow it.
struct SectionParameters {
  Eigen::VectorXd u, angle;
  std::array<int, 2> end{};  ///< index into Vessel::ends of the rims at u = 0 and u = 1
};

/// Throws InputError (a sentence that begins with `where`) if the vessel has branches, or sections
/// that are not star-shaped about its axis.
SectionParameters section_parameters(const Vessel& vessel, const std::string& where);

/// The least-squares fit of a shape to points (n x 3) at these parameters, with just enough
/// smoothing to be unique.
SectionShape fit_sections(const SectionSpace& space, const SectionParameters& at,
                          const Points& points);

/// The points of a shape at the parameters, n x 3.
Points points_of(const SectionShape& shape, const SectionParameters& at);

}  // namespace vasorod
