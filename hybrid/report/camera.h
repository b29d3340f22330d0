// From where a scene is looked at, chosen from the scene.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A perspective view of `centre` from `distance` along axes.row(2).
struct Camera {
  Vec3 centre = Vec3::Zero();    ///< length unit
  Mat3 axes = Mat3::Identity();  ///< rows: to the right, up, towards the eye; orthonormal
  double distance = 1;           ///< eye to centre, length unit
  double half_height = 1;  ///< half of what is seen from bottom to top, at the centre, length unit
  double shift = 0;        ///< how far left of the picture's middle the centre is, in half widths
};

/// Something to look at.
struct Seen {
  const Points* points = nullptr;
  bool wanted = true;  ///< what the picture is about; the rest may hide or leave the picture
};

/// The direction towards the eye, perpendicular to `up` or lifted a little, from which most of what
/// is wanted is seen.
Vec3 clearest_direction(const std::vector<Seen>& scene, const Vec3& up);

/// A place on a surface that a picture is about.
struct Spot {
  Vec3 at = Vec3::Zero(), normal = Vec3::Zero();  ///< normal: outwards, unit
  double weight = 0;
};

/// Of the same directions the one from which most of the spots' weight is seen, each as far as it
/// faces the eye and nothing of the scene hides it.
Vec3 facing_direction(const std::vector<Seen>& scene, const std::vector<Spot>& spots,
                      const Vec3& up);

/// The direction across the longest axis of the wanted points that a wide picture needs as `up`.
Vec3 level_up(const std::vector<Seen>& scene);

/// A camera from that direction which holds every wanted point, width over height = aspect;
/// `clear_right`: part of the width to leave free at the right, for a legend.
Camera fit_camera(const std::vector<Seen>& scene, const Vec3& towards_eye, const Vec3& up,
                  double aspect, double clear_right = 0);

}  // namespace vasorod
