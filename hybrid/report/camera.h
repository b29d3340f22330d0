// The camera of a picture, chosen from the scene.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A perspective view of `centre` from `distance` along axes.row(2).
struct Camera {
  Vec3 centre = Vec3::Zero();    ///< length unit
  Mat3 axes = Mat3::Identity();  ///< rows: to the right, up, towards the eye; orthonormal
  double distance = 1;           ///< eye to centre, length unit
  double half_height = 1;        ///< half the visible height at the centre, length unit
  double shift = 0;  ///< distance of the centre left of the picture's middle, in half widths
};

/// Where a point appears in a picture of this size, pixels from the top left.
Vec2 pixel_of(const Camera& camera, const Vec3& point, int width, int height);

/// A body in front of the camera.
struct Seen {
  const Points* points = nullptr;
  bool wanted = true;  ///< the picture is about it; other bodies may be hidden or outside
};

/// The direction towards the eye from which most of the wanted bodies is visible, perpendicular to
/// `up` or lifted a little.
Vec3 clearest_direction(const std::vector<Seen>& scene, const Vec3& up);

/// A point of a surface that should be visible.
struct Spot {
  Vec3 at = Vec3::Zero(), normal = Vec3::Zero();  ///< normal: outwards, unit
  double weight = 0;
};

/// Of the same directions, the one from which most of the spots' weight is visible. A spot counts
/// as far as it faces the eye, and not at all if a body hides it.
Vec3 facing_direction(const std::vector<Seen>& scene, const std::vector<Spot>& spots,
                      const Vec3& up);

/// Of these and of higher directions, the one that shows most of the wanted bodies and, as
/// important, of the spots.
Vec3 clearest_direction(const std::vector<Seen>& scene, const std::vector<Spot>& spots,
                        const Vec3& up);

/// The `up` for a wide picture: perpendicular to the longest axis of the wanted points.
Vec3 level_up(const std::vector<Seen>& scene);

/// A camera in that direction with every wanted point in the picture. `aspect`: width over height.
/// `clear_right`: fraction of the width that stays free at the right for a legend.
Camera fit_camera(const std::vector<Seen>& scene, const Vec3& towards_eye, const Vec3& up,
                  double aspect, double clear_right = 0);

}  // namespace vasorod
