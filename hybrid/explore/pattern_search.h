// A search for a better option between the listed values. Compass search (Kolda, Lewis and Torczon
// 2003, "Optimization by direct search"): it takes only which option is better, so that one that
// cannot be built or does not converge is simply worse, and all options of a poll can be solved at
// once, which the simplices of Nelder and Mead cannot.
#pragma once

#include <vector>

#include "explore/options.h"

namespace vasorod {

/// Polls one step up and down in each listed number, moves to the best where it is better, halves
/// the steps where none is. Steps begin with half the smallest gap of the listed values and end
/// below a 32nd of it; no option leaves the range of the listed values.
class PatternSearch {
 public:
  /// `incision`: as in options_of().
  PatternSearch(std::vector<RefinedKey> keys, Option start, PickSpec incision);

  /// The options around the centre, at most two for each number, none twice.
  std::vector<Option> poll() const;
  /// After a poll: whether one of its options is better than the centre, and the new centre.
  void go_on(bool better, const Option& centre);
  /// Whether the steps are too small to go on, or there is no number to change.
  bool ended() const;

 private:
  std::vector<RefinedKey> keys_;
  Option centre_;
  PickSpec incision_;
  double step_ = 0.5;  // times the gap
};

}  // namespace vasorod
