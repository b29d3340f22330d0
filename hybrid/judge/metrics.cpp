#include "judge/metrics.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle_surface.h"
#include "rod/strain_change.h"
#include "vessel/fork_reach.h"

namespace vasorod {

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
                             const Eigen::VectorXd& pressure,
                             const std::vector<JudgedSection>& sections,
                             const std::vector<char>& opened) {
  VesselMetrics metrics;
  metrics.vessel = vessel.spec.name;
  Eigen::Index place = 0;
  metrics.largest_twist_shear = fields.twist_shear.cwiseAbs().maxCoeff(&place);
  if (metrics.largest_twist_shear > 0) metrics.where["largest_twist_shear"] = current.row(place);

  bool first = true;
  const auto changes = element_changes(vessel.vessel.rod, poses);
  const std::vector<char> at_fork = fork_elements(vessel.vessel);
  for (size_t e = 0; e < changes.size(); ++e) {
    const ElementChange& element = changes[e];
    const double stretch = element.stretch();
    if (first || stretch < metrics.stretch[0]) {
      metrics.stretch[0] = stretch;
      metrics.where["smallest_stretch"] = element.middle;
    }
    if (first || stretch > metrics.stretch[1]) {
      metrics.stretch[1] = stretch;
      metrics.where["largest_stretch"] = element.middle;
    }
    if (const double curvature = element.strain.segment<2>(3).norm();
        !at_fork[e] && !(e < opened.size() && opened[e]) && curvature > metrics.largest_curvature) {
      metrics.largest_curvature = curvature;
      metrics.where["largest_curvature"] = element.middle;
    }
    first = false;
  }
  for (const JudgedSection& section : sections) {
    const Vec3& place_of_section = poses[static_cast<size_t>(section.node)].position;
    if (section.flattening > metrics.flattening) {
      metrics.flattening = section.flattening;
      metrics.where["flattening"] = place_of_section;
    }
    if (section.lumen_ratio() < metrics.smallest_lumen_ratio) {
      metrics.smallest_lumen_ratio = section.lumen_ratio();
      metrics.where["smallest_lumen_ratio"] = place_of_section;
    }
  }

  if (pressure.size() > 0) {
    metrics.largest_pressure = pressure.maxCoeff(&place);
    if (pressure[place] > 0) metrics.where["largest_pressure"] = current.row(place);
    const Eigen::VectorXd areas = vertex_areas({current, vessel.vessel.surface.triangles});
    metrics.contact_area = (pressure.array() > 0).select(areas.array(), 0.0).sum();
  }
  return metrics;
}

}  // namespace vasorod
