// The surface solve of the `paper` fidelity: joined, touching bodies on rods that were solved
// before.
#pragma once

#include <memory>

#include "bodies/body_problem.h"
#include "bodies/surface_options.h"
#include "bodies/surface_solution.h"

namespace vasorod {

class KeptFactor;

/// `tolerance`: on |sum of forces| / sum over the terms of |their forces|. SurfaceOptions' defaults
/// are those of `paper`.
struct PaperOptions : SurfaceOptions {
  int patience =
      100;  ///< iterations for a tenfold smaller residual before the true Hessian is tried

  std::optional<std::string> is_invalid() const;
};

/// Keeps the constant matrix' factor between solves: the same bodies carried elsewhere by their
/// rods are solved without a new factorisation.
class PaperSolver {
 public:
  explicit PaperSolver(PaperOptions options = {});
  ~PaperSolver();

  /// Minimises the paper's energies [7-9] of all bodies that something moves, joins or touches.
  /// Units: any consistent set; lengths and stiffnesses are scaled before solving. Throws
  /// InputError when sizes do not fit, numbers are not finite or an option is invalid.
  SurfaceSolution solve(const BodyProblem& problem);

 private:
  PaperOptions options_;
  std::unique_ptr<KeptFactor> bound_;
};

/// One solve without anything kept.
SurfaceSolution solve_paper(const BodyProblem& problem, const PaperOptions& options = {});

}  // namespace vasorod
