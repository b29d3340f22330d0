// The order of the options: from what is known of each criterion to one number.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "explore/row.h"
#include "explore/spread.h"

namespace vasorod {

/// A criterion of the ranking.
struct RankingCriterion {
  std::string name,           ///< as in ExploreSpec::weights and in Row::criteria
      title,                  ///< for readers
      unit;                   ///< empty: none
  double ideal = 0;           ///< the value without penalty: 0, or 1 for shares and stretch
  bool small_is_bad = false;  ///< only values below `ideal` have a penalty
  double weight = 1,          ///< default
      threshold = 1;          ///< default; the value at which the penalty is 1, of stretch |v - 1|
  std::string source;         ///< of the threshold
};

/// All criteria of the ranking, with the defaults of their weights and thresholds.
const std::vector<RankingCriterion>& ranking_criteria();

bool is_ranked(const std::string& criterion);

/// Defaults with what the scene sets, in the order of ranking_criteria().
std::vector<RankingCriterion> criteria_for(const ExploreSpec& spec);

/// 0 at the ideal value, 1 at the threshold, linear and not bounded.
double penalty(const RankingCriterion& criterion, double value);

/// What a reader may make of an option.
enum class Mark {
  good,     ///< converged, in range, no warning, every criterion known and within its threshold
  judge,    ///< converged and in range, but with a warning or a criterion past its threshold
  unknown,  ///< converged, in range, no warning, past no threshold, but criteria are not known
  bad,      ///< another status, or out of the model's range
  none      ///< there is no result
};

/// The mark's name in files.
std::string to_string(Mark mark);

/// A row with its place.
struct RankedRow {
  Row row;
  int rank = 0;      ///< from 1; 0: there is no result to rank
  double score = 0;  ///< sum of weight * penalty over the sum of all weights; NaN: none
  std::vector<std::string> past;  ///< criteria past their thresholds
  Mark mark = Mark::none;
  std::optional<Spread> spread;  ///< of an option whose uncertainty was carried through
};

/// Sorted: converged options before other equilibria, before unfinished ones, before those without
/// a result; within these, later stages before earlier ones; within a stage, options in the model's
/// range first; within these by score, then by the order of `rows`. A criterion that the fidelity
/// does not see adds nothing to the score: scores of different stages are not comparable.
std::vector<RankedRow> ranked(const std::vector<Row>& rows, const ExploreSpec& spec);

}  // namespace vasorod
