#include "planner/picks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "vessel/axis_route.h"
#include "vessel/end_conditions.h"

namespace vasorod::planner {
namespace {

bool counts(const std::string& name, const std::vector<std::string>& vessels) {
  return vessels.empty() || std::find(vessels.begin(), vessels.end(), name) != vessels.end();
}

// Where along and around a vessel a point of its wall lies. On the way of the scene's plan where
// the point is on it, else on another way from the same end.
void add_place(const OpenedScene& opened, std::size_t vessel, const Vec3& point, Json& hit) {
  const std::string part = opened.part_of(vessel);
  if (part.empty() || !opened.plan) return;
  const Vessel& geometry = opened.fitted.vessels[vessel].vessel;
  const RodCoordinates at = project(geometry.rod, point);
  const Route usual = part == "svc" ? opened.cut_route : opened.incision_route;
  std::vector<Route> routes{usual};
  for (int end = 0; end < static_cast<int>(geometry.ends.size()); ++end)
    if (end != usual[0] && end != usual[1]) routes.push_back({usual[0], end});
  for (const Route& route : routes) {
    const AxisRoute way(geometry.rod, geometry.ends[index(route[0])].node,
                        geometry.ends[index(route[1])].node);
    const auto distance = way.distance_to({at.element, at.s});
    if (!distance) continue;
    hit["along"] = *distance / way.length();
    hit["around_deg"] = std::atan2(at.local.y(), at.local.x()) * (180 / M_PI);
    if (route != usual) hit["route"] = route;
    return;
  }
}

}  // namespace

Ray read_ray(const Body& body) {
  Ray ray{body.vec3("origin"), body.vec3("direction")};
  const double length = ray.direction.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) body.refuse("direction", "a direction, not zero");
  ray.direction /= length;
  return ray;
}

Json pick_at_rest(const OpenedScene& opened, const Ray& ray,
                  const std::vector<std::string>& vessels) {
  for (const std::string& name : vessels) opened.vessel(name);
  std::size_t nearest = 0;
  RayHit first;
  for (std::size_t v = 0; v < opened.walls.size(); ++v) {
    if (!counts(opened.fitted.vessels[v].spec.name, vessels)) continue;
    const auto hits = opened.walls[v].along(ray.origin, ray.direction);
    if (hits.empty() || (first.triangle >= 0 && hits.front().distance >= first.distance)) continue;
    first = hits.front();
    nearest = v;
  }
  if (first.triangle < 0) return {{"hit", nullptr}};
  const Vec3 point = ray.origin + first.distance * ray.direction;
  Json hit;
  hit["vessel"] = opened.fitted.vessels[nearest].spec.name;
  const std::string part = opened.part_of(nearest);
  hit["part"] = part.empty() ? Json() : Json(part);
  hit["point"] = json_of(point);
  hit["distance"] = first.distance;
  hit["along"] = hit["around_deg"] = nullptr;
  add_place(opened, nearest, point, hit);
  return {{"hit", hit}};
}

Json pick_in_result(const StoredResult& stored, const Ray& ray,
                    const std::vector<std::string>& vessels) {
  const Result& result = stored.result;
  for (const std::string& name : vessels) stored.vessel(name);
  const auto& walls = stored.walls();
  std::size_t nearest = 0;
  RayHit first;
  for (std::size_t v = 0; v < walls.size(); ++v) {
    if (!walls[v] || !counts(result.vessels[v].name, vessels)) continue;
    const auto hits = walls[v]->along(ray.origin, ray.direction);
    if (hits.empty() || (first.triangle >= 0 && hits.front().distance >= first.distance)) continue;
    first = hits.front();
    nearest = v;
  }
  if (first.triangle < 0) return {{"hit", nullptr}};
  const VesselResult& vessel = result.vessels[nearest];
  const Vec3 point = ray.origin + first.distance * ray.direction;
  const auto corner = [&](int k) { return vessel.triangles(first.triangle, k); };
  const Vec3 a = vessel.current.row(corner(0)), b = vessel.current.row(corner(1)),
             c = vessel.current.row(corner(2));
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  Vec3 weights(1.0 / 3, 1.0 / 3, 1.0 / 3);
  if (area > 0)
    weights << normal.dot((c - b).cross(point - b)) / area,
        normal.dot((a - c).cross(point - c)) / area, normal.dot((b - a).cross(point - a)) / area;
  Json hit;
  hit["vessel"] = vessel.name;
  hit["part"] = nullptr;
  hit["point"] = json_of(point);
  hit["distance"] = first.distance;
  hit["along"] = hit["around_deg"] = nullptr;
  hit["triangle"] = first.triangle;
  hit["weights"] = json_of(weights);
  hit["values"] = Json::object();
  for (const ShownField& field : stored.fields) {
    const Eigen::VectorXd& values = vessel.*field.values;
    if (values.size() != vessel.current.rows()) continue;
    double value = 0;
    for (int k = 0; k < 3; ++k) value += weights[k] * values[corner(k)];
    hit["values"][field.name] = value * field.shown_per;
  }
  return {{"hit", hit}};
}

}  // namespace vasorod::planner
