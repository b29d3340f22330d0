// Contacts of crumpled walls may be found in turn in two or more ways without end: the set of those
// that press changes with each search, and where walls lie on each other over a large part their
// forces settle slowly. After many updates of the multipliers they are therefore searched at few
// updates only, each time after longer, and accepted at ten times their tolerances.
#pragma once

#include <optional>
#include <string>

#include "data/sentence.h"

namespace vasorod {

/// Of one minimum: at which updates contacts are searched.
class LateContacts {
 public:
  /// Multiple of the tolerances.
  static constexpr double slackness = 10;
  /// In mean edges: a state that was not searched is accepted where a last search finds walls in
  /// each other by no more.
  static constexpr double largest_overlap = 0.05;

  /// The patience with walls that stick after so many updates.
  static constexpr int patience_with_held(int hold_after) { return 2 * hold_after; }

  /// `patience`: the updates, counted from 1, after which it is late.
  explicit LateContacts(int patience) : patience_(patience) {}

  bool is_late(int update) const { return update > patience_; }

  /// Whether to search at this update; to be asked once at each.
  bool search(int update) {
    if (!is_late(update)) return true;
    if (update < next_) return false;
    next_ = update + between_;
    between_ = static_cast<int>(longer * between_);
    return true;
  }

  /// The sentence for the certificate; `overlap`: what a last search found, in mean edges.
  static std::string note(std::optional<double> overlap) {
    return "contacts that still open and close were accepted at ten times their tolerance" +
           (overlap ? "; a last search found walls in each other by " + number_text(*overlap, 2) +
                          " mean edges"
                    : std::string());
  }

 private:
  static constexpr double longer = 1.5;
  int patience_, next_ = 0, between_ = 10;
};

}  // namespace vasorod
