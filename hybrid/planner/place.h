// A quick drawing of a plan on the vessels at rest: where it cuts and where it opens.
#pragma once

#include "planner/opened_scene.h"

namespace vasorod::planner {

/// {cut: {point, normal, outline}, incision: {point, ends, outline, length}, problem}. `problem` is
/// what a solve would refuse; then what can be drawn without building the operation is drawn:
/// `cut` or `incision` is null where nothing can, `outline` of the incision is empty.
Json placed_plan(const OpenedScene& opened, const Plan& plan);

}  // namespace vasorod::planner
