#include "surface_file/open_caps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>

#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "surface_file/read_polydata.h"

namespace vasorod {

namespace {

struct Faces {
  std::vector<Vec3> normal;  // unit, per triangle
  std::vector<Edge> edges;
  std::vector<std::array<int, 3>> edges_at;  // per triangle

  explicit Faces(const TriangleSurface& surface)
      : edges(edges_of(surface.triangles)),
        edges_at(static_cast<size_t>(surface.triangles.rows()), {-1, -1, -1}) {
    for (int t = 0; t < surface.triangles.rows(); ++t)
      normal.push_back(triangle_normal(surface, t).normalized());
    for (size_t e = 0; e < edges.size(); ++e)
      for (const int t : edges[e].triangle)
        if (t >= 0)
          *std::find(edges_at[at(t)].begin(), edges_at[at(t)].end(), -1) = static_cast<int>(e);
  }
  static size_t at(int i) { return static_cast<size_t>(i); }
  // The triangle across an edge, -1 on an end.
  int across(int edge, int t) const {
    const Edge& e = edges[at(edge)];
    return e.triangle[0] == t ? e.triangle[1] : e.triangle[0];
  }
  double cosine(int t, int u) const { return normal[at(t)].dot(normal[at(u)]); }
};

// Connected sets of triangles. `joined(seed, t, u)`: whether u, a neighbour of t, belongs to the
// set of `seed`.
std::vector<std::vector<int>> regions(const Faces& faces,
                                      const std::function<bool(int, int, int)>& joined) {
  std::vector<char> taken(faces.normal.size(), 0);
  std::vector<std::vector<int>> all;
  for (int seed = 0; seed < static_cast<int>(faces.normal.size()); ++seed) {
    if (taken[Faces::at(seed)]) continue;
    std::vector<int> region{seed};
    taken[Faces::at(seed)] = 1;
    for (size_t next = 0; next < region.size(); ++next)
      for (const int e : faces.edges_at[Faces::at(region[next])]) {
        const int u = faces.across(e, region[next]);
        if (u < 0 || taken[Faces::at(u)] || !joined(seed, region[next], u)) continue;
        taken[Faces::at(u)] = 1;
        region.push_back(u);
      }
    all.push_back(std::move(region));
  }
  return all;
}

bool is_lid(const TriangleSurface& surface, const Faces& faces, const std::vector<int>& region) {
  constexpr double degree = M_PI / 180;
  if (region.size() < 4 || region.size() == faces.normal.size()) return false;
  std::vector<char> inside(faces.normal.size(), 0);
  for (const int t : region) inside[Faces::at(t)] = 1;
  Vec3 area = Vec3::Zero();  // the sum of area vectors: its length is the area of a flat region
  for (const int t : region) {
    const Vec3 a = surface.points.row(surface.triangles(t, 0)),
               b = surface.points.row(surface.triangles(t, 1)),
               c = surface.points.row(surface.triangles(t, 2));
    area += 0.5 * (b - a).cross(c - a);
  }
  const Vec3 mean = area.normalized();
  double border = 0;
  for (const int t : region) {
    if (faces.normal[Faces::at(t)].dot(mean) < std::cos(10 * degree)) return false;
    for (const int e : faces.edges_at[Faces::at(t)]) {
      const int u = faces.across(e, t);
      if (u < 0) return false;
      if (inside[Faces::at(u)]) continue;
      if (faces.cosine(t, u) > std::cos(30 * degree)) return false;
      border += (surface.points.row(faces.edges[Faces::at(e)].a) -
                 surface.points.row(faces.edges[Faces::at(e)].b))
                    .norm();
    }
  }
  Triangles own(static_cast<Eigen::Index>(region.size()), 3);
  for (size_t k = 0; k < region.size(); ++k)
    own.row(static_cast<Eigen::Index>(k)) = surface.triangles.row(region[k]);
  if (euler_number(own) != 1) return false;
  const auto loops = boundary_loops(own);
  return loops.size() == 1 && loops[0].size() >= 6 &&
         4 * M_PI * area.norm() > 0.5 * border * border;
}

const NamedArray* face_names(const LoadedSurface& loaded) {
  for (const std::string_view name : {"ModelFaceID", "CapID", "CellEntityIds"})
    for (const NamedArray& array : loaded.cell_arrays)
      if (array.name == name && array.values.cols() == 1) return &array;
  return nullptr;
}

std::vector<std::vector<int>> lids_of(const TriangleSurface& surface, const Faces& faces,
                                      const std::vector<std::vector<int>>& candidates) {
  std::vector<std::vector<int>> lids;
  for (const auto& region : candidates)
    if (is_lid(surface, faces, region)) lids.push_back(region);
  std::vector<int> owner(static_cast<size_t>(surface.points.rows()), -1);
  std::vector<char> touching(lids.size(), 0);
  for (size_t lid = 0; lid < lids.size(); ++lid)
    for (const int t : lids[lid])
      for (int k = 0; k < 3; ++k) {
        int& by = owner[Faces::at(surface.triangles(t, k))];
        if (by >= 0 && by != static_cast<int>(lid)) touching[lid] = touching[Faces::at(by)] = 1;
        by = static_cast<int>(lid);
      }
  std::vector<std::vector<int>> apart;
  for (size_t lid = 0; lid < lids.size(); ++lid)
    if (!touching[lid]) apart.push_back(lids[lid]);
  return apart;
}

Lid lid_of(const LoadedSurface& loaded, const std::vector<int>& triangles) {
  Lid lid;
  for (const int t : triangles)
    for (int k = 0; k < 3; ++k)
      lid.center += loaded.surface.points.row(loaded.surface.triangles(t, k)).transpose() /
                    (3.0 * static_cast<double>(triangles.size()));
  for (const NamedArray& array : loaded.cell_arrays)
    if (array.name == "ModelFaceID" && array.values.cols() == 1)
      lid.name = number_text(array.values(triangles.front(), 0), 15);
  return lid;
}

}  // namespace

void open_caps(LoadedSurface& loaded) {
  const TriangleSurface& surface = loaded.surface;
  const Faces faces(surface);
  std::vector<std::vector<int>> lids;
  if (const NamedArray* names = face_names(loaded))
    lids = lids_of(surface, faces, regions(faces, [&](int, int t, int u) {
                     return names->values(t, 0) == names->values(u, 0);
                   }));
  const double flat = std::cos(10 * M_PI / 180);
  if (lids.empty())
    lids = lids_of(surface, faces, regions(faces, [&](int seed, int t, int u) {
                     return faces.cosine(t, u) > flat && faces.cosine(seed, u) > flat;
                   }));
  if (lids.empty()) return;
  for (const auto& lid : lids) loaded.lids.push_back(lid_of(loaded, lid));
  std::vector<char> gone(faces.normal.size(), 0);
  for (const auto& lid : lids)
    for (const int t : lid) gone[Faces::at(t)] = 1;
  std::vector<int> keep;
  for (int t = 0; t < surface.triangles.rows(); ++t)
    if (!gone[Faces::at(t)]) keep.push_back(t);
  keep_triangles(loaded, keep);
  drop_unused_points(loaded);
  loaded.report.removed_caps = static_cast<int>(lids.size());
}

}  // namespace vasorod
