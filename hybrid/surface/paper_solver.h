// The surface solve of the `paper` fidelity: joined, touching bodies on rods that were solved before.
#pragma once

#include <memory>

#include "surface/paper_problem.h"

namespace vasorod {

class KeptFactor;

/// Keeps the constant matrix' factor between solves: the same bodies carried elsewhere by their rods are
/// solved without a new factorisation.
class PaperSolver {
 public:
  explicit PaperSolver(PaperOptions options = {});
  ~PaperSolver();

  /// Minimises the paper's energies [7-9] of all bodies that something moves, joins or touches. Units: any
  /// consistent set; lengths and stiffnesses are scaled before solving. Throws InputError when sizes do not
  /// fit or numbers are not finite.
  PaperSolution solve(const PaperProblem& problem);

 private:
  PaperOptions options_;
  std::unique_ptr<KeptFactor> bound_;
};

/// One solve without anything kept.
PaperSolution solve_paper(const PaperProblem& problem, const PaperOptions& options = {});

}  // namespace vasorod
