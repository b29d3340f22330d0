// What the user's ray meets first.
#pragma once

#include <string>
#include <vector>

#include "planner/opened_scene.h"
#include "planner/stored_result.h"

namespace vasorod::planner {

/// The ray of a request: its direction is made a unit vector. Throws Refusal for none.
struct Ray {
  Vec3 origin = Vec3::Zero(), direction = Vec3::UnitZ();
};
Ray read_ray(const Body& body);

/// {hit: null | {vessel, part, point, distance, along, around_deg}} on the vessels at rest.
/// `vessels`: names of those that count; empty: all.
Json pick_at_rest(const OpenedScene& opened, const Ray& ray,
                  const std::vector<std::string>& vessels);

/// The same on the deformed vessels of a result, with triangle, weights and the fields' values.
Json pick_in_result(const StoredResult& stored, const Ray& ray,
                    const std::vector<std::string>& vessels);

}  // namespace vasorod::planner
