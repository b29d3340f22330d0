// Vasorod: fixed-size and mesh types every folder shares.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace vasorod {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Points, one per row (n x 3), in the scene's length unit.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Triangles, one per row (m x 3): indices into Points, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A triangle surface. Vessels are open: one boundary loop per end.
struct TriangleSurface {
  Points points;        ///< n x 3, scene's length unit
  Triangles triangles;  ///< m x 3, outward orientation
};

/// A rigid frame: position r and right-handed orthonormal directors d1, d2, d3 as the rotation's
/// columns; on a rod d3 is normal to the section and points towards increasing arc length.
struct Pose {
  Mat3 rotation = Mat3::Identity();
  Vec3 position = Vec3::Zero();

  Vec3 operator*(const Vec3& local) const { return rotation * local + position; }
  Pose operator*(const Pose& other) const {
    return {rotation * other.rotation, *this * other.position};
  }
  Pose inverse() const { return {rotation.transpose(), -(rotation.transpose() * position)}; }
  Vec3 director(int k) const { return rotation.col(k - 1); }  ///< k = 1, 2, 3
};

}  // namespace vasorod
