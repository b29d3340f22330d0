// Where walls carry the whole energy, the values along a vessel's axis are those of its wall.
#pragma once

#include <vector>

#include "coupled/coupled_problem.h"
#include "predict/prediction.h"
#include "predict/vessel_wall.h"

namespace vasorod {

/// Gives the rods of solved walls the mean poses of their sections. `sections` and `solutions`: per
/// vessel, its held sections and their poses.
void give_rods_the_walls_means(Prediction& prediction, const std::vector<VesselSections>& sections,
                               const std::vector<std::vector<SectionSolution>>& solutions);

}  // namespace vasorod
