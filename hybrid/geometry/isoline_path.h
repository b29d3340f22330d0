// Embeds part of an isoline of a function on a surface as a path of mesh edges. The path starts at
// a given point of the surface and runs a given length in both directions.
#pragma once

#include <functional>
#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

/// What to embed.
struct IsolineRequest {
  /// Per input vertex: the function (a length), linear on triangles. The path keeps the start's
  /// value.
  Eigen::VectorXd across;
  Eigen::VectorXd along;  ///< per input vertex: increases in the path's forward direction
  int triangle = 0;       ///< triangle of the path's start
  Vec3 barycentric = Vec3::Constant(1.0 / 3);  ///< barycentric coordinates of the start
  double length = 0;                 ///< length of the path, half of it on each side of the start
  std::function<bool(int)> allowed;  ///< whether the path may pass next to this input vertex
};

/// Why a path ended.
enum class IsolineEnd {
  reached,    ///< full length
  boundary,   ///< the isoline runs into an open end before its full length
  forbidden,  ///< the isoline runs into vertices that are not allowed
  lost        ///< the isoline cannot be followed: the function has no isoline there
};

/// The embedded path.
struct IsolinePath {
  /// The editor's vertices, from the smallest `along` on; edges join consecutive ones.
  std::vector<int> vertices;
  int start = 0;                     ///< index into `vertices` of the start
  double backward = 0, forward = 0;  ///< lengths from the start to both tips, length unit
  /// Anything but `reached`: the path is too short.
  IsolineEnd end = IsolineEnd::reached;
  Vec3 stopped_at = Vec3::Zero();  ///< where a path that is too short stops, length unit
  /// The longest path from that start that would be complete, length unit; if too short.
  double fits = 0;
};

/// Walks from triangle to triangle along the isoline. Where the isoline crosses an edge within the
/// snap distance of a vertex, the vertex is moved onto the isoline and the edge is not split. The
/// start and both tips are vertices, placed exactly. If a tip is so close to the last crossing that
/// a short edge would result, the vertex of that crossing slides along the isoline to the tip. The
/// lengths are exact to rounding unless this slide would fold a triangle.
IsolinePath embed_isoline(SurfaceEditor& editor, const IsolineRequest& request);

}  // namespace vasorod
