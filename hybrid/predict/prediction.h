// A scene on its way from vessels at rest to a prediction: what the stages of `predict` hand on.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/predict.h>

#include "bodies/surface_solution.h"
#include "rod/newton.h"
#include "surgery/glenn.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"

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

/// What a fidelity whose surfaces have energies found.
struct SolvedSurfaces {
  SurfaceSolution solution;                         ///< bodies in the vessels' order
  std::optional<bool> smallest_curvature_positive;  ///< empty: not asked for
  std::vector<std::string> notes;                   ///< sentences for the certificate
  std::vector<std::string> terms;                   ///< of the energy, as `model` lists them
  /// True: the rods were no more than the start; status, certificate, supports and energy are the
  /// surfaces' alone, and the two members below are filled.
  bool carry_everything = false;
  std::vector<EndReaction> ends;  ///< what supports and loads do to the walls
  std::vector<Vec3> load;         ///< per vessel: the dead loads on it, force
};

struct Prediction {
  const Scene* scene = nullptr;
  std::string fidelity;
  std::vector<PredictedVessel> vessels;  ///< in the scene's order
  std::optional<GlennOperation> glenn;
  std::optional<SolvedSurfaces> surfaces;  ///< none at fidelities without surface energies
  std::vector<std::string> notes;          ///< sentences for the certificate
  std::vector<Stage> stages;
  std::map<std::string, std::string> left_out;
};

/// Where the vessel of that name is in `vessels`.
size_t vessel_named(const Prediction& prediction, const std::string& name);

/// The node of the vessel's rod that the join poses: the vein's mouth; -1 for every other vessel.
int mouth_of(const Prediction& prediction, const PredictedVessel& vessel);

/// Nodes whose sections a support keeps rigid. What poses the vein's mouth is the join: its section
/// is not rigid.
std::vector<int> rigid_nodes(const Prediction& prediction, const PredictedVessel& vessel);

}  // namespace vasorod
