// The surface solve of the `paper` fidelity: joined and touching bodies on rods solved before.
#pragma once

#include <memory>

#include "bodies/body_problem.h"
#include "bodies/seam_way.h"
#include "bodies/surface_options.h"
#include "bodies/surface_solution.h"

namespace vasorod {

class KeptFactor;
struct Work;

/// Options of the `paper` surface solve. `tolerance` applies to |sum of forces| / sum over the
/// terms of |forces of the term|. The defaults of SurfaceOptions are those of `paper`.
struct PaperOptions : SurfaceOptions {
  /// Number of iterations for a tenfold reduction of the residual before the true Hessian is tried.
  int patience = 100;
  /// Multiplier updates after which walls that press on each other stick between searches
  /// (bodies/contact_pair.h). What settles at all has mostly settled by then. After twice as many,
  /// contacts are searched at a tenth of the updates only, later at fewer.
  int hold_after = 30;
  /// Called with the state so far (status interrupted) before a factorisation, at most once a
  /// second. May be empty.
  std::function<void(SurfaceSolution&&)> keep;

  /// Empty when the options are valid, else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

/// The way of a vessel that has to fold, from rest, where nothing passes through anything.
struct PaperWay {
  /// Positions of the bodies given by the rods at time t, in [0, 1]; at time 1 those of the
  /// problem.
  std::function<std::vector<CarriedBody>(double t)> carried;
  SeamWay seam;
};

/// Surface solver that keeps the factor of the constant matrix between solves: the same bodies at
/// other positions of their rods need no new factorisation.
class PaperSolver {
 public:
  explicit PaperSolver(PaperOptions options = {});
  ~PaperSolver();

  /// Minimises the paper's energies [7-9] of all bodies that are moved, joined or touched. Units:
  /// any consistent set; lengths and stiffnesses are scaled before solving. Throws InputError when
  /// array sizes do not match, numbers are not finite or an option is invalid.
  /// `way`: the bodies go along it from rest to a start; else they start at p'.
  SurfaceSolution solve(const BodyProblem& problem, const PaperWay* way = nullptr);

 private:
  PaperOptions options_;
  std::unique_ptr<Work> work_;  // of the present solve
  std::unique_ptr<KeptFactor> bound_;
};

/// A single solve; nothing is kept afterwards.
SurfaceSolution solve_paper(const BodyProblem& problem, const PaperOptions& options = {});

}  // namespace vasorod
