#include "prepare/repair.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "surface_file/cgal_surface.h"
#include "surface_file/check_surface.h"

namespace vasorod {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

void turn_over(TriangleSurface& surface) {
  surface.triangles.col(1).swap(surface.triangles.col(2));
}

std::vector<TriangleSurface> parts_of(const TriangleSurface& surface) {
  const auto label = components(surface.triangles, static_cast<int>(surface.points.rows()));
  std::vector<std::vector<int>> triangles(index(1 + *std::max_element(label.begin(), label.end())));
  for (int t = 0; t < surface.triangles.rows(); ++t)
    triangles[index(label[index(surface.triangles(t, 0))])].push_back(t);
  std::vector<TriangleSurface> parts;
  for (const std::vector<int>& own : triangles) parts.push_back(part_with(surface, own));
  return parts;
}

// Whether nearly all of `part` lies within `around`, which is outward.
bool within(const TriangleSurface& part, const ClosestPoint& around) {
  const auto n = part.points.rows();
  const Eigen::Index step = std::max<Eigen::Index>(1, n / 200);
  int inside = 0, all = 0;
  for (Eigen::Index i = 0; i < n; i += step) {
    const auto hit = around.query(part.points.row(i));
    if (hit.on_boundary) continue;
    ++all;
    inside += hit.signed_distance < 0 ? 1 : 0;
  }
  return all > 0 && inside > 0.9 * all;
}

}  // namespace

std::vector<std::string> orient(TriangleSurface& surface) {
  auto [points, faces] = to_soup(surface);
  const auto given_points = points.size(), given_faces = faces.size();
  pmp::repair_polygon_soup(points, faces);
  std::vector<std::string> done;
  if (points.size() < given_points)
    done.push_back(std::to_string(given_points - points.size()) + " doubled points welded");
  if (faces.size() < given_faces)
    done.push_back(std::to_string(given_faces - faces.size()) +
                   " doubled or degenerate triangles removed");
  const auto single = points.size();
  const auto before = faces;
  if (!pmp::orient_polygon_soup(points, faces) || points.size() > single)
    done.emplace_back("edges and points where more than one wall met taken apart");
  std::size_t turned = 0;
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const auto& [a, b, c] = before[t];
    const auto& face = faces[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (face[k] == a && face[(k + 1) % 3] == c && face[(k + 2) % 3] == b) {
        ++turned;
        break;
      }
  }
  turned = std::min(turned, faces.size() - turned);
  if (turned > 0)
    done.push_back(std::to_string(turned) + " triangles turned like their neighbours");
  surface.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    surface.points.row(static_cast<Eigen::Index>(i)) << points[i].x(), points[i].y(), points[i].z();
  surface.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t t = 0; t < faces.size(); ++t)
    surface.triangles.row(static_cast<Eigen::Index>(t)) << static_cast<int>(faces[t][0]),
        static_cast<int>(faces[t][1]), static_cast<int>(faces[t][2]);
  return done;
}

std::vector<LeftOut> keep_largest(TriangleSurface& surface) {
  std::vector<TriangleSurface> parts = parts_of(surface);
  std::vector<double> volume;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    volume.push_back(lidded_volume(parts[k]));
    if (std::abs(volume[k]) > std::abs(volume[largest])) largest = k;
  }
  if (volume[largest] < 0) turn_over(parts[largest]);
  std::vector<LeftOut> others;
  if (parts.size() > 1) {
    const ClosestPoint around(parts[largest]);
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (k != largest)
        others.push_back({parts[k].points.colwise().mean().transpose(), std::abs(volume[k]),
                          within(parts[k], around)});
    std::stable_sort(others.begin(), others.end(),
                     [](const LeftOut& a, const LeftOut& b) { return a.volume > b.volume; });
  }
  surface = std::move(parts[largest]);
  return others;
}

Openings openings_of(const TriangleSurface& surface) {
  Openings out;
  const auto loops = boundary_loops(surface.triangles);
  std::vector<int> loop_of(static_cast<std::size_t>(surface.points.rows()), -1);
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const int v : loops[k]) loop_of[static_cast<std::size_t>(v)] = static_cast<int>(k);
  std::vector<Vec3> plane;
  for (const auto& loop : loops) plane.push_back(area_vector(surface.points, loop).normalized());
  std::vector<double> along(loops.size(), 0), all(loops.size(), 0);
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    std::set<int> at;
    for (int k = 0; k < 3; ++k) {
      const int loop = loop_of[static_cast<std::size_t>(surface.triangles(t, k))];
      if (loop >= 0) at.insert(loop);
    }
    for (const int k : at) {
      const Vec3 normal = triangle_normal(surface, t);
      along[static_cast<std::size_t>(k)] +=
          std::abs(normal.dot(plane[static_cast<std::size_t>(k)]));
      all[static_cast<std::size_t>(k)] += normal.norm();
    }
  }
  for (std::size_t k = 0; k < loops.size(); ++k)
    (along[k] > 0.6 * all[k] || loops[k].size() < 6 ? out.holes : out.ends).push_back(loops[k]);
  return out;
}

double unevenness(const Points& points, const std::vector<int>& loop) {
  const Vec3 normal = area_vector(points, loop).normalized();
  Vec3 center = Vec3::Zero();
  for (const int v : loop) center += points.row(v).transpose() / static_cast<double>(loop.size());
  double largest = 0;
  for (const int v : loop)
    largest = std::max(largest, std::abs((points.row(v).transpose() - center).dot(normal)));
  return largest / (perimeter(points, loop) / (2 * M_PI));
}

void fill_loops(TriangleSurface& surface, const std::vector<std::vector<int>>& loops) {
  if (loops.empty()) return;
  CgalMesh mesh = to_cgal(surface);
  for (const auto& loop : loops) {
    const CgalMesh::Vertex_index v(static_cast<CgalMesh::size_type>(loop.front()));
    auto border = mesh.halfedge(v);
    for (const auto h : CGAL::halfedges_around_target(v, mesh))
      if (mesh.is_border(h)) border = h;
    if (!mesh.is_border(border)) continue;
    std::vector<CgalMesh::Face_index> faces;
    std::vector<CgalMesh::Vertex_index> vertices;
    pmp::triangulate_refine_and_fair_hole(mesh, border, std::back_inserter(faces),
                                          std::back_inserter(vertices));
  }
  surface = from_cgal(mesh);
}

int handles_of(const TriangleSurface& surface) {
  const auto loops = static_cast<int>(boundary_loops(surface.triangles).size());
  return (2 - loops - euler_number(surface.triangles)) / 2;
}

}  // namespace vasorod
