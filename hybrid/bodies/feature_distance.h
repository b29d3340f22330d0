// The distance of a vertex from a triangle and of two edges from each other, with its derivatives.
//
// The vector between the two closest points is a sum of the four vertices with weights. Where a
// closest point lies inside an edge or a triangle, the weights depend on the vertices too; of the
// derivatives only the second knows of it, because a closest point is a minimum.
#pragma once

#include <array>

#include <vasorod/types.h>

namespace vasorod {

/// Two features that share no vertex: a vertex (first) and a triangle, or two edges (two and two).
enum class Features { vertex_and_triangle, two_edges };

/// The vertices of two features, length.
using FeatureCorners = std::array<Vec3, 4>;

/// The closest points of two features.
struct FeatureDistance {
  /// Of the corners, in the vector from the second feature to the first: those of the first sum to
  /// 1, those of the second to -1.
  std::array<double, 4> weight{};
  Vec3 apart = Vec3::Zero();  ///< that vector, length
  double distance = 0;        ///< length
};

/// Two edges that are parallel may be closest along a stretch: then one of its points.
/// Source: Ericson, Real-time collision detection, 2005, sections 5.1.5 and 5.1.9.
FeatureDistance feature_distance(const FeatureCorners& x, Features features);

/// Hessian of distance^2 / 2 by the corners, where the gradient is weight * apart: dimensionless.
Eigen::Matrix<double, 12, 12> half_square_hessian(const FeatureCorners& x,
                                                  const FeatureDistance& found, Features features);

}  // namespace vasorod
