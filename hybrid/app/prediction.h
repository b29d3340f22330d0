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
  std::optional<PaperSolution> surface;  ///< fidelities paper and coupled
  std::optional<CoupledSolution> coupled;
  std::vector<Stage> stages;
  std::map<std::string, std::string> left_out;
};

}  // namespace vasorod
