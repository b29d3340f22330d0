// Brings a start from coarser walls near its minimum. It misses most beside the seam and where
// walls press on each other: what is near there comes to rest in a patch (CoupledStack::narrow()),
// at a small part of what it costs in the whole.
//
// 1. What is near the seam comes to rest, roughly, without multipliers or another search of
//    contacts: in a larger patch a vein would bend into what it does not touch.
// 2. All walls go towards their minimum with the convex part of one Hessian.
// 3. What is near the seam and the contacts comes to rest; then the pressures of contacts are
//    updated and these found again, a few times, or, where walls crumple, until they are to be
//    searched rarely (CoupledOptions::hold_after). The seam's multipliers are left to a minimum of
//    all walls: they are updated once, and what gap that leaves depends on where.
#pragma once

#include <functional>

#include "coupled/coupled_path.h"

namespace vasorod {

/// One smooth start of a CoupledStack that has a seam.
class SmoothStart {
 public:
  /// `stack` and `path` must outlive this; the path is at its start, and contacts are searched.
  /// `minimising`: options of all minimisations, of which tolerances and limits are chosen here.
  /// `count` is called after each.
  SmoothStart(CoupledStack& stack, CoupledPath& path, const CoupledMinimiserOptions& minimising,
              std::function<void(const CoupledMinimiserSummary&)> count);

  /// Returns `converged`, whatever was reached, or `interrupted`.
  Status bring_near();

  /// Whether the patch of seam and contacts came to rest: the walls are near a minimum.
  bool is_near() const { return near_; }
  /// Whether its walls pass through each other (CoupledOptions::passes_through) before any
  /// pressure was updated; then none was.
  bool is_crossed() const { return crossed_; }
  /// How often contacts were updated and searched in the patch.
  int updates() const { return updates_; }

 private:
  bool minimise(const CoupledMinimiserOptions& options);
  void settle_patch();

  CoupledStack& stack_;
  CoupledPath& path_;
  CoupledMinimiserOptions minimising_;
  std::function<void(const CoupledMinimiserSummary&)> count_;
  CoupledMinimiserSummary last_;
  int updates_ = 0;
  bool near_ = false, crossed_ = false;
};

}  // namespace vasorod
