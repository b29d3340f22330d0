#include "explore/spread.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "data/sentence.h"
#include "explore/ranking.h"

namespace vasorod {
namespace {

bool converged(const Row& row) {
  return row.ending == Ending::solved && row.status == Status::converged;
}

// Places of the rows in their order: order[0] is the first row of the sample.
std::vector<RankedRow> order_of(std::vector<Row> rows, const ExploreSpec& spec) {
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].option = std::to_string(k);
  return ranked(rows, spec);
}

// Pairs in the same order less pairs in the other, over all pairs.
double kendall_tau(const std::vector<RankedRow>& order) {
  double sum = 0, pairs = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      sum += std::stoi(order[i].row.option) < std::stoi(order[j].row.option) ? 1 : -1;
      ++pairs;
    }
  return pairs > 0 ? sum / pairs : 1;
}

}  // namespace

double RankingSpread::first_stays() const {
  return options.empty() || samples == 0 ? 0 : static_cast<double>(options.front().first) / samples;
}

std::string RankingSpread::text() const {
  const std::string stays =
      number_text(100 * first_stays(), 3) + " % of " + std::to_string(samples) + " samples";
  std::string text =
      std::string("the ranking ") +
      (survives() ? "survives the uncertainty" : "does not survive the uncertainty") +
      ": its first option stays first in " + stays + (survives() ? "" : ", fewer than 95 %");
  if (options.size() > 1)
    text += "; the order of the " + std::to_string(options.size()) + " best has Kendall's tau of " +
            number_text(tau, 2) + " with that of the ranking";
  return text;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), values.size() - 1);
  const auto above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
}

RankingSpread spread_of(const std::vector<std::vector<Row>>& samples, const ExploreSpec& spec) {
  RankingSpread spread;
  spread.samples = static_cast<int>(samples.size());
  if (samples.empty()) return spread;
  spread.options.resize(samples.front().size());
  std::vector<std::map<std::string, std::vector<double>>> values(spread.options.size());
  double tau = 0;
  for (const std::vector<Row>& sample : samples) {
    const std::vector<RankedRow> order = order_of(sample, spec);
    tau += kendall_tau(order);
    if (!order.empty() && converged(order.front().row))
      ++spread.options[index(std::stoi(order.front().row.option))].first;
    for (const RankedRow& one : order) {
      const std::size_t k = index(std::stoi(one.row.option));
      ++spread.options[k].samples;
      if (!converged(one.row)) continue;
      ++spread.options[k].converged;
      for (const auto& [name, value] : one.row.criteria) values[k][name].push_back(value);
      values[k]["score"].push_back(one.score);
    }
  }
  spread.tau = tau / spread.samples;
  for (std::size_t k = 0; k < values.size(); ++k)
    for (const auto& [name, all] : values[k])
      spread.options[k].intervals[name] = {percentile(all, 0.05), percentile(all, 0.95)};
  return spread;
}

}  // namespace vasorod
