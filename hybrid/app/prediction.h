// A scene on its way from vessels at rest to a prediction: what the stages of `solve` hand on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/result.h"
#include "rod/newton.h"
#include "surface/paper_problem.h"
#include "surgery/glenn.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"
#include "wall/coupled_problem.h"

namespace vasorod {

/// One vessel through all stages. Obstacles have only `prepared` and `positions`.
struct PredictedVessel {
  PreparedVessel prepared;
  VesselConditions conditions;
  RodSolution rod;           ///< poses at rest and nothing else where the rod was not solved
  bool rod_solved = false;   ///< false: nothing moves or loads it, it stays as it is
  Points positions;          ///< deformed surface; empty at fidelity rod
  Eigen::VectorXd pressure;  ///< contact, stress, per vertex; empty: none modelled
};

struct Prediction {
  const Scene* scene = nullptr;
  Fidelity fidelity = Fidelity::paper;
  bool certified = false;                ///< the surfaces' smallest curvature was asked for
  std::vector<PredictedVessel> vessels;  ///< in the scene's order
  std::optional<GlennOperation> glenn;
  std::optional<PaperProblem> problem;   ///< bodies in the vessels' order
  std::optional<PaperSolution> surface;  ///< fidelities paper and coupled: the one of `coupled` is moved here
  std::optional<CoupledSolution> coupled;
  std::vector<Stage> stages;
  std::map<std::string, std::string> left_out;
};

/// Where the vessel of that name is in `vessels`.
size_t vessel_named(const Prediction& prediction, const std::string& name);

/// The node of the vessel's rod that the join poses: the vein's mouth; -1 for every other vessel.
int mouth_of(const Prediction& prediction, const PredictedVessel& vessel);

/// Nodes whose sections a support keeps rigid. What poses the vein's mouth is the join: its section is not
/// rigid.
std::vector<int> rigid_nodes(const Prediction& prediction, const PredictedVessel& vessel);

}  // namespace vasorod
