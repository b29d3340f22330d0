#include "bodies/near_on_surface.h"

namespace vasorod {

NearOnSurface::NearOnSurface(const TriangleSurface& rest, double limit)
    : points_(rest.points), limit_(limit), paths_(rest) {}

bool NearOnSurface::are(int a, int b) const {
  if ((points_.row(a) - points_.row(b)).norm() > limit_) return false;
  auto found = within_.find(a);
  if (found == within_.end()) found = within_.emplace(a, paths_.within({a}, limit_)).first;
  return found->second.contains(b);
}

}  // namespace vasorod
