// The closed ends of a vessel: where a part of its wall is farther away than all around it.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A closed end.
struct Tip {
  Vec3 place = Vec3::Zero();  ///< its farthest point, length
  double length = 0;          ///< along the wall, up to where it joins the rest, length
  double radius = 0;          ///< of the tube that has this length and the wall's area, length
};

/// The tips that are longer than `least` of their radii. The distance along the wall from one tip
/// grows towards every other; each maximum's superlevel set is a branch up to where it meets a
/// longer one. Open ends are no tips. The surface is connected.
std::vector<Tip> find_tips(const TriangleSurface& surface, double least);

}  // namespace vasorod
