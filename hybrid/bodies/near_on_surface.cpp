#include "bodies/near_on_surface.h"

#include <algorithm>

#include "data/index.h"

namespace vasorod {

NearOnSurface::NearOnSurface(const TriangleSurface& rest, double limit)
    : points_(rest.points), limit_(limit), paths_(rest), within_(index(rest.points.rows())) {}

bool NearOnSurface::are(int a, int b) const {
  if ((points_.row(a) - points_.row(b)).norm() > limit_) return false;
  std::vector<int>& mine = within_[index(a)];
  if (mine.empty()) {
    for (const auto& [vertex, path] : paths_.within({a}, limit_)) mine.push_back(vertex);
    std::sort(mine.begin(), mine.end());
  }
  return std::binary_search(mine.begin(), mine.end(), b);
}

}  // namespace vasorod
