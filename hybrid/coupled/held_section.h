// A section of a wall held by one rigid pose: the ring of vertices at an end. In a rigid section,
// the ring and the rim normals follow the pose; in a soft section, only the mean pose of the ring
// does (section_tie.h). Each of the pose's six freedoms is fixed, moved along a path, or free and
// loaded.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rod/conditions.h"

namespace vasorod {

/// Geometry, support and load of one section.
struct HeldSection {
  std::string label;      ///< for messages
  std::vector<int> ring;  ///< vertices of the wall
  bool rigid = true;
  /// At rest: the point that forces and moments refer to, and the directors d1, d2, d3.
  Pose rest;
  /// x, y, z, rx, ry, rz along `frame`, as in RodSupport.
  std::array<bool, 6> fixed{true, true, true, true, true, true};
  std::optional<Mat3> frame;  ///< by default rest.rotation
  RodMotion motion;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< dead, space axes
  /// In the section's own directors, turning with them.
  Vec3 body_moment = Vec3::Zero();
};

/// A section's pose at given unknowns, with its derivatives:
///
/// ```
/// dr = position_axes dz,   left increment of the rotation = rotation_axes dz
/// ```
struct SectionPlacement {
  Mat3 rotation = Mat3::Identity();  ///< from rest
  Vec3 position = Vec3::Zero();      ///< of the section's point
  Vec3 vector = Vec3::Zero();        ///< rotation vector from the reference
  /// 3 x unknowns().
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6> position_axes, rotation_axes;
};

/// The unknowns of a pose: the position along the free axes, and the free components of the
/// rotation vector from a reference rotation to the present rotation.
class SectionPose {
 public:
  explicit SectionPose(const HeldSection& section);

  int unknowns() const { return static_cast<int>(free_.size()); }
  /// Moves the fixed freedoms to time t in 0..1; free unknowns keep their values.
  void set_time(double t);
  /// Prescribes another path to the same end: if all six freedoms are fixed, the pose is `pose`
  /// (rotation from rest) until the next set_time(). The motion's own path, with rotation and
  /// displacement in proportion to t, would shorten a tube that is bent.
  void set_target(const Pose& pose);
  double time() const { return time_; }
  SectionPlacement place(const double* z) const;
  SectionPlacement at_rest() const;
  /// Matrix by which the unknowns rotate with the section if all three translations or all three
  /// rotations are free; identity elsewhere. unknowns() x unknowns().
  Eigen::MatrixXd turned_axes(const Mat3& rotation) const;
  /// Computes the unknowns whose pose is as close to the given one (rotation from rest) as the free
  /// axes allow.
  void unknowns_of(const Mat3& rotation, const Vec3& position, double* z);
  /// Makes the present rotation the reference where the free axes allow it, and updates the moment
  /// of the load. Returns the change of the moment's contribution to the gradient (force times
  /// length).
  double recentre(double* z);

  /// Second derivatives with respect to the unknowns of sum_i g_i . (R arm_i) with constant g_i, in
  /// the leading unknowns() x unknowns() block:
  ///
  /// ```
  /// torque = sum a x g,   spread = sum a g^T - (a.g) I,   a = R arm
  /// ```
  Mat6 curvature(const SectionPlacement& at, const Vec3& torque, const Mat3& spread) const;

  /// Returns the potential of the dead load and adds its gradient to `gradient`.
  double load(const SectionPlacement& at, const double* z, Vec6& gradient) const;
  bool loaded() const;
  /// Whether the moment of the load has a potential: it is zero, or acts about one fixed axis.
  bool has_potential() const;
  const HeldSection& section() const { return section_; }

 private:
  Vec3 moment_at(const Mat3& rotation) const;

  HeldSection section_;
  Mat3 frame_ = Mat3::Identity();
  std::vector<int> free_;  // of 0..5
  int free_rotations_ = 0;
  double time_ = 0;
  // Rotation from rest to which the rotation vector refers.
  Mat3 reference_ = Mat3::Identity();
  // Position of the section's point without its free components.
  Vec3 fixed_position_ = Vec3::Zero();
  Vec3 effective_moment_ = Vec3::Zero();  // conjugate to the rotation vector
};

/// Per vertex of a wall with `vertices`: 1 on a rigid section, as WallInput::glued.
std::vector<char> glued_marks(const std::vector<HeldSection>& sections, Eigen::Index vertices);

/// The section with lengths divided by `length` about `origin`, and forces by `force`.
HeldSection scaled(const HeldSection& section, double length, double force, const Vec3& origin);

}  // namespace vasorod
