#include "prepare/open_tip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/edge_paths.h"
#include "geometry/level_set_split.h"
#include "geometry/plane_section.h"
#include "geometry/surface_editor.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

int nearest_vertex(const TriangleSurface& surface, const Vec3& place) {
  Eigen::Index nearest = 0;
  (surface.points.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

// The closed curve around a place, in the plane across `normal`.
std::optional<SectionLoop> closed_section(const TriangleSurface& surface, const Vec3& place,
                                          const Vec3& normal) {
  auto loops = plane_sections(surface, place, normal);
  const int around = section_around(loops, place, normal);
  if (around < 0) return std::nullopt;
  SectionLoop& loop = loops[static_cast<std::size_t>(around)];
  if (!loop.closed || section_winding(loop.points, place, normal) == 0) return std::nullopt;
  return std::move(loop);
}

FlatSection flat_section(const SectionLoop& loop, const Vec3& normal) {
  return {section_centroid(loop), normal, std::sqrt(section_area(loop) / M_PI)};
}

// A first section on the tube behind a tip. The wall within a distance d of the tip, measured along
// the wall, is a cap and then a ring; d grows until the cap is over on all sides,
// also for a tip on the rim of a flat cap: `radii` of the ring.
std::optional<FlatSection> first_section(const TriangleSurface& surface, const Tip& tip,
                                         double radii) {
  const Eigen::VectorXd area = vertex_areas(surface);
  const double edge = mean_edge_length(surface);
  std::vector<std::pair<double, int>> near;
  for (const auto& [v, d] :
       EdgePaths(surface).within({nearest_vertex(surface, tip.place)}, 1.5 * tip.length))
    near.emplace_back(d, v);
  std::sort(near.begin(), near.end());
  const auto ring = [&](double from, double to, Vec3& center) {
    double sum = 0;
    center.setZero();
    for (auto i = std::lower_bound(near.begin(), near.end(), std::pair(from, -1));
         i != near.end() && i->first < to; ++i) {
      sum += area[i->second];
      center += area[i->second] * surface.points.row(i->second).transpose();
    }
    center /= std::max(sum, 1e-300);
    return sum;
  };
  for (double d = 3 * edge; d < 0.95 * tip.length; d *= 1.1) {
    Vec3 outer, middle, inner;
    const double radius = ring(0.75 * d, d, middle) / (0.25 * d * 2 * M_PI);
    if (d < radii * radius) continue;
    if (ring(0.5 * d, 0.75 * d, outer) <= 0 || ring(d, 1.25 * d, inner) <= 0) return std::nullopt;
    return FlatSection{middle, (outer - inner).normalized(), radius};
  }
  return std::nullopt;
}

// Turns a section across the line through the centroids of those beside it.
std::optional<FlatSection> straightened(const TriangleSurface& surface, FlatSection section) {
  for (int round = 0; round < 4; ++round) {
    const Vec3 step = 0.4 * section.radius * section.normal;
    const auto before = closed_section(surface, section.center - step, section.normal),
               after = closed_section(surface, section.center + step, section.normal);
    if (!before || !after) return std::nullopt;
    const Vec3 a = section_centroid(*before), b = section_centroid(*after);
    if ((b - a).norm() < 0.2 * section.radius) return std::nullopt;
    const auto loop = closed_section(surface, 0.5 * (a + b), (b - a).normalized());
    if (!loop) return std::nullopt;
    section = flat_section(*loop, (b - a).normalized());
  }
  return section;
}

// On a branch that is few edges wide the first section may lie in the rounding of its cap: from
// there inwards to where the area no longer grows. Another section stays as it is.
FlatSection behind_rounding(const TriangleSurface& surface, const FlatSection& section) {
  constexpr double few = 3;  // edges in a radius
  if (section.radius > few * mean_edge_length(surface)) return section;
  constexpr double step = 0.25;  // radii
  constexpr int most_steps = 7, first_steps = 2;
  constexpr double steep = 1.2, settled = 1.03, most_growth = 2;  // shares of areas
  FlatSection here = section;
  for (int k = 1; k <= most_steps; ++k) {
    const auto loop = closed_section(
        surface, section.center - k * step * section.radius * section.normal, section.normal);
    if (!loop) break;
    const FlatSection next = flat_section(*loop, section.normal);
    const double whole = std::pow(next.radius / section.radius, 2);
    if (whole > most_growth || (k == first_steps && whole < steep)) break;
    if (k > first_steps && std::pow(next.radius / here.radius, 2) < settled)
      return straightened(surface, here).value_or(section);
    here = next;
  }
  return section;
}

// From a section on the tube outwards while the tube goes on; the order is sections_behind_tip()'s.
std::vector<FlatSection> way_out(const TriangleSurface& surface, FlatSection section) {
  const double full = section.radius;
  std::vector<FlatSection> way{section};
  constexpr int most_steps = 60;
  for (int k = 0; k < most_steps; ++k) {
    const Vec3 next = section.center + 0.08 * full * section.normal;
    const auto loop = closed_section(surface, next, section.normal);
    if (!loop) break;
    FlatSection found = flat_section(*loop, section.normal);
    const double area = std::pow(found.radius / full, 2);
    if (area < 0.97 || area > 1.5 || (found.center - next).norm() > 0.3 * full) break;
    // The axis where the tube is whole on both sides of the section.
    if (const auto turned = straightened(surface, found);
        turned && turned->normal.dot(section.normal) > 0.9 &&
        std::abs(turned->radius - found.radius) < 0.1 * full)
      found = *turned;
    if ((found.center - section.center).dot(section.normal) <= 0) break;
    section = found;
    way.push_back(found);
  }
  // A plane that leans keeps its area although it cuts off the edge of a flat cap: half a radius
  // before it the tube is whole on both sides.
  constexpr double back = 0.5;
  const FlatSection last = way.back();
  std::size_t best = way.size() - 1;
  while (best > 0 && (last.center - way[best].center).dot(last.normal) < back * full) --best;
  std::vector<FlatSection> sections(way.begin() + static_cast<std::ptrdiff_t>(best), way.end());
  while (best > 0) sections.push_back(way[--best]);
  return sections;
}

}  // namespace

std::vector<FlatSection> sections_behind_tip(const TriangleSurface& surface, const Tip& tip) {
  // From well behind the cap, or nearer where the branch is too short for that.
  for (const double radii : {3.4, 2.8, 2.2, 1.7}) {
    auto section = first_section(surface, tip, radii);
    if (section) section = straightened(surface, *section);
    if (section) return way_out(surface, behind_rounding(surface, *section));
  }
  return {};
}

std::vector<FlatSection> sections_behind_cap(const TriangleSurface& surface, const FlatCap& cap,
                                             bool known) {
  constexpr double step = 0.05, deepest = 0.6, widest = 1.5, settled = 1.03;  // radii; area shares
  constexpr double rounding = 0.15;  // radii; behind it a mask's rim is over
  std::vector<FlatSection> sections;
  std::vector<std::pair<double, FlatSection>> within;  // with the distance from `rounding`
  for (double depth = step; depth < deepest; depth += step) {
    const auto section_at = [&](double radii) -> std::optional<FlatSection> {
      const Vec3 place = cap.center - radii * cap.radius * cap.normal;
      const auto loop = closed_section(surface, place, cap.normal);
      if (!loop) return std::nullopt;
      const FlatSection found = flat_section(*loop, cap.normal);
      if (found.radius > std::sqrt(widest) * cap.radius ||
          (found.center - place).norm() > 0.5 * cap.radius)
        return std::nullopt;
      return found;
    };
    const auto here = section_at(depth), behind = section_at(depth + 2 * step);
    if (!here) continue;
    if (behind && std::pow(behind->radius / here->radius, 2) < settled)
      sections.push_back(*here);
    else
      within.emplace_back(std::abs(depth - rounding), *here);
  }
  std::stable_sort(within.begin(), within.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (known)
    for (const auto& [off, section] : within) sections.push_back(section);
  return sections;
}

FlatSection foot_of_branch(const TriangleSurface& surface, const FlatSection& section) {
  FlatSection foot = section;
  std::vector<double> radii{foot.radius};
  constexpr int most_steps = 400;
  for (int k = 0; k < most_steps; ++k) {
    const Vec3 next = foot.center - 0.2 * section.radius * foot.normal;
    const auto loop = closed_section(surface, next, foot.normal);
    if (!loop) break;
    FlatSection found = flat_section(*loop, foot.normal);
    const double before = radii[radii.size() > 5 ? radii.size() - 5 : 0];
    if (found.radius > std::sqrt(1.5) * before || (found.center - next).norm() > 0.5 * before)
      break;
    if (const auto turned = straightened(surface, found);
        turned && turned->normal.dot(foot.normal) > 0.8 && turned->radius < 1.2 * before)
      found = *turned;
    if ((found.center - foot.center).dot(foot.normal) >= 0) break;
    foot = found;
    radii.push_back(foot.radius);
  }
  return foot;
}

bool cut_tip(TriangleSurface& surface, const Tip& tip, const FlatSection& section) {
  const auto loop = closed_section(surface, section.center, section.normal);
  if (!loop) return false;
  const Eigen::VectorXd height =
      (surface.points.rowwise() - section.center.transpose()) * section.normal;
  const std::vector<double> f(height.begin(), height.end());
  const int top = nearest_vertex(surface, tip.place);
  for (const double snap : {0.25, 0.0}) {
    EditTolerances tolerances;
    tolerances.snap = snap;
    SurfaceEditor editor(surface, tolerances);
    const auto cycle = split_level_set(editor, f, loop->edges);
    if (cycle.size() < 6) continue;
    const auto parts = parts_beside(editor, cycle);
    if (parts.size() != 2 || editor.triangles_of(top).empty()) continue;
    const bool first =
        std::binary_search(parts[0].begin(), parts[0].end(), editor.triangles_of(top).front());
    TriangleSurface rest = editor.part(parts[first ? 1 : 0]).surface;
    if (total_area(rest) < total_area(editor.part(parts[first ? 0 : 1]).surface)) continue;
    surface = std::move(rest);
    return true;
  }
  return false;
}

}  // namespace vasorod
