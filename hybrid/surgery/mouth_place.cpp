#include "surgery/mouth_place.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "surgery/pose.h"
#include "surgery/vein_rotation.h"

namespace vasorod {

MouthPlace place_mouth(const GlennSpec& spec, const Vec3& incision, const RodPart& kept,
                       RodSide side, const RodConditions& held, double mouth_radius,
                       const TriangleSurface& wall, const Vec3& tangent,
                       const RodOptions& options) {
  const Vec3 outward = outward_normal(wall, incision, mouth_radius);
  Pose mouth = mouth_pose(closest_on(wall, incision).point, outward, tangent, 0,
                          side == RodSide::towards_root);
  const RodTree& rod = kept.tree;
  const Pose& at_rest = rod.rest[index(kept.cut_node)];
  mouth.rotation = Eigen::Quaterniond::FromTwoVectors(at_rest.director(3), mouth.director(3))
                       .toRotationMatrix() *
                   at_rest.rotation;
  VeinRotation rotation(rod, held, kept.cut_node, mouth, outward, options);
  MouthPlace place;
  place.rotation = rotation.find() + spec.rotation_deg.value_or(0) * (M_PI / 180);
  place.vein = rotation.at(place.rotation);
  place.conditions = rotation.conditions_at(place.rotation);
  if (spec.cut_tilt_deg != 0) {
    // About this axis the cut's normal, -outward, turns towards the tangent.
    const Vec3 axis = tangent.cross(outward).normalized();
    mouth.rotation = Eigen::AngleAxisd(place.rotation, outward).toRotationMatrix() * mouth.rotation;
    place.tilt = {spec.cut_tilt_deg, at_rest.rotation * (mouth.rotation.transpose() * axis)};
    // In steps, so that the rod stays on the branch of the straight cut.
    constexpr double step = 15;
    const int steps = static_cast<int>(std::ceil(std::abs(spec.cut_tilt_deg) / step));
    const Pose straight = mouth;
    for (int k = 1; k <= steps; ++k) {
      mouth = tilted_section(straight, {-spec.cut_tilt_deg * k / steps, axis});
      place.conditions = held;
      place.conditions.supports.push_back(clamp_at(rod, kept.cut_node, mouth));
      place.vein = solve_rod(rod, place.conditions, options, &place.vein.poses);
    }
  }
  place.axis_turn = std::acos(std::clamp(at_rest.director(3).dot(mouth.director(3)), -1.0, 1.0));
  return place;
}

}  // namespace vasorod
