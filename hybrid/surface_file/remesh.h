// Isotropic remeshing of a vessel's surface to a target edge length.
#pragma once

#include <memory>
#include <mutex>

#include <vasorod/types.h>

namespace vasorod {

/// Near-equilateral triangles with edges about `edge` long on the same surface (CGAL: Botsch and
/// Kobbelt 2004; points are projected back). Points on an end stay on that end's polyline. Each
/// end's points come first, ends in the order of their lowest point number in the input, so that
/// `start` stays `start`. The surface must be manifold, oriented and free of self-intersections.
TriangleSurface remesh(const TriangleSurface& surface, double edge);

/// Remeshes a surface that is asked for again, as that of a vessel with each option of an
/// operation, once.
class KeptRemesh {
 public:
  /// remesh(surface, edge): the one made last where both are the same. Thread-safe.
  std::shared_ptr<const TriangleSurface> of(const TriangleSurface& surface, double edge);

 private:
  std::mutex one_;
  TriangleSurface surface_;
  double edge_ = 0;
  std::shared_ptr<const TriangleSurface> made_;
};

}  // namespace vasorod
