// Isotropic remeshing of a vessel's surface to a target edge length.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Near-equilateral triangles with edges about `edge` long on the same surface (CGAL: Botsch and
/// Kobbelt 2004; points are projected back). Points on an end stay on that end's polyline. Each
/// end's points come first, ends in the order of their lowest point number in the input, so that
/// `start` stays `start`. The surface must be manifold, oriented and free of self-intersections.
TriangleSurface remesh(const TriangleSurface& surface, double edge);

}  // namespace vasorod
