// Brings the seam of a vessel that folds together along its way (PaperWay).
//
// The walls start at rest, where nothing passes through anything, and neither contact nor its guard
// (crossing_guard.h) lets them pass on the way. The rods' positions p' and the offsets between the
// seam's vertices go in steps; at each the walls find a rough minimum. Once the seam is closed,
// joined walls meet right up to it. What lies in each other there is brought apart in steps too
// (BodyContacts::allow); where that fails, contact ends beside the seam as it does elsewhere.
#pragma once

#include <functional>
#include <string>

#include "paper/paper_stack.h"

namespace vasorod {

/// One way of the seam of a PaperStack.
class PaperClosing {
 public:
  /// `stack` and `way` must outlive this. `minimising`: options of all minimisations, of which
  /// tolerances and limits are chosen here. `count` is called after each.
  PaperClosing(PaperStack& stack, const PaperWay& way, const PaperMinimiserOptions& minimising,
               std::function<void(const PaperMinimiserSummary&)> count);

  /// Goes to time 1, where the stack is a start for the minimum: `converged`. `iteration_limit`
  /// where walls stay deep in each other, `interrupted` where a minimisation was; throws
  /// Interruption where a factorisation was.
  Status run();

  /// A sentence for the certificate about the way.
  std::string note() const;

 private:
  Status settle();
  Status bring_apart();
  void search();

  PaperStack& stack_;
  const PaperWay& way_;
  PaperMinimiserOptions minimising_;
  std::function<void(const PaperMinimiserSummary&)> count_;
  double reached_ = 0;  // the time of the last state that was found
  int steps_ = 0;
};

}  // namespace vasorod
