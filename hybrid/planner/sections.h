// Planes through the vessels: the curves that the page draws as slices.
#pragma once

#include "planner/opened_scene.h"
#include "planner/stored_result.h"

namespace vasorod::planner {

/// The plane of a request: its normal is made a unit vector. Throws Refusal for none.
struct SectionPlane {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
};
SectionPlane read_plane(const Body& body);

/// {vessels: [{name, loops, closed, area, perimeter, lumen}]} of the vessels that the plane meets.
Json section_at_rest(const OpenedScene& opened, const SectionPlane& plane);
Json section_in_result(const StoredResult& stored, const SectionPlane& plane);

}  // namespace vasorod::planner
