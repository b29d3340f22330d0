// Percentiles, shares and Kendall's tau against numbers worked out by hand.
#include <gtest/gtest.h>

#include "explore/latin_hypercube.h"
#include "explore/ranking.h"
#include "explore/spread.h"

namespace vasorod::testing {
namespace {

// Only the twist shear counts: the score is shear / threshold.
ExploreSpec by_twist_shear() {
  ExploreSpec spec;
  for (const RankingCriterion& criterion : ranking_criteria())
    spec.weights[criterion.name] = criterion.name == "twist_shear" ? 1 : 0;
  spec.thresholds["twist_shear"] = 0.5;
  return spec;
}

Row sampled(double shear, Status status = Status::converged) {
  Row row;
  row.ending = Ending::solved;
  row.status = status;
  row.in_range = true;
  row.criteria["twist_shear"] = shear;
  return row;
}

TEST(Spread, PercentilesAreLinearBetweenSortedValues) {
  EXPECT_DOUBLE_EQ(percentile({3}, 0.05), 3);
  EXPECT_DOUBLE_EQ(percentile({4, 2}, 0), 2);
  EXPECT_DOUBLE_EQ(percentile({4, 2}, 0.25), 2.5);
  EXPECT_DOUBLE_EQ(percentile({4, 2}, 1), 4);
  std::vector<double> values;
  for (int k = 100; k >= 0; --k) values.push_back(k);
  EXPECT_DOUBLE_EQ(percentile(values, 0.05), 5);
  EXPECT_DOUBLE_EQ(percentile(values, 0.955), 95.5);
}

// A criterion that is x^2 of a uniform x has the percentiles 0.05^2 and 0.95^2, to a stratum.
TEST(Spread, IntervalsOfAKnownFunctionAreItsPercentiles) {
  std::vector<std::vector<Row>> samples;
  for (const auto& point : latin_hypercube(400, 1, 1))
    samples.push_back({sampled(point[0] * point[0])});
  const RankingSpread spread = spread_of(samples, by_twist_shear());
  const auto [low, high] = spread.options[0].intervals.at("twist_shear");
  const auto within = [](double x) { return 2 * x * 2 / 400 + 1e-4; };  // d(x^2) of two strata
  EXPECT_NEAR(low, 0.05 * 0.05, within(0.05));
  EXPECT_NEAR(high, 0.95 * 0.95, within(0.95));
  EXPECT_NEAR(spread.options[0].intervals.at("score")[1], 2 * high, 1e-12);
}

TEST(Spread, SharesCountWhatConvergedAndWhatWasFirst) {
  const RankingSpread spread = spread_of(
      {{sampled(0.1), sampled(0.2), sampled(0.3)},
       {sampled(0.4), sampled(0.2), sampled(0.3)},
       {sampled(0.1, Status::iteration_limit), sampled(0.2), sampled(0.3, Status::iteration_limit)},
       {sampled(0.1, Status::iteration_limit), sampled(0.2, Status::iteration_limit),
        sampled(0.3, Status::iteration_limit)}},
      by_twist_shear());
  EXPECT_EQ(spread.samples, 4);
  EXPECT_EQ(spread.options[0].samples, 4);
  EXPECT_EQ(spread.options[0].converged, 2);
  EXPECT_EQ(spread.options[1].converged, 3);
  EXPECT_EQ(spread.options[0].first, 1);
  EXPECT_EQ(spread.options[1].first, 2);
  EXPECT_EQ(spread.options[2].first, 0);
  EXPECT_DOUBLE_EQ(spread.first_stays(), 0.25);
  EXPECT_FALSE(spread.survives());
  EXPECT_NE(spread.text().find("does not survive"), std::string::npos);
}

// Orders 012, 210 and 102 have 0, 3 and 1 of 3 pairs turned round: tau 1, -1 and 1/3.
TEST(Spread, TauIsTheMeanOverTheSamples) {
  const RankingSpread spread = spread_of({{sampled(0.1), sampled(0.2), sampled(0.3)},
                                          {sampled(0.3), sampled(0.2), sampled(0.1)},
                                          {sampled(0.2), sampled(0.1), sampled(0.3)}},
                                         by_twist_shear());
  EXPECT_NEAR(spread.tau, (1 - 1 + 1. / 3) / 3, 1e-12);
}

TEST(Spread, ARankingThatNothingChangesSurvives) {
  const RankingSpread spread =
      spread_of({{sampled(0.1), sampled(0.2)}, {sampled(0.3), sampled(0.4)}}, by_twist_shear());
  EXPECT_TRUE(spread.survives());
  EXPECT_EQ(spread.tau, 1);
  EXPECT_NE(spread.text().find("survives the uncertainty"), std::string::npos);
  EXPECT_TRUE(spread_of({}, by_twist_shear()).options.empty());
}

}  // namespace
}  // namespace vasorod::testing
