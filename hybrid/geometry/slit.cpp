#include "geometry/slit.h"

#include <algorithm>
#include <stdexcept>

namespace vasorod {

Slit open_slit(SurfaceEditor& editor, const std::vector<int>& path) {
  if (path.size() < 3) throw std::logic_error("open_slit: a slit needs at least two edges");
  // The right bank of each inner vertex, found before any vertex is duplicated. The ring of a
  // vertex is counter-clockwise: the left bank lies between `next` and `previous`, the right bank
  // between `previous` and `next`.
  std::vector<std::vector<int>> right(path.size());
  for (size_t k = 1; k + 1 < path.size(); ++k) {
    auto ring = editor.ring(path[k]);
    const auto previous = std::find(ring.begin(), ring.end(), path[k - 1]);
    if (previous == ring.end() || std::find(ring.begin(), ring.end(), path[k + 1]) == ring.end() ||
        editor.on_boundary(path[k]))
      throw std::logic_error("open_slit: the path is not made of inner edges");
    std::rotate(ring.begin(), previous, ring.end());
    for (const int w : ring) {
      if (w == path[k + 1]) break;
      right[k].push_back(editor.triangle_left_of(path[k], w));
    }
  }
  Slit slit;
  slit.rim.assign(path.begin(), path.end());
  slit.other_tip = static_cast<int>(path.size()) - 1;
  for (size_t k = path.size() - 2; k > 0; --k)
    slit.rim.push_back(editor.duplicate(path[k], right[k]));
  return slit;
}

}  // namespace vasorod
