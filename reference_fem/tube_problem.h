// A scene's single tube as a dimensionless finite-element problem: lengths over the mid-wall radius
// at the start, stresses over the axial modulus. Scenes that the reference cannot solve are refused
// here with one sentence.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "reference_fem/mid_wall.h"
#include "reference_fem/scene_parts.h"
#include "reference_fem/stepper.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {

/// The finite-element models.
enum class ModelKind { solid, shell };

/// The tube with its ends, dimensionless.
struct TubeProblem {
  std::string vessel;
  TubeShape shape;
  Moduli moduli;
  LawKind law = LawKind::biot;
  SeenState seen;  ///< its pressures act on the inner face
  std::vector<EndProblem> ends;
  double length_unit = 1;  ///< scene's length per dimensionless length
  double stress_unit = 1;  ///< scene's stress per dimensionless stress
  double force_unit() const { return stress_unit * length_unit * length_unit; }
  double moment_unit() const { return force_unit() * length_unit; }
  double energy_unit() const { return moment_unit(); }
};

/// Throws InputError. `law` overrides the scene's.
TubeProblem read_problem(const Scene& scene, ModelKind kind, std::optional<LawKind> law);

/// A solved tube.
struct TubeSolution {
  StepperSummary summary;
  long unknowns = 0;
  /// Per end: force and moment of support and load together, about the current centre.
  std::vector<Vec6> end_force;
  std::vector<Pose> end_pose;
  MidWall wall;
  SeenShare seen;  ///< behind the prestress
  double mesh_seconds = 0;
};

/// A structured mesh with cells that shrink towards the ends, or the cells of a gmsh file.
struct TubeMesh {
  int around = 8, along = 12, degree = 3;
  std::string file;  ///< empty: structured; else `around` and `along` are the file's equivalents
  int halvings = 0;  ///< refinements of the file's cells
};

/// Solves on one mesh. The mid-wall is sampled at `points_around` x `stations` points.
TubeSolution solve_tube(const TubeProblem& problem, ModelKind kind, const TubeMesh& mesh,
                        int points_around, int stations, const StepperOptions& options,
                        const Processes& processes = {});

}  // namespace vasorod::fem
