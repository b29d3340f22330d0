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
  const RouteEnds usual = part == "svc" ? opened.cut_route : opened.incision_route;
  std::vector<RouteEnds> routes{usual};
  for (const int end : other_ends(geometry, usual[0]))
    if (end != usual[1]) routes.push_back({usual[0], end});
  for (const RouteEnds& route : routes) {
    const AxisRoute way(geometry, route);
    const auto distance = way.distance_to({at.element, at.s});
    if (!distance) continue;
    hit["along"] = *distance / way.length();
    hit["around_deg"] = std::atan2(at.local.y(), at.local.x()) * (180 / M_PI);
    if (route != usual) hit["route"] = route;
    return;
  }
}

struct Hit {
  std::size_t vessel = 0;
  RayHit first;
};

// The nearest wall before the eye. `wall`: that of a vessel, null where it does not count.
template <class WallOf>
std::optional<Hit> first_hit(std::size_t vessels, const Ray& ray, WallOf&& wall) {
  std::optional<Hit> hit;
  for (std::size_t v = 0; v < vessels; ++v) {
    const RayHits* of = wall(v);
    if (of == nullptr) continue;
    const auto hits = of->along(ray.origin, ray.direction);
    if (hits.empty() || (hit && hits.front().distance >= hit->first.distance)) continue;
    hit = Hit{v, hits.front()};
  }
  return hit;
}

// What the page is told of it at rest and in a result.
Json told(const std::string& vessel, const Vec3& point, double distance) {
  return {{"vessel", vessel},     {"part", nullptr},  {"point", json_of(point)},
          {"distance", distance}, {"along", nullptr}, {"around_deg", nullptr}};
}

}  // namespace

Ray read_ray(const Body& body) {
  return {body.vec3("origin"), body.direction("direction")};
}

Json pick_at_rest(const OpenedScene& opened, const Ray& ray,
                  const std::vector<std::string>& vessels) {
  for (const std::string& name : vessels) opened.vessel(name);
  const auto hit_at = first_hit(opened.walls.size(), ray, [&](std::size_t v) {
    return counts(opened.fitted.vessels[v].spec.name, vessels) ? &opened.walls[v] : nullptr;
  });
  if (!hit_at) return {{"hit", nullptr}};
  const Vec3 point = ray.origin + hit_at->first.distance * ray.direction;
  Json hit = told(opened.fitted.vessels[hit_at->vessel].spec.name, point, hit_at->first.distance);
  if (const std::string part = opened.part_of(hit_at->vessel); !part.empty()) hit["part"] = part;
  add_place(opened, hit_at->vessel, point, hit);
  return {{"hit", hit}};
}

Json pick_in_result(const StoredResult& stored, const Ray& ray,
                    const std::vector<std::string>& vessels) {
  const Result& result = stored.result;
  for (const std::string& name : vessels) stored.vessel(name);
  const auto& walls = stored.walls();
  const auto hit_at = first_hit(walls.size(), ray, [&](std::size_t v) {
    return walls[v] && counts(result.vessels[v].name, vessels) ? &*walls[v] : nullptr;
  });
  if (!hit_at) return {{"hit", nullptr}};
  const VesselResult& vessel = result.vessels[hit_at->vessel];
  const Vec3 point = ray.origin + hit_at->first.distance * ray.direction;
  const auto corner = [&](int k) { return vessel.triangles(hit_at->first.triangle, k); };
  const Vec3 a = vessel.current.row(corner(0)), b = vessel.current.row(corner(1)),
             c = vessel.current.row(corner(2));
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  Vec3 weights(1.0 / 3, 1.0 / 3, 1.0 / 3);
  if (area > 0)
    weights << normal.dot((c - b).cross(point - b)) / area,
        normal.dot((a - c).cross(point - c)) / area, normal.dot((b - a).cross(point - a)) / area;
  Json hit = told(vessel.name, point, hit_at->first.distance);
  hit["triangle"] = hit_at->first.triangle;
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
