#include "explore/ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace vasorod {
namespace {

constexpr const char* convention = "a convention of this program; no threshold is known";

double score_of(const Row& row, const std::vector<RankingCriterion>& criteria) {
  double sum = 0, weights = 0;
  for (const RankingCriterion& criterion : criteria) {
    weights += criterion.weight;
    const auto value = row.criteria.find(criterion.name);
    if (value != row.criteria.end()) sum += criterion.weight * penalty(criterion, value->second);
  }
  return weights > 0 ? sum / weights : 0;
}

Mark mark_of(const RankedRow& ranked, const std::vector<RankingCriterion>& criteria) {
  const Row& row = ranked.row;
  if (row.ending != Ending::solved) return Mark::none;
  if (row.status != Status::converged || !row.in_range.value_or(false)) return Mark::bad;
  // What the model doubts is not shown as good, as in vasorod-plan.
  if (!ranked.past.empty() || !row.sentences.empty()) return Mark::judge;
  // Where walls are solved, no contact pressure means that nothing comes within reach.
  const bool known = std::all_of(criteria.begin(), criteria.end(), [&](const auto& criterion) {
    return criterion.name == "contact_pressure" || row.criteria.contains(criterion.name);
  });
  return known ? Mark::good : Mark::unknown;
}

// As judge/criteria.h judges: a share at its threshold is not past it, anything else is.
bool is_past(const RankingCriterion& criterion, double value) {
  if (criterion.small_is_bad) return value < criterion.threshold;
  return std::abs(value - criterion.ideal) >= criterion.threshold;
}

// Smaller is better.
int group_of(const Row& row) {
  if (row.ending != Ending::solved) return 3;
  if (row.status == Status::converged) return 0;
  return is_solution(row.status) ? 1 : 2;
}

}  // namespace

const std::vector<RankingCriterion>& ranking_criteria() {
  static const std::vector<RankingCriterion> all{
      {"twist_shear", "Twist shear", "", 0, false, 1, 0.09, convention},
      {"twist", "Twist", "degrees", 0, false, 0, 90,
       "animal veins joined with a twist (criterion twist of result.json has the sources); weight "
       "0, as twist_shear counts the same twist"},
      {"stretch", "Axial stretch", "", 1, false, 1, 0.1, convention},
      {"mouth", "Mouth over vein", "", 1, true, 1, 0.6, convention},
      {"lumen", "Smallest lumen over rest", "", 1, true, 1, 0.6, convention},
      {"contact_pressure", "Contact pressure", "mmHg", 0, false, 1, 10,
       "a convention of this program, the order of the pressure in the vein after the operation "
       "(10 "
       "to 15 mmHg); no threshold is known"},
      {"validity", "Share of the model's range", "", 0, false, 1, 1,
       "the limits of `validity` in result.json: ratios of 0.9, a strain of 0.2"}};
  return all;
}

bool is_ranked(const std::string& name) {
  const auto& all = ranking_criteria();
  return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

std::vector<RankingCriterion> criteria_for(const ExploreSpec& spec) {
  std::vector<RankingCriterion> criteria = ranking_criteria();
  for (RankingCriterion& criterion : criteria) {
    if (const auto weight = spec.weights.find(criterion.name); weight != spec.weights.end())
      criterion.weight = weight->second;
    if (const auto set = spec.thresholds.find(criterion.name); set != spec.thresholds.end()) {
      criterion.threshold = set->second;
      criterion.source = "set in the scene";
    }
  }
  return criteria;
}

double penalty(const RankingCriterion& criterion, double value) {
  if (criterion.small_is_bad)
    return std::max(0.0, criterion.ideal - value) / (criterion.ideal - criterion.threshold);
  return std::abs(value - criterion.ideal) / criterion.threshold;
}

std::string to_string(Mark mark) {
  switch (mark) {
    case Mark::good:
      return "good";
    case Mark::judge:
      return "judge";
    case Mark::unknown:
      return "unknown";
    case Mark::bad:
      return "bad";
    case Mark::none:
      return "none";
  }
  return "none";
}

std::vector<RankedRow> ranked(const std::vector<Row>& rows, const ExploreSpec& spec) {
  const std::vector<RankingCriterion> criteria = criteria_for(spec);
  std::vector<RankedRow> sorted;
  for (const Row& row : rows) {
    RankedRow& one = sorted.emplace_back();
    one.row = row;
    const bool judged = row.ending == Ending::solved && is_solution(row.status);
    one.score = judged ? score_of(row, criteria) : std::numeric_limits<double>::quiet_NaN();
    for (const RankingCriterion& criterion : criteria) {
      const auto value = row.criteria.find(criterion.name);
      if (judged && value != row.criteria.end() && is_past(criterion, value->second))
        one.past.push_back(criterion.name);
    }
    one.mark = mark_of(one, criteria);
  }
  const auto place = [](const RankedRow& one) {
    return std::tuple(
        group_of(one.row), -one.row.stage, !one.row.in_range.value_or(false),
        std::isfinite(one.score) ? one.score : std::numeric_limits<double>::infinity());
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const RankedRow& a, const RankedRow& b) { return place(a) < place(b); });
  int rank = 0;
  for (RankedRow& one : sorted)
    if (one.row.ending == Ending::solved) one.rank = ++rank;
  return sorted;
}

}  // namespace vasorod
