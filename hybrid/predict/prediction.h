// A scene between vessels at rest and the prediction: the data passed between stages of `predict`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/predict.h>

#include "bodies/surface_solution.h"
#include "judge/crossings.h"
#include "predict/stopwatch.h"
#include "rod/newton.h"
#include "surgery/operation.h"
#include "vessel/end_conditions.h"
#include "vessel/prepared_vessel.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// One vessel through all stages. Obstacles have only `prepared` and `positions`.
struct PredictedVessel {
  PreparedVessel prepared;      ///< surface, rod and wall at rest
  VesselConditions conditions;  ///< supports and loads
  RodSolution rod;              ///< only the rest poses if the rod was not solved
  bool rod_solved = false;      ///< false: nothing moves or loads the vessel, it stays at rest
  bool stump = false;           ///< an obstacle that a Glenn operation left of its vein
  Points positions;             ///< deformed surface, n x 3; empty at fidelity rod
  Eigen::VectorXd pressure;     ///< contact pressure per vertex, stress; empty: not modelled
};

/// The solution of a fidelity with surface energies.
struct SolvedSurfaces {
  SurfaceSolution solution;                         ///< bodies in the vessels' order
  std::optional<bool> smallest_curvature_positive;  ///< empty: not requested
  std::vector<std::string> notes;                   ///< sentences for the certificate
  std::vector<std::string> terms;                   ///< terms of the energy for ModelReport
  /// True: the rods were only the start; status, certificate, supports and energy are those of the
  /// surfaces, and the members below are filled.
  bool carry_everything = false;
  std::vector<EndReaction> ends;    ///< supports' and loads' forces on the walls
  std::vector<Vec3> load;           ///< per vessel: sum of its dead loads, force
  std::vector<FaceExtremes> faces;  ///< per vessel: strains of its wall's faces; empty: no walls
};

/// A crossing of the predicted surfaces with the names of its vessels.
struct NamedCrossing {
  std::string a, b;
  Crossing crossing;
};

/// A scene while it is solved.
struct Prediction {
  const Scene* scene = nullptr;          ///< the scene that is solved
  std::string fidelity;                  ///< name of the fidelity
  std::vector<PredictedVessel> vessels;  ///< in the scene's order, then the stump
  /// The vessels before a Glenn operation; empty: there is none, or the fidelity needs none.
  std::vector<PreparedVessel> whole;
  std::optional<Operation> operation;      ///< the operation; empty: none
  std::optional<SolvedSurfaces> surfaces;  ///< empty at fidelities without surface energies
  /// Of the vessels where they are now; empty: they were not searched for any.
  std::optional<std::vector<NamedCrossing>> crossings;
  std::vector<std::string> notes;               ///< sentences for the certificate
  std::vector<Stage> stages;                    ///< for the report's pictures
  std::map<std::string, std::string> left_out;  ///< what was left out, and why
  std::map<std::string, std::string> inputs;    ///< InputHashes::hashes()
  std::string scene_hash;                       ///< InputHashes::scene()
  Status status = Status::converged;            ///< the best that its result may claim
  Stopwatch watch;                              ///< seconds of the stages so far
  Work work;  ///< of the rods at fidelity `rod`, of the surfaces at others
};

/// Index of the vessel with that name in `vessels`.
size_t vessel_named(const Prediction& prediction, const std::string& name);

/// The vessel's surface as its rod carries it, n x 3; at rest where the rod was not solved.
Points carried_surface(const PredictedVessel& vessel);

/// The node of the vessel's rod that a join places: that of a rim; -1: there is none.
int mouth_of(const Prediction& prediction, const PredictedVessel& vessel);

/// Nodes whose sections a support keeps rigid. A rim is placed by its join, so its section is not
/// rigid.
std::vector<int> rigid_nodes(const Prediction& prediction, const PredictedVessel& vessel);

}  // namespace vasorod
