// A section of a wall held by one rigid pose: an end's ring of vertices. Rigid: ring and rim
// normals follow the pose. Soft: only the ring's mean pose does (section_tie.h). Each of the pose's
// six freedoms is fixed, carried along a path, or free and loaded.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rod/conditions.h"

namespace vasorod {

struct HeldSection {
  std::string label;      ///< for messages
  std::vector<int> ring;  ///< vertices of the wall
  bool rigid = true;
  Pose rest;  ///< at rest: the point forces and moments count about, and the directors d1, d2, d3
  std::array<bool, 6> fixed{true, true, true, true,
                            true, true};  ///< x, y, z, rx, ry, rz along `frame`, as in RodSupport
  std::optional<Mat3> frame;              ///< by default rest.rotation
  RodMotion motion;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< dead, space axes
  Vec3 body_moment = Vec3::Zero();  ///< in the section's own directors, turning with them
};

/// A section's pose at given unknowns, with its derivatives: dr = position_axes dz, and the
/// rotation's left increment is rotation_axes dz.
struct SectionPlacement {
  Mat3 rotation = Mat3::Identity();  ///< from rest
  Vec3 position = Vec3::Zero();      ///< of the section's point
  Vec3 vector = Vec3::Zero();        ///< rotation vector from the reference
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6> position_axes,
      rotation_axes;  ///< 3 x unknowns()
};

/// The pose's unknowns: position along the free axes, and the free components of the rotation
/// vector that leads from a reference rotation to the present one.
class SectionPose {
 public:
  explicit SectionPose(const HeldSection& section);

  int unknowns() const { return static_cast<int>(free_.size()); }
  /// Fixed freedoms follow the motion to time t in 0..1; free unknowns keep their values.
  void set_time(double t);
  /// Another way to the same end: where all six freedoms are fixed the pose is this one (rotation
  /// from rest) until the next set_time. A motion's own path, rotation and displacement in
  /// proportion, shortens a tube that is bent.
  void set_target(const Pose& pose);
  double time() const { return time_; }
  SectionPlacement place(const double* z) const;
  SectionPlacement at_rest() const;
  /// How the unknowns turn with the section where whole triples are free: identity elsewhere.
  /// unknowns() wide.
  Eigen::MatrixXd turned_axes(const Mat3& rotation) const;
  /// The unknowns that bring the pose as near as its free axes allow to a given one (rotation from
  /// rest).
  void unknowns_of(const Mat3& rotation, const Vec3& position, double* z);
  /// Makes the present rotation the reference where the free axes allow that, and renews the load's
  /// moment. Returns how much the moment's share of the gradient changed (force times length).
  double recentre(double* z);

  /// Second derivatives with respect to the unknowns of sum_i g_i . (R arm_i), the g_i constant:
  /// torque = sum a x g, spread = sum a g^T - (a.g) I with a = R arm. Added to a 6 x 6 corner.
  Mat6 curvature(const SectionPlacement& at, const Vec3& torque, const Mat3& spread) const;

  /// Potential of the dead load, and its gradient added to 6 entries.
  double load(const SectionPlacement& at, const double* z, Vec6& gradient) const;
  bool loaded() const;
  /// Whether the load's moment has an energy: none, or about one fixed axis.
  bool has_potential() const;
  const HeldSection& section() const { return section_; }

 private:
  Vec3 moment_at(const Mat3& rotation) const;

  HeldSection section_;
  Mat3 frame_ = Mat3::Identity();
  std::vector<int> free_;  // of 0..5
  int free_rotations_ = 0;
  double time_ = 0;
  Mat3 reference_ = Mat3::Identity();   // rotation from rest that the vector counts from
  Vec3 fixed_position_ = Vec3::Zero();  // of the section's point, where no free component moves it
  Vec3 effective_moment_ = Vec3::Zero();  // conjugate to the rotation vector
};

/// A section's lengths divided by `length` about `origin`, its forces by `force`.
HeldSection scaled(const HeldSection& section, double length, double force, const Vec3& origin);

}  // namespace vasorod
