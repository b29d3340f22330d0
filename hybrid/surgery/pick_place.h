// Where the picks of an operation lie on their vessels.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <vasorod/error.h>
#include <vasorod/scene.h>

#include "geometry/ray_hits.h"
#include "vessel/axis_route.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Adds the place in the scene to the error of a part that does not know the scene.
template <class Work>
auto placed(const std::string& where, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(where + ": " + error.what());
  }
}

/// A pick on its vessel.
struct PickPlace {
  Vec3 point = Vec3::Zero();  ///< the pick in the vessel's space, length unit
  AxisPlace at;               ///< its section
  Pose section;               ///< the section's frame at rest
  double angle = 0;           ///< of `point` about the axis, from d1 towards d2, radians
  double radius = 0;          ///< mid-wall radius there, length unit
  /// Fraction of the axis between the pick's ends `from` and `to`; empty: not on that way.
  std::optional<double> fraction;
};

/// The ends of the way along the axis on which `pick.along` counts: `pick.from` (by default the end
/// `first`) and `pick.to` (by default the farthest end). Throws InputError, which begins with
/// `where`, if these are not two ends.
RouteEnds pick_ends(const std::string& where, const PickSpec& pick, const Vessel& vessel,
                    int first);
/// That way.
AxisRoute pick_route(const std::string& where, const PickSpec& pick, const Vessel& vessel,
                     int first);

/// The place of a cut, `along` counted from the end `kept`: its point is then the middle of the
/// section. A picked point lies in the vessel or up to one radius off its surface. Throws
/// InputError.
PickPlace place_cut(const std::string& where, const PickSpec& pick, const PreparedVessel& vessel,
                    int kept);

/// The place of an incision, `along` counted from `start`: its point is then on the surface.
PickPlace place_incision_pick(const std::string& where, const PickSpec& pick,
                              const PreparedVessel& vessel);

/// The point of the wall that the ray from the section's middle at `angle` (radians, from d1
/// towards d2) leaves through; empty where it leaves through an open end.
std::optional<Vec3> wall_point(const RayHits& wall, const Pose& section, double angle);

/// A pick that was moved along its vessel.
struct MovedPick {
  Vec3 point = Vec3::Zero();  ///< on the surface
  double by = 0,              ///< arc length of the axis, length unit
      fraction = 0;           ///< place on the route over its length
};

/// Moves the pick along the axis at its angle, in steps of a tenth of `reach` and up to `reach`
/// both ways, until `fits(point)`. Empty: it fits nowhere.
std::optional<MovedPick> moved_pick(const Vessel& vessel, const PickPlace& pick,
                                    const AxisRoute& route, double reach,
                                    const std::function<bool(const Vec3&)>& fits);

}  // namespace vasorod
