// The wall of one vessel without branches as sections of harmonics: minimum of its energy, on finer
// and finer spaces until the shape changes by less than asked.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <vasorod/status.h>

#include "numerics/solver_options.h"
#include "numerics/stress_free_search.h"
#include "numerics/work.h"
#include "sections/fit_sections.h"
#include "sections/section_system.h"

namespace vasorod {

/// Input of solve_sections, in any one system of units.
struct SectionProblem {
  std::string name;           ///< of the vessel, for messages
  Points rest;                ///< vertices of the given surface, n x 3
  SectionParameters at;       ///< of the vertices
  Eigen::VectorXd thickness;  ///< of the wall, per vertex
  double mid_offset = 0;      ///< from the given surface outward to mid-wall
  Material material;
  double radius = 0;  ///< mean radius: the unit of length
  double length = 0;  ///< of the axis
  HeldEnds ends;
  LumenPressure pressure;       ///< the wall at rest is in equilibrium with `scan`, stress
  double axial_prestretch = 1;  ///< and with this stretch along its axis
  /// Times at which the path of motions and loads is solved; the last is 1.
  std::vector<double> times{1};
  /// Where the search begins at a time of the path.
  struct Start {
    Points points;              ///< of the vertices, n x 3
    std::array<Pose, 2> poses;  ///< of the ends: rotation from rest, position
  };
  std::function<Start(double t)> start;
};

/// Options of solve_sections.
struct SectionOptions : SolverOptions {
  /// Asked of the estimated RMS error of the shape from the choice of harmonics and splines, over
  /// the radius. A tenth of what the wall's theory leaves against finite elements.
  double error = 1e-4;
  /// On the gradient over the sum of its parts (SectionNewtonOptions::tolerance).
  double tolerance = 1e-10;
  /// Of the moment of a turning load over the largest moment, between minimisations.
  double moment_tolerance = 1e-8;
  int max_iterations = 100;  ///< Newton's, per space
  int degree = 3;            ///< of the B-splines
  /// The strain (SectionEnergy::rms_prestrain) up to which the prestress is linear.
  double linear_prestrain_up_to = largest_linear_prestrain;
  /// Empty when the options are valid, else one sentence.
  std::optional<std::string> is_invalid() const;
};

/// Result of solve_sections, in the problem's units.
struct SolvedSections {
  Status status = Status::iteration_limit;
  Points positions;                                    ///< of the vertices, n x 3
  std::array<std::optional<SectionSolution>, 2> ends;  ///< empty: free
  SectionEnergy::Report report;                        ///< energies, extremes of the faces
  Vec3 lumen = Vec3::Zero();  ///< force of the pressure on the wall, without the lids of its ends
  double residual = 0, balance = 0;  ///< balance: |sum of forces| over the largest
  bool smallest_curvature_positive = false;
  int harmonics = 0, spans = 0, iterations = 0;
  /// Estimated RMS error from the choice of both, over the radius; infinite with one space only.
  double error = 0;
  /// RMS distance of the vertices from the shape at rest, over the radius. They are carried along.
  double fit_error = 0;
  /// The largest displacement whose stress is the wall's prestress, over the radius.
  double prestress_displacement = 0;
  std::optional<int> prestress_steps;  ///< as in SeenSections
  Work work;
  std::vector<std::string> notes;
};

/// Throws InputError (one sentence) where an option is invalid.
SolvedSections solve_sections(const SectionProblem& problem, const SectionOptions& options = {});

}  // namespace vasorod
