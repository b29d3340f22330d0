// The opened scene, or the opened result, in words of the page: GET api/scene.
#pragma once

#include "planner/opened_scene.h"
#include "planner/stored_result.h"

namespace vasorod::planner {

Json scene_answer(const OpenedScene& opened);
Json result_answer(const std::string& id, const std::string& name, const StoredResult& stored);

}  // namespace vasorod::planner
