#include "surface_file/self_intersections.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <algorithm>
#include <iterator>
#include <utility>

#include "surface_file/cgal_surface.h"

namespace vasorod {

std::vector<std::array<int, 2>> self_intersections(const TriangleSurface& surface) {
  const CgalMesh mesh = to_cgal(surface);
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> found;
  CGAL::Polygon_mesh_processing::self_intersections(
      mesh, std::back_inserter(found), CGAL::parameters::maximum_number(most_self_intersections));
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [a, b] : found) {
    const int i = static_cast<int>(a.idx()), j = static_cast<int>(b.idx());
    pairs.push_back({std::min(i, j), std::max(i, j)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace vasorod
