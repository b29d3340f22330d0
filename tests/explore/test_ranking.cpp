// The order and the marks of options, against numbers worked out by hand.
#include <cmath>
#include <gtest/gtest.h>

#include "explore/ranking.h"

namespace vasorod::testing {
namespace {

Row row_of(const std::string& option, Status status, std::map<std::string, double> criteria,
           int stage = 0) {
  Row row;
  row.option = option;
  row.ending = Ending::solved;
  row.status = status;
  row.stage = stage;
  row.in_range = true;
  row.criteria = std::move(criteria);
  return row;
}

const std::map<std::string, double> ideal{{"twist_shear", 0}, {"twist", 0}, {"stretch", 1},
                                          {"mouth", 1},       {"lumen", 1}, {"contact_pressure", 0},
                                          {"validity", 0}};

std::map<std::string, double> ideal_but(const std::string& name, double value) {
  auto criteria = ideal;
  criteria[name] = value;
  return criteria;
}

std::vector<std::string> order_of(const std::vector<Row>& rows, const ExploreSpec& spec = {}) {
  std::vector<std::string> order;
  for (const RankedRow& one : ranked(rows, spec)) order.push_back(one.row.option);
  return order;
}

TEST(Ranking, PenaltyIsZeroAtTheIdealAndOneAtTheThreshold) {
  for (const RankingCriterion& criterion : ranking_criteria()) {
    EXPECT_EQ(penalty(criterion, criterion.ideal), 0) << criterion.name;
    if (criterion.name == "stretch") {
      EXPECT_NEAR(penalty(criterion, 1 + criterion.threshold), 1, 1e-12);
      EXPECT_NEAR(penalty(criterion, 1 - criterion.threshold), 1, 1e-12);
    } else {
      EXPECT_NEAR(penalty(criterion, criterion.threshold), 1, 1e-12) << criterion.name;
    }
    if (criterion.small_is_bad) {
      EXPECT_EQ(penalty(criterion, 1.3), 0) << criterion.name;
    }
  }
}

TEST(Ranking, ScoreIsTheWeightedMeanOfThePenalties) {
  ExploreSpec spec;
  spec.weights = {{"twist_shear", 3}, {"stretch", 1},          {"mouth", 0},   {"lumen", 0},
                  {"twist", 0},       {"contact_pressure", 0}, {"validity", 0}};
  spec.thresholds = {{"twist_shear", 0.2}, {"stretch", 0.5}};
  auto criteria = ideal_but("twist_shear", 0.1);
  criteria["stretch"] = 0.8;
  const auto one = ranked({row_of("a", Status::converged, criteria)}, spec).front();
  EXPECT_NEAR(one.score, (3 * 0.5 + 1 * 0.4) / 4, 1e-12);
  EXPECT_TRUE(one.past.empty());
  EXPECT_EQ(one.rank, 1);
}

TEST(Ranking, OtherStatusesStandBelowConvergedOnesAndAreNeverGood) {
  std::vector<Row> rows;
  for (const Status status :
       {Status::equilibrium_only, Status::unstable, Status::buckled, Status::not_unique,
        Status::self_intersecting, Status::iteration_limit, Status::interrupted})
    rows.push_back(row_of(to_string(status), status, ideal));
  rows.push_back(row_of("worst", Status::converged, ideal_but("twist_shear", 100)));
  Row refused;
  refused.option = "refused";
  refused.ending = Ending::not_built;
  rows.insert(rows.begin(), refused);
  const auto sorted = ranked(rows, {});
  EXPECT_EQ(sorted.front().row.option, "worst");
  EXPECT_EQ(sorted.back().row.option, "refused");
  EXPECT_EQ(sorted.back().rank, 0);
  EXPECT_EQ(sorted.back().mark, Mark::none);
  for (const RankedRow& one : sorted) {
    EXPECT_NE(one.mark, Mark::good) << one.row.option;
    if (one.row.option != "worst" && one.row.option != "refused") {
      EXPECT_EQ(one.mark, Mark::bad) << one.row.option;
    }
  }
}

// What says nothing is not ranked by its numbers: unfinished states stand below all equilibria.
TEST(Ranking, UnfinishedStatesHaveNoScore) {
  const auto sorted = ranked({row_of("stopped", Status::iteration_limit, ideal),
                              row_of("bent", Status::buckled, ideal_but("twist_shear", 9))},
                             {});
  EXPECT_EQ(sorted[0].row.option, "bent");
  EXPECT_TRUE(std::isnan(sorted[1].score));
  EXPECT_FALSE(std::isnan(sorted[0].score));
}

TEST(Ranking, GoodNeedsRangeNoWarningThresholdsAndEveryCriterion) {
  const auto mark = [](const Row& row) { return ranked({row}, {}).front().mark; };
  const Row good = row_of("a", Status::converged, ideal);
  EXPECT_EQ(mark(good), Mark::good);
  Row outside = good;
  outside.in_range = false;
  EXPECT_EQ(mark(outside), Mark::bad);
  Row nobody_knows = good;
  nobody_knows.in_range.reset();
  EXPECT_EQ(mark(nobody_knows), Mark::bad);
  EXPECT_EQ(mark(row_of("a", Status::converged, ideal_but("mouth", 0.59))), Mark::judge);
  EXPECT_EQ(mark(row_of("a", Status::converged, ideal_but("mouth", 0.6))), Mark::good);
  EXPECT_EQ(mark(row_of("a", Status::converged, ideal_but("twist", 90))), Mark::judge);
  Row warned = good;
  warned.sentences = {"vessel svc: its inner side comes near wrinkling"};
  EXPECT_EQ(mark(warned), Mark::judge);
  auto blind = ideal;
  blind.erase("lumen");
  warned.criteria = blind;
  EXPECT_EQ(mark(warned), Mark::judge);
  EXPECT_EQ(mark(row_of("a", Status::converged, blind)), Mark::unknown);
  auto apart = ideal;
  apart.erase("contact_pressure");
  EXPECT_EQ(mark(row_of("a", Status::converged, apart)), Mark::good);
}

TEST(Ranking, LaterStagesStandBeforeEarlierOnesAndScoresOrderEach) {
  EXPECT_EQ(order_of({row_of("early best", Status::converged, ideal, 0),
                      row_of("late worse", Status::converged, ideal_but("twist_shear", 0.3), 1),
                      row_of("late better", Status::converged, ideal_but("twist_shear", 0.2), 1),
                      row_of("late bent", Status::buckled, ideal, 1)}),
            (std::vector<std::string>{"late better", "late worse", "early best", "late bent"}));
}

TEST(Ranking, WithinAStageWhatIsInTheModelsRangeStandsFirst) {
  Row outside = row_of("outside", Status::converged, ideal, 1);
  outside.in_range = false;
  EXPECT_EQ(order_of({outside, row_of("early", Status::converged, ideal, 0),
                      row_of("inside", Status::converged, ideal_but("mouth", 0.1), 1)}),
            (std::vector<std::string>{"inside", "outside", "early"}));
}

TEST(Ranking, AWeightTurnsTheOrder) {
  const std::vector<Row> rows{row_of("twisted", Status::converged, ideal_but("twist_shear", 0.08)),
                              row_of("narrow", Status::converged, ideal_but("mouth", 0.8))};
  EXPECT_EQ(order_of(rows).front(), "narrow");
  ExploreSpec spec;
  spec.weights = {{"mouth", 10}};
  EXPECT_EQ(order_of(rows, spec).front(), "twisted");
}

}  // namespace
}  // namespace vasorod::testing
