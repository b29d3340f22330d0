#include "surgery/pick_place.h"

#include <Eigen/Geometry>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "rod/binding.h"
#include "vessel/end_conditions.h"

namespace vasorod {
namespace {

void put_on_axis(const Vessel& vessel, const AxisPlace& at, PickPlace& place) {
  place.at = at;
  place.section = frame_at(vessel.rod, vessel.rod.rest, at.element, at.s);
  place.radius = vessel.rod.radius[index(vessel.rod.elements[index(at.element)].first)];
}

// x and y change sign between LPS and RAS.
Vec3 in_other_space(const Vec3& point) {
  return {-point.x(), -point.y(), point.z()};
}

// A picked point may lie up to one radius off its vessel's surface, and with `inside` anywhere in
// the vessel: from the axis to an outer surface it is half the wall more than the radius.
PickPlace place_point(const std::string& where, const PickSpec& pick, const PreparedVessel& vessel,
                      const AxisRoute& route, bool inside) {
  const std::string& space = vessel.loaded.space;
  const bool other = !pick.space.empty() && !space.empty() && pick.space != space;
  PickPlace place;
  place.point = other ? in_other_space(pick.point) : pick.point;
  const RodCoordinates at = project(vessel.vessel.rod, place.point);
  put_on_axis(vessel.vessel, {at.element, at.s}, place);
  place.angle = std::atan2(at.local.y(), at.local.x());
  if (const auto distance = route.distance_to(place.at))
    place.fraction = *distance / route.length();

  const ClosestPoint::Hit hit = closest_on(vessel.vessel.surface, place.point);
  const double off = (hit.point - place.point).norm();
  const auto on_vessel = [&](const Vec3& point) {
    return (closest_on(vessel.vessel.surface, point).point - point).norm() <= place.radius ||
           (inside && project(vessel.vessel.rod, point).local.norm() <= place.radius);
  };
  if (on_vessel(place.point)) return place;
  std::string hint;
  if (!pick.space.empty() && space.empty()) {
    if (on_vessel(in_other_space(place.point)))
      hint = "; with x and y negated it lies on it: the file of " + vessel.spec.name +
             " names no SPACE, and its points are not in " + pick.space;
  }
  throw InputError(joined_text(where, ": found a point ", place_text(place.point), " that is ", off,
                               " off vessel ", vessel.spec.name,
                               ", expected at most its radius there, ", place.radius,
                               "; the nearest point on it is ", place_text(hit.point, 4), hint));
}

PickPlace place_along(const PickSpec& pick, const Vessel& vessel, const AxisRoute& route) {
  PickPlace place;
  put_on_axis(vessel, route.at(*pick.along * route.length()), place);
  place.point = place.section.position;
  place.fraction = *pick.along;
  return place;
}

}  // namespace

RouteEnds pick_ends(const std::string& where, const PickSpec& pick, const Vessel& vessel,
                    int first) {
  const int from = pick.from ? find_end(vessel, *pick.from, where + ": from") : first;
  const int to = pick.to ? find_end(vessel, *pick.to, where + ": to") : farthest_end(vessel, from);
  if (from == to)
    throw InputError(where + ": found one end of the vessel, at " +
                     place_text(vessel.ends[index(from)].center, 4) +
                     ", as both ends of the way along it, expected two");
  return {from, to};
}

AxisRoute pick_route(const std::string& where, const PickSpec& pick, const Vessel& vessel,
                     int first) {
  return {vessel, pick_ends(where, pick, vessel, first)};
}

PickPlace place_cut(const std::string& where, const PickSpec& pick, const PreparedVessel& vessel,
                    int kept) {
  const AxisRoute route = pick_route(where, pick, vessel.vessel, kept);
  return pick.along ? place_along(pick, vessel.vessel, route)
                    : place_point(where, pick, vessel, route, true);
}

PickPlace place_incision_pick(const std::string& where, const PickSpec& pick,
                              const PreparedVessel& vessel) {
  const AxisRoute route = pick_route(where, pick, vessel.vessel, 0);
  if (!pick.along) return place_point(where, pick, vessel, route, false);
  PickPlace place = place_along(pick, vessel.vessel, route);
  place.angle = pick.around_deg * (M_PI / 180);
  const auto point = wall_point(RayHits(vessel.vessel.surface), place.section, place.angle);
  if (!point)
    throw InputError(joined_text(
        where, ": found along: ", *pick.along, ", around_deg: ", pick.around_deg, ", where vessel ",
        vessel.spec.name, " has no wall, expected a place farther from its open ends"));
  place.point = *point;
  return place;
}

std::optional<Vec3> wall_point(const RayHits& wall, const Pose& section, double angle) {
  const Vec3 ray = std::cos(angle) * section.director(1) + std::sin(angle) * section.director(2);
  const auto hits = wall.along(section.position, ray);
  if (hits.empty() || !hits.front().leaves) return std::nullopt;
  return Vec3(section.position + hits.front().distance * ray);
}

std::optional<MovedPick> moved_pick(const Vessel& vessel, const PickPlace& pick,
                                    const AxisRoute& route, double reach,
                                    const std::function<bool(const Vec3&)>& fits) {
  const auto from = route.distance_to(pick.at);
  if (!from) return std::nullopt;
  const RayHits wall(vessel.surface);
  constexpr int steps = 10;
  for (int step = 1; step <= steps; ++step)
    for (const int sense : {1, -1}) {
      const double to = *from + sense * reach * step / steps;
      if (to < 0 || to > route.length()) continue;
      const AxisPlace at = route.at(to);
      const auto point =
          wall_point(wall, frame_at(vessel.rod, vessel.rod.rest, at.element, at.s), pick.angle);
      if (point && fits(*point))
        return MovedPick{*point, std::abs(to - *from), to / route.length()};
    }
  return std::nullopt;
}

}  // namespace vasorod
