// Makes a stretch of an isoline of a function on a surface a path of its edges, starting from a
// point of the surface and running a given length both ways.
#pragma once

#include <functional>
#include <vector>

#include "geometry/surface_editor.h"

namespace vasorod {

struct IsolineRequest {
  Eigen::VectorXd across;  ///< per input vertex: the function (a length), linear on triangles; the
                           ///< path keeps the start's value
  Eigen::VectorXd along;   ///< per input vertex: grows in the path's forward direction
  int triangle = 0;        ///< where the path's start lies,
  Vec3 barycentric = Vec3::Constant(1.0 / 3);  ///< and where in that triangle
  double length = 0;  ///< of the path, length unit: half of it each way from the start
  std::function<bool(int)> allowed;  ///< may the path come next to this input vertex?
};

enum class IsolineEnd {
  reached,    ///< full length
  boundary,   ///< the isoline runs into an open end before
  forbidden,  ///< ... or into vertices that are not allowed
  lost        ///< ... or cannot be followed: the function has no isoline there
};

struct IsolinePath {
  std::vector<int> vertices;  ///< the editor's, in order from the smallest `along`; consecutive
                              ///< ones joined by edges
  int start = 0;              ///< index into `vertices` of the start
  double backward = 0, forward = 0;  ///< lengths from the start to both tips, length unit
  IsolineEnd end =
      IsolineEnd::reached;  ///< anything but reached: the path stops short, `stopped_at` says where
  Vec3 stopped_at = Vec3::Zero();
};

/// Walks from triangle to triangle along the isoline. A crossing within the snap distance of a
/// vertex moves that vertex onto the isoline instead of splitting the edge; the start and both tips
/// are vertices, put exactly in place. Where a tip falls so close to the last crossing that a short
/// edge would come of it, that crossing's vertex is slid along the isoline to the tip. The lengths
/// come out exact to rounding unless that slide would fold a triangle.
IsolinePath embed_isoline(SurfaceEditor& editor, const IsolineRequest& request);

}  // namespace vasorod
