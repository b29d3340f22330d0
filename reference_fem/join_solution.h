// Solves a join on one mesh: the gaps between rim and lips shrink to nothing with the load, the
// directors on both sides of the seam stay free of each other (a hinge).
#pragma once

#include <string>
#include <vector>

#include "reference_fem/join_wall.h"
#include "reference_fem/mid_wall.h"
#include "reference_fem/stepper.h"

namespace vasorod::fem {

/// What acts on one vessel, in the problem's axes.
struct JoinForces {
  struct End {
    std::string name;  ///< as in the scene; empty: held without a condition
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< of the support
    Vec3 center = Vec3::Zero();                        ///< current centre of the end
  };
  std::vector<End> ends;
  Vec3 load = Vec3::Zero();  ///< sum of the dead forces
  Vec3 seam = Vec3::Zero();  ///< force of the seam on the vessel
};

/// Where the solution is evaluated, the same on every mesh.
struct JoinSampling {
  int around = 192;                  ///< points around each tube, even
  int seam = 768;                    ///< points of the seam, a multiple of 4
  std::vector<double> vein, artery;  ///< stations, fractions of the axis
};

/// A solved join, mirrored to the whole, dimensionless, in the problem's axes.
struct JoinSolution {
  StepperSummary summary;  ///< energy: of the whole
  long unknowns = 0;
  int pairs = 0;  ///< tied pairs of nodes
  JoinForces on_vein, on_artery;
  MidWall vein, artery;
  SeenDisplacements seen;
  /// By share of the seam: the vein's rim; the slit's lips, or the second tube's rim.
  Points rim_rest, rim, lips_rest, lips;
  double mesh_seconds = 0;
};

JoinSampling sampling_for(const JoinProblem& problem, const JoinCells& cells);
JoinSolution solve_join(const JoinProblem& problem, const JoinCells& cells,
                        const JoinSampling& sampling, const StepperOptions& options,
                        const Processes& processes = {});

}  // namespace vasorod::fem
