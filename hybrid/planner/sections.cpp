#include "planner/sections.h"

#include "geometry/plane_section.h"

namespace vasorod::planner {
namespace {

// `to_lumen`: from the surface inwards to the lumen, length; empty: not known.
void add_vessel(const std::string& name, const TriangleSurface& surface, const SectionPlane& plane,
                const std::optional<double>& to_lumen, Json& vessels) {
  const auto loops = plane_sections(surface, plane.point, plane.normal);
  if (loops.empty()) return;
  Json one{{"name", name},    {"loops", Json::array()}, {"closed", Json::array()},
           {"area", nullptr}, {"perimeter", nullptr},   {"lumen", nullptr}};
  const SectionLoop* largest = nullptr;
  for (const SectionLoop& loop : loops) {
    one["loops"].push_back(json_of(loop.points));
    one["closed"].push_back(loop.closed);
    if (loop.closed && (largest == nullptr || section_area(loop) > section_area(*largest)))
      largest = &loop;
  }
  if (largest != nullptr) {
    one["area"] = section_area(*largest);
    one["perimeter"] = section_perimeter(*largest);
    if (to_lumen) one["lumen"] = inset_area(*largest, *to_lumen);
  }
  vessels.push_back(std::move(one));
}

}  // namespace

SectionPlane read_plane(const Body& body) {
  return {body.vec3("point"), body.direction("normal")};
}

Json section_at_rest(const OpenedScene& opened, const SectionPlane& plane) {
  Json vessels = Json::array();
  for (const PreparedVessel& vessel : opened.fitted.vessels)
    add_vessel(vessel.spec.name, vessel.vessel.surface, plane,
               vessel.spec.wall ? std::optional(vessel.lumen_offset()) : std::nullopt, vessels);
  return {{"vessels", vessels}};
}

Json section_in_result(const StoredResult& stored, const SectionPlane& plane) {
  Json vessels = Json::array();
  for (std::size_t v = 0; v < stored.result.vessels.size(); ++v) {
    const VesselResult& vessel = stored.result.vessels[v];
    if (vessel.current.rows() > 0)
      add_vessel(vessel.name, {vessel.current, vessel.triangles}, plane, stored.to_lumen[v],
                 vessels);
  }
  return {{"vessels", vessels}};
}

}  // namespace vasorod::planner
