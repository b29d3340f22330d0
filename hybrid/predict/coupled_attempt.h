// The ways in which `coupled` may go to a minimum of one prediction.
#pragma once

#include <optional>
#include <vector>

#include "coupled/coupled_problem.h"
#include "predict/carried_bodies.h"
#include "predict/prediction.h"

namespace vasorod {

/// An equilibrium that a result may be.
bool is_minimum(Status status);

/// In a scene in which nothing touches anything, walls may lie in each other.
bool leaves_out_contact(const Prediction& prediction);

/// A prediction with one solution.
struct CoupledOutcome {
  Prediction state;
  CoupledSolution solution;
  double depth = 0;  ///< in which the walls of a minimum pass through something, length
  bool minimum() const { return is_minimum(solution.status); }
  bool crossed() const { return depth > 0; }
};

/// Solves of one prediction, each by another way. The prediction, with its rods solved, must
/// outlive this; solves add their work to it where nothing else is said.
class CoupledAttempt {
 public:
  enum class Walls { fine, coarse };  ///< coarse ones need few digits, and no certificate

  CoupledAttempt(Prediction& prediction, const SolveOptions& options, Walls walls = Walls::fine);

  /// From where coarser walls went; empty: there are none, or they or these found no minimum.
  std::optional<CoupledSolution> from_coarse();

  /// From a closed seam. A vein that folds may end there, too: then in a limited number of updates.
  /// Its work is that of the solution.
  CoupledSolution closed(bool folds);

  /// From a minimum whose walls pass through each other: joined walls touch right up to the seam,
  /// and each itself. `inflation`: pressure in which they found it, to be let out. Its work is that
  /// of the solution.
  CoupledSolution parted(const CoupledSolution& crossed, bool folds, double inflation = 0);

  /// The same from a minimum of coarser walls that pass through nothing. Its work is that of the
  /// solution.
  CoupledSolution refined(const Prediction& coarse, const CoupledSolution& found);

  /// Inflated vessels stay round, so that little of a vein that folds lies in other walls; then
  /// they are parted and let out. `strain`: of their hoops. Empty: the inflated ones found no
  /// minimum.
  std::optional<CoupledSolution> inflated(double strain);

  /// From rest, with a barrier in place of the contacts of walls with themselves. Its work is that
  /// of the solution.
  CoupledSolution guarded();

  /// Along the way of a vein that folds. Its work is that of the solution.
  CoupledSolution on_its_way();

  /// Makes `in` the prediction with this solution.
  void keep(CoupledSolution&& solution, Prediction& in) const;

  /// Adds the solution's work to the prediction.
  CoupledOutcome outcome(CoupledSolution&& solution);

 private:
  CoupledProblem closed_problem(Work& work);
  CoupledSolution parted(CoupledStart&& start, double inflation);
  bool passes_through(const std::vector<Points>& now) const;
  CoupledOptions of_folding(int factorisations = 0) const;
  void only_for_a_start();

  Prediction& prediction_;
  const SolveOptions& options_;
  CoupledOptions coupled_;
  std::vector<VesselSections> sections_;
};

}  // namespace vasorod
