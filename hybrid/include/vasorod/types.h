// Fixed-size and mesh types shared by all parts of Vasorod.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace vasorod {

using Vec2 = Eigen::Vector2d;              ///< 2 numbers
using Vec3 = Eigen::Vector3d;              ///< 3 numbers
using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< 6 numbers; a rod's strain is v1 v2 v3 u1 u2 u3
using Mat3 = Eigen::Matrix3d;              ///< 3 x 3
using Mat6 = Eigen::Matrix<double, 6, 6>;  ///< 6 x 6

/// Points, one per row (n x 3), in the scene's length unit.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Triangles, one per row (m x 3): indices into Points, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A triangle surface. Vessels are open: one boundary loop per end.
struct TriangleSurface {
  Points points;        ///< n x 3, scene's length unit
  Triangles triangles;  ///< m x 3, outward orientation
};

/// A rigid frame: a position r and right-handed orthonormal directors d1, d2, d3, the columns of
/// the rotation. On a rod, d3 is normal to the section and points towards increasing arc length.
struct Pose {
  Mat3 rotation = Mat3::Identity();  ///< columns d1, d2, d3 in space axes
  Vec3 position = Vec3::Zero();      ///< r, length

  /// The point with these coordinates in the frame, in space axes.
  Vec3 operator*(const Vec3& local) const { return rotation * local + position; }
  /// The composition: `other` is given relative to this frame.
  Pose operator*(const Pose& other) const {
    return {rotation * other.rotation, *this * other.position};
  }
  /// The inverse motion: p.inverse() * p is the identity.
  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * position)}; }
  /// Director d_k, k = 1, 2, 3.
  Vec3 director(int k) const { return rotation.col(k - 1); }
};

}  // namespace vasorod
