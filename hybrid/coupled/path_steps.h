// The times of a path, whose steps may be halved on the way.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace vasorod {

/// The steps from time 0 through given times.
class PathSteps {
 public:
  /// `times`: rising, above 0.
  explicit PathSteps(std::vector<double> times) : times_(std::move(times)) {}

  bool ended() const { return next_ == times_.size(); }
  /// Where the present step leads.
  double time() const { return times_[next_]; }

  /// The next step, from time().
  void go_on() {
    from_ = time();
    if (from_ >= given_to_) given_from_ = from_;
    ++next_;
  }

  /// Puts a time halfway to time() before it. False: it would be shorter than a tenth of the given
  /// step that it is part of.
  bool halve() {
    if (time() > given_to_) given_to_ = time();
    const double half = (time() - from_) / 2;
    if (half < smallest_share * (given_to_ - given_from_)) return false;
    times_.insert(times_.begin() + static_cast<std::ptrdiff_t>(next_), from_ + half);
    return true;
  }

 private:
  static constexpr double smallest_share = 0.1;
  std::vector<double> times_;
  std::size_t next_ = 0;
  double from_ = 0;
  double given_from_ = 0, given_to_ = 0;  // the given step that was halved last
};

}  // namespace vasorod
