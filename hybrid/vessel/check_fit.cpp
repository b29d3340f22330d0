#include "vessel/check_fit.h"

#include <algorithm>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "rod/rod_search.h"

namespace vasorod {
namespace {

// Beyond this share of the radius of curvature, the fit's own error may move a section to its
// centre of curvature.
constexpr double largest_bend = 0.95;
// What is shorter than this share of its radius is a rim and no vessel; where its sections lie is
// rounding.
constexpr double shortest = 0.01;

// "12.5 along the axis, near (0, 0, 12.5)"
std::string place(const RodTree& rod, int node) {
  std::vector<double> s(rod.rest.size(), 0);
  for (const RodElement& e : rod.elements)
    s[static_cast<size_t>(e.second)] = s[static_cast<size_t>(e.first)] + e.length;
  return number_text(s[static_cast<size_t>(node)]) + " along the axis, near " +
         place_text(rod.rest[static_cast<size_t>(node)].position);
}

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  throw InputError(joined_text(parts...));
}

}  // namespace

void check_inside(const RodTree& rod, const TriangleSurface& surface,
                  const std::function<bool(const Vec3&)>& beside_fork) {
  for (const Pose& pose : rod.rest)
    if (!pose.position.allFinite())
      refuse("found no axis through the surface's sections, expected a tubular vessel");
  const ClosestPoint wall(surface);
  for (size_t n = 0; n < rod.rest.size(); ++n) {
    const ClosestPoint::Hit hit = wall.query(rod.rest[n].position);
    if (hit.on_boundary || hit.signed_distance < 0)
      continue;  // beside the rim of an end, inside and outside are not defined
    if (beside_fork(rod.rest[n].position))
      refuse(place(rod, static_cast<int>(n)), ": found the axis ", hit.signed_distance,
             " outside the surface beside a fork, which leaves no closed sections there, expected "
             "branches longer than the fork is wide: a surface with more of them, or one whose "
             "first points are those of another end");
    refuse(place(rod, static_cast<int>(n)), ": found the axis ", hit.signed_distance,
           " outside the surface, expected a tubular vessel whose sections hold their own centre");
  }
}

void check_length(const RodTree& rod) {
  double length = 0;
  for (const RodElement& element : rod.elements) length += element.length;
  if (length < shortest * *std::max_element(rod.radius.begin(), rod.radius.end()))
    refuse("found no axis through the surface's sections, expected a tubular vessel");
}

void check_bend(const RodTree& rod) {
  const RodSearch search(rod);
  for (size_t k = 0; k < rod.elements.size(); ++k) {
    const RodElement& e = rod.elements[k];
    if (search.at_fork(static_cast<int>(k))) continue;  // the axis turns into the branch there
    const double radius = std::max(rod.radius[static_cast<size_t>(e.first)],
                                   rod.radius[static_cast<size_t>(e.second)]);
    const double curvature = e.rest_strain.segment<2>(3).norm();
    if (radius * curvature > largest_bend)
      refuse(
          place(rod, e.first), ": found an axis that turns on a radius of ", 1 / curvature,
          " where the vessel's own radius is ", radius,
          ", so that sections reach the centre of curvature, expected a vessel bent less sharply");
  }
}

void check_thickness(const RodTree& rod, const std::vector<double>& thickness) {
  for (size_t n = 0; n < rod.rest.size(); ++n)
    if (thickness[n] > rod.radius[n])
      refuse(place(rod, static_cast<int>(n)), ": found a wall ", thickness[n],
             " thick where the mid-wall radius is ", rod.radius[n],
             ", expected a wall thinner than the radius");
}

}  // namespace vasorod
