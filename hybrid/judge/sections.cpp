#include "judge/sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "data/index.h"
#include "geometry/plane_section.h"

namespace vasorod {
namespace {

constexpr int directions = 36;  // in half a turn
using Widths = Eigen::Array<double, directions, 1>;

// Per direction of the section's frame: the distance of the two lines perpendicular to it that
// bound the curve.
Widths section_widths(const SectionLoop& loop, const Pose& section) {
  Widths widths;
  for (int k = 0; k < directions; ++k) {
    const double angle = M_PI * k / directions;
    const Vec3 direction =
        std::cos(angle) * section.director(1) + std::sin(angle) * section.director(2);
    const Eigen::VectorXd along = loop.points * direction;
    widths[k] = along.maxCoeff() - along.minCoeff();
  }
  return widths;
}

struct SectionShape {
  Widths widths;
  double lumen;
};

// Mid-wall widths and lumen area of a curve in the section's plane.
SectionShape shape_of(const PreparedVessel& vessel, const SectionLoop& loop, const Pose& section) {
  return {section_widths(loop, section) + 2 * vessel.mid_offset(),
          inset_area(loop, vessel.lumen_offset())};
}

// Empty if the section is not one closed curve of about the rod's radius.
std::optional<SectionShape> rest_shape(const PreparedVessel& vessel, const PlaneSections& surface,
                                       const Pose& section, double radius) {
  const auto loops = surface.across(section.position, section.director(3));
  const int around = section_around(loops, section.position, section.director(3));
  if (around < 0 || !loops[index(around)].closed) return std::nullopt;
  const SectionLoop& loop = loops[index(around)];
  const double disk = M_PI * radius * radius, area = inset_area(loop, -vessel.mid_offset());
  if (area < 0.3 * disk || area > 1.7 * disk)
    return std::nullopt;  // the curve of another branch or of a fork
  return shape_of(vessel, loop, section);
}

// The material points of a deformed curve, in the rest shape.
Points at_rest(const SectionLoop& loop, const Points& rest, const Points& current) {
  Points points(loop.points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto [a, b] = loop.edges[static_cast<size_t>(i)];
    const Vec3 edge = current.row(b) - current.row(a);
    const Vec3 from_a = loop.points.row(i) - current.row(a);
    const double t = edge.squaredNorm() > 0 ? from_a.dot(edge) / edge.squaredNorm() : 0;
    points.row(i) = (1 - t) * rest.row(a) + t * rest.row(b);
  }
  return points;
}

// Empty if no closed curve of the deformed section's plane goes around the rod at rest within one
// radius of the node.
std::optional<SectionShape> present_shape(const PreparedVessel& vessel, const Points& current,
                                          const PlaneSections& surface, const Pose& rest,
                                          const Pose& now, double radius) {
  const auto loops = surface.across(now.position, now.director(3));
  const SectionLoop* closest = nullptr;
  double smallest = radius;
  for (const SectionLoop& loop : loops) {
    if (!loop.closed) continue;
    const Points points = at_rest(loop, vessel.vessel.surface.points, current);
    if (std::abs(section_winding(points, rest.position, rest.director(3))) != 1) continue;
    const Vec3 middle = points.colwise().mean();
    const double away = (middle - rest.position).norm();
    if (away >= smallest) continue;
    smallest = away;
    closest = &loop;
  }
  if (!closest) return std::nullopt;
  return shape_of(vessel, *closest, now);
}

}  // namespace

std::vector<JudgedSection> judged_sections(const PreparedVessel& vessel, const RodPoses& poses,
                                           const Points& current) {
  const RodTree& rod = vessel.vessel.rod;
  const TriangleSurface now_surface{current, vessel.vessel.surface.triangles};
  const PlaneSections at_rest_planes(vessel.vessel.surface), now_planes(now_surface);
  std::vector<JudgedSection> sections;
  for (size_t b = 0; b < rod.branches.size(); ++b) {
    const RodBranch& branch = rod.branches[b];
    double abscissa = 0;
    // Arc length since the last section examined.
    double since = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k + 1 < branch.elements.size(); ++k) {
      const RodElement& element = rod.elements[index(branch.elements[k])];
      const size_t node = index(element.second);
      abscissa += element.length;
      since += element.length;
      if (since < 0.5 * rod.radius[node]) continue;
      since = 0;
      const auto rest = rest_shape(vessel, at_rest_planes, rod.rest[node], rod.radius[node]);
      if (!rest || rest->lumen <= 0) continue;
      const auto now =
          present_shape(vessel, current, now_planes, rod.rest[node], poses[node], rod.radius[node]);
      if (!now) continue;
      // Compares direction by direction: the error of a polygonal section cancels in the ratio of
      // widths in one direction, not in the ratio of the smallest widths.
      sections.push_back({static_cast<int>(b), element.second, abscissa,
                          1 - (now->widths / rest->widths).minCoeff(), now->lumen, rest->lumen});
    }
  }
  return sections;
}

LumenAlong lumen_along(const RodTree& rod, const std::vector<JudgedSection>& sections) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  LumenAlong along{std::vector<double>(rod.rest.size(), none),
                   std::vector<double>(rod.rest.size(), none)};
  for (size_t b = 0; b < rod.branches.size(); ++b) {
    std::vector<const JudgedSection*> own;
    for (const JudgedSection& section : sections)
      if (section.branch == static_cast<int>(b)) own.push_back(&section);
    if (own.empty()) continue;
    const RodBranch& branch = rod.branches[b];
    double abscissa = 0;
    for (size_t k = 0; k < branch.nodes.size(); ++k) {
      if (k > 0) abscissa += rod.elements[index(branch.elements[k - 1])].length;
      if (k == 0 && branch.parent >= 0) continue;  // a node of the parent
      const size_t node = index(branch.nodes[k]);
      const auto after = std::find_if(own.begin(), own.end(), [&](const JudgedSection* section) {
        return section->abscissa >= abscissa;
      });
      const JudgedSection& right = after == own.end() ? *own.back() : **after;
      const JudgedSection& left = after == own.begin() ? *own.front() : **(after - 1);
      const double gap = right.abscissa - left.abscissa;
      const double outside =
          std::min(std::abs(abscissa - left.abscissa), std::abs(right.abscissa - abscissa));
      // A wide gap between two sections is a fork or an incision.
      if (outside > rod.radius[node]) continue;
      const double t = gap > 0 ? std::clamp((abscissa - left.abscissa) / gap, 0.0, 1.0) : 0.0;
      along.area[node] = (1 - t) * left.lumen + t * right.lumen;
      along.flattening[node] = (1 - t) * left.flattening + t * right.flattening;
    }
  }
  return along;
}

}  // namespace vasorod
