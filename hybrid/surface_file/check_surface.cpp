#include "surface_file/check_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/crossing_triangles.h"
#include "geometry/triangle_surface.h"

namespace vasorod {

namespace {

// Volume over area^1.5 below which a surface is flat. A ball has 0.09, a tube of length 1000 R
// 0.006.
constexpr double flat = 1e-6;

Vec3 point_of(const TriangleSurface& surface, int i) {
  return surface.points.row(i);
}

Vec3 center_of(const TriangleSurface& surface, int t) {
  return (point_of(surface, surface.triangles(t, 0)) + point_of(surface, surface.triangles(t, 1)) +
          point_of(surface, surface.triangles(t, 2))) /
         3;
}

[[noreturn]] void refuse(const std::string& file, const std::string& found,
                         const std::string& expected) {
  throw InputError(file + ": found " + found + ", expected " + expected);
}

std::string length_text(double value, const std::string& unit) {
  return number_text(value, 3) + " " + unit;
}

bool one_edge(const HalfEdge& a, const HalfEdge& b) {
  return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
}

void check_edges(const std::string& file, const TriangleSurface& surface) {
  const auto sides = half_edges_by_edge(surface.triangles);
  for (size_t i = 0; i < sides.size();) {
    size_t end = i + 1;
    while (end < sides.size() && one_edge(sides[i], sides[end])) ++end;
    const Vec3 middle = 0.5 * (point_of(surface, sides[i].from) + point_of(surface, sides[i].to));
    if (end - i > 2)
      refuse(file,
             "a non-manifold edge with " + std::to_string(end - i) + " triangles at " +
                 place_text(middle),
             "at most two triangles at an edge");
    if (end - i == 2 && sides[i].from == sides[i + 1].from)
      refuse(file, "two neighbouring triangles of opposite orientation at " + place_text(middle),
             "all triangles counter-clockwise seen from outside");
    i = end;
  }
}

// The sides that leave each point, of triangles that all have one orientation: no two lead to the
// same point.
class Spokes {
 public:
  explicit Spokes(const TriangleSurface& surface)
      : begin_(static_cast<size_t>(surface.points.rows()) + 1, 0),
        spokes_(static_cast<size_t>(surface.triangles.size())) {
    const Triangles& triangles = surface.triangles;
    for (const int from : triangles.reshaped()) ++begin_[static_cast<size_t>(from) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<size_t> next(begin_.begin(), begin_.end() - 1);
    for (int t = 0; t < triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        spokes_[next[static_cast<size_t>(triangles(t, k))]++] = {triangles(t, (k + 1) % 3),
                                                                 triangles(t, (k + 2) % 3)};
    for (size_t v = 0; v + 1 < begin_.size(); ++v)
      std::sort(spokes_.begin() + static_cast<std::ptrdiff_t>(begin_[v]),
                spokes_.begin() + static_cast<std::ptrdiff_t>(begin_[v + 1]),
                [](const Spoke& l, const Spoke& r) { return l.to < r.to; });
  }

  int count(int from) const { return static_cast<int>(end(from) - first(from)); }
  int any(int from) const { return first(from)->to; }
  // The third point of the triangle left of the side; -1: there is none.
  int third(int from, int to) const {
    const Spoke* found = std::lower_bound(first(from), end(from), to,
                                          [](const Spoke& s, int other) { return s.to < other; });
    return found != end(from) && found->to == to ? found->third : -1;
  }

 private:
  struct Spoke {
    int to = -1, third = -1;
  };
  const Spoke* first(int from) const { return spokes_.data() + begin_[static_cast<size_t>(from)]; }
  const Spoke* end(int from) const {
    return spokes_.data() + begin_[static_cast<size_t>(from) + 1];
  }

  std::vector<size_t> begin_;
  std::vector<Spoke> spokes_;
};

// Walks around each point from triangle to triangle through shared edges. If the walk misses a
// triangle of the point, two sheets touch only there.
void check_fans(const std::string& file, const TriangleSurface& surface) {
  const Spokes spokes(surface);
  for (int center = 0; center < surface.points.rows(); ++center) {
    if (spokes.count(center) == 0) continue;
    const int start = spokes.any(center);
    int walked = 0, spoke = start;
    do {
      spoke = spokes.third(center, spoke);
      if (spoke >= 0) ++walked;
    } while (spoke >= 0 && spoke != start);
    if (spoke < 0)  // the walk met an end: continue on the other side of the first spoke
      for (spoke = spokes.third(start, center); spoke >= 0; spoke = spokes.third(spoke, center))
        ++walked;
    if (walked != spokes.count(center))
      refuse(file,
             "a non-manifold point where two parts of the surface only touch at " +
                 place_text(point_of(surface, center)),
             "one fan of triangles at every point");
  }
}

void check_components(const std::string& file, const TriangleSurface& surface) {
  const auto label = components(surface.triangles, static_cast<int>(surface.points.rows()));
  std::map<int, int> size, example;
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const int part = label[static_cast<size_t>(surface.triangles(t, 0))];
    ++size[part];
    example.emplace(part, t);
  }
  if (size.size() == 1) return;
  const auto smallest = std::min_element(
      size.begin(), size.end(), [](const auto& l, const auto& r) { return l.second < r.second; });
  refuse(file,
         std::to_string(size.size()) + " separate parts (one of " +
             std::to_string(smallest->second) + " triangles at " +
             place_text(center_of(surface, example.at(smallest->first))) + ")",
         "one connected surface");
}

}  // namespace

double lidded_volume(const TriangleSurface& surface) {
  const Vec3 origin = point_of(surface, 0);
  double six = 0;
  auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    six += (a - origin).dot((b - origin).cross(c - origin));
  };
  for (int t = 0; t < surface.triangles.rows(); ++t)
    add(point_of(surface, surface.triangles(t, 0)), point_of(surface, surface.triangles(t, 1)),
        point_of(surface, surface.triangles(t, 2)));
  for (const auto& loop : boundary_loops(surface.triangles)) {
    Vec3 center = Vec3::Zero();
    for (const int i : loop) center += point_of(surface, i) / static_cast<double>(loop.size());
    for (size_t k = 0; k < loop.size();
         ++k)  // against the boundary's direction, so that the lid faces outwards
      add(point_of(surface, loop[(k + 1) % loop.size()]), point_of(surface, loop[k]), center);
  }
  return six / 6;
}

void check_manifold(const std::string& file, const TriangleSurface& surface) {
  check_edges(file, surface);
  check_fans(file, surface);
  check_components(file, surface);
}

void check_ends(const std::string& file, const TriangleSurface& surface, Role role) {
  if (role == Role::obstacle) return;
  const auto loops = boundary_loops(surface.triangles);
  if (loops.empty())
    refuse(file, "a closed surface with no ends", "at least two open ends or flat lids over them");
  for (const auto& loop : loops)
    if (loop.size() < 6)
      refuse(file,
             "an opening of " + std::to_string(loop.size()) + " edges at " +
                 place_text(point_of(surface, loop[0])),
             "ends of at least six edges and no holes");
  if (loops.size() < 2)
    refuse(file, "one open end, at " + place_text(point_of(surface, loops[0][0])), "at least two");
  const int handles = (2 - static_cast<int>(loops.size()) - euler_number(surface.triangles)) / 2;
  if (handles != 0)
    refuse(file,
           "a surface with " + std::to_string(handles) + (handles == 1 ? " handle" : " handles"),
           "branches that do not meet again, as rods form a tree");
}

void check_outward(const std::string& file, const TriangleSurface& surface) {
  const double volume = lidded_volume(surface), area = total_area(surface);
  if (std::abs(volume) < flat * area * std::sqrt(area))
    refuse(file, "a flat surface that encloses nothing", "a tubular vessel");
  if (!(volume > 0))
    refuse(file, "an inverted surface, its triangles clockwise seen from outside",
           "all triangles counter-clockwise seen from outside");
}

void check_self_intersections(const std::string& file, const TriangleSurface& surface) {
  const auto areas = triangle_areas(surface);
  Eigen::Index flattest = 0;
  if (areas.minCoeff(&flattest) == 0)
    refuse(
        file,
        "a triangle of zero area at " + place_text(center_of(surface, static_cast<int>(flattest))),
        "triangles with an area");
  const auto pairs = self_intersections(surface);
  if (!pairs.empty())
    refuse(
        file,
        "a surface that crosses itself in " + std::to_string(pairs.size()) +
            (pairs.size() < most_self_intersections ? "" : " or more") +
            " pairs of triangles, first at " +
            place_text(0.5 * (center_of(surface, pairs[0][0]) + center_of(surface, pairs[0][1]))),
        "no self-intersection");
}

double typical_radius(const TriangleSurface& surface) {
  return 2 * std::abs(lidded_volume(surface)) / total_area(surface);
}

void check_unit(const std::string& file, const TriangleSurface& surface, const Units& units) {
  constexpr double smallest = 0.5e-3,
                   largest = 50e-3;  // metres: an infant's branch, a dilated aorta
  const double radius = typical_radius(surface);
  auto fits = [&](double metres) {
    return radius * metres >= smallest && radius * metres <= largest;
  };
  if (fits(units.metres)) return;
  std::string other;
  for (const auto& [name, metres] :
       {std::pair{"mm", 1e-3}, std::pair{"cm", 1e-2}, std::pair{"m", 1.0}})
    if (fits(metres)) other += (other.empty() ? "" : " or ") + std::string(name);
  refuse(file,
         "a vessel of radius " + length_text(radius, units.length) +
             ", implausible in the scene's unit",
         "0.5 to 50 mm" + (other.empty() ? std::string(" (check: false switches this off)")
                                         : " (as it would be if the file is in " + other + ")"));
}

}  // namespace vasorod
