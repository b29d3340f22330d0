#include "judge/metrics.h"

#include <algorithm>
#include <cmath>

#include "geometry/plane_section.h"
#include "geometry/triangle_surface.h"
#include "rod/strain_change.h"

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

// Mid-wall widths and lumen area of the section at a pose; empty if the section is not one closed
// curve of about the rod's radius.
std::optional<SectionShape> section_shape(const PreparedVessel& vessel,
                                          const TriangleSurface& surface, const Pose& section,
                                          double radius) {
  const auto loops = plane_sections(surface, section.position, section.director(3));
  const int around = section_around(loops, section.position, section.director(3));
  if (around < 0 || !loops[static_cast<size_t>(around)].closed) return std::nullopt;
  const SectionLoop& loop = loops[static_cast<size_t>(around)];
  const double disk = M_PI * radius * radius, area = inset_area(loop, -vessel.mid_offset());
  if (area < 0.3 * disk || area > 1.7 * disk)
    return std::nullopt;  // the curve of another branch or of a fork
  return SectionShape{section_widths(loop, section) + 2 * vessel.mid_offset(),
                      inset_area(loop, vessel.thickness() / 2 - vessel.mid_offset())};
}

void judge_sections(const PreparedVessel& vessel, const RodPoses& poses, const Points& current,
                    VesselMetrics& metrics) {
  const RodTree& rod = vessel.vessel.rod;
  const TriangleSurface deformed{current, vessel.vessel.surface.triangles};
  for (const RodBranch& branch : rod.branches) {
    // Arc length since the last section examined.
    double since = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k + 1 < branch.elements.size(); ++k) {
      const RodElement& element = rod.elements[static_cast<size_t>(branch.elements[k])];
      const auto node = static_cast<size_t>(element.second);
      since += element.length;
      if (since < 0.5 * rod.radius[node]) continue;
      since = 0;
      const auto rest =
          section_shape(vessel, vessel.vessel.surface, rod.rest[node], rod.radius[node]);
      if (!rest || rest->lumen <= 0) continue;
      const auto now = section_shape(vessel, deformed, poses[node], rod.radius[node]);
      if (!now) continue;
      // Compares direction by direction: the error of a polygonal section cancels in the ratio of
      // widths in one direction, not in the ratio of the smallest widths.
      if (const double flattening = 1 - (now->widths / rest->widths).minCoeff();
          flattening > metrics.flattening) {
        metrics.flattening = flattening;
        metrics.where["flattening"] = poses[node].position;
      }
      if (const double ratio = now->lumen / rest->lumen; ratio < metrics.smallest_lumen_ratio) {
        metrics.smallest_lumen_ratio = ratio;
        metrics.where["smallest_lumen_ratio"] = poses[node].position;
      }
    }
  }
}

}  // namespace

VertexFields vertex_fields(const PreparedVessel& vessel, const RodPoses& poses) {
  const RodTree& rod = vessel.vessel.rod;
  const auto nodes = node_changes(rod, element_changes(rod, poses));
  const auto n = static_cast<Eigen::Index>(vessel.vessel.binding.size());
  VertexFields fields{Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const RodCoordinates& at = vessel.vessel.binding[static_cast<size_t>(i)];
    const RodElement& element = rod.elements[static_cast<size_t>(at.element)];
    const double t = std::clamp(at.s / element.length, 0.0, 1.0);
    const ElementChange &a = nodes[static_cast<size_t>(element.first)],
                        &b = nodes[static_cast<size_t>(element.second)];
    const Vec6 strain = (1 - t) * a.strain + t * b.strain,
               change = (1 - t) * a.change + t * b.change;
    const double x = at.local[0], y = at.local[1];
    const auto fibre = [&](const Vec6& s) { return s[2] + s[3] * y - s[4] * x; };
    const double rest = fibre(strain - change);
    fields.axial_stretch[i] =
        rest > 0 ? fibre(strain) / rest : 1;  // a fibre at the centre of curvature has zero length
    fields.twist_shear[i] = change[5] * std::hypot(x, y);
  }
  return fields;
}

VesselMetrics vessel_metrics(const PreparedVessel& vessel, const RodPoses& poses,
                             const VertexFields& fields, const Points& current,
                             const Eigen::VectorXd& pressure, bool sections) {
  VesselMetrics metrics;
  metrics.vessel = vessel.spec.name;
  Eigen::Index place = 0;
  metrics.largest_twist_shear = fields.twist_shear.cwiseAbs().maxCoeff(&place);
  if (metrics.largest_twist_shear > 0) metrics.where["largest_twist_shear"] = current.row(place);

  bool first = true;
  for (const ElementChange& element : element_changes(vessel.vessel.rod, poses)) {
    const double stretch = element.strain[2] / (element.strain[2] - element.change[2]);
    if (first || stretch < metrics.stretch[0]) {
      metrics.stretch[0] = stretch;
      metrics.where["smallest_stretch"] = element.middle;
    }
    if (first || stretch > metrics.stretch[1]) {
      metrics.stretch[1] = stretch;
      metrics.where["largest_stretch"] = element.middle;
    }
    if (const double curvature = element.strain.segment<2>(3).norm();
        !element.at_fork && curvature > metrics.largest_curvature) {
      metrics.largest_curvature = curvature;
      metrics.where["largest_curvature"] = element.middle;
    }
    first = false;
  }
  if (sections) judge_sections(vessel, poses, current, metrics);

  if (pressure.size() > 0 && pressure.maxCoeff(&place) > 0) {
    metrics.largest_pressure = pressure[place];
    metrics.where["largest_pressure"] = current.row(place);
    const Eigen::VectorXd areas = vertex_areas({current, vessel.vessel.surface.triangles});
    for (Eigen::Index i = 0; i < pressure.size(); ++i)
      if (pressure[i] > 0) metrics.contact_area += areas[i];
  }
  return metrics;
}

}  // namespace vasorod
