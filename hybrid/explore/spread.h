// How far an option's numbers and its place spread over uncertain samples.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace vasorod {

struct ExploreSpec;
struct Row;

/// The samples of one option.
struct Spread {
  int samples = 0,    ///< solved or tried
      converged = 0,  ///< with the status converged
      first = 0;      ///< in which it was the first of the options
  /// 5th and 95th percentile over the converged samples, by criterion and "score"; a value that no
  /// sample has is left out.
  std::map<std::string, std::array<double, 2>> intervals;
};

/// What the samples say of the ranking.
struct RankingSpread {
  std::vector<Spread> options;  ///< in the order of the ranking without uncertainty
  int samples = 0;              ///< of each option
  double tau = 1;  ///< Kendall's tau between the orders with and without, mean over the samples

  /// Share of the samples in which the first option stays first.
  double first_stays() const;
  /// Whether it stays first in at least 95 % of them: a convention.
  bool survives() const { return first_stays() >= 0.95; }
  /// Two sentences.
  std::string text() const;
};

/// The value below which this share of the values lies, linear between the sorted values, of which
/// the first is at 0 and the last at 1. At least one value.
double percentile(std::vector<double> values, double share);

/// `samples[s][k]`: sample s of the k-th option of the ranking. All options have the same samples,
/// so that sample s gives one order of them. An option that did not converge in a sample stands
/// behind those that did, as in the ranking; where none converged, none is the first.
RankingSpread spread_of(const std::vector<std::vector<Row>>& samples, const ExploreSpec& spec);

}  // namespace vasorod
