#include <gtest/gtest.h>
#include <set>

#include "numerics/lbfgs.h"

namespace vasorod {
namespace {

TEST(LbfgsSummary, TheBriefReportSaysStatusCountsAndResidual) {
  LbfgsSummary summary;
  summary.status = LbfgsStatus::slow;
  summary.iterations = 40;
  summary.evaluations = 47;
  summary.residual = 1.5e-4;
  EXPECT_EQ(summary.brief_report(), to_string(LbfgsStatus::slow) +
                                        ": residual 0.00015 after 40 iterations, 47 evaluations");
}

TEST(LbfgsSummary, EveryStatusHasAWordOfItsOwn) {
  std::set<std::string> words;
  for (const LbfgsStatus status :
       {LbfgsStatus::converged, LbfgsStatus::iteration_limit, LbfgsStatus::slow,
        LbfgsStatus::stalled, LbfgsStatus::interrupted}) {
    EXPECT_FALSE(to_string(status).empty());
    EXPECT_TRUE(words.insert(to_string(status)).second) << to_string(status);
  }
}

TEST(StagedSummary, AddsItsStagesAndEndsAsTheLastOne) {
  StagedSummary all;
  all.add({LbfgsStatus::slow, 30, 33, 5, 1e-2});
  all.add({LbfgsStatus::converged, 12, 12, 4, 1e-9});
  EXPECT_EQ(all.status, LbfgsStatus::converged);
  EXPECT_EQ(all.iterations, 42);
  EXPECT_EQ(all.energy, 4);
  EXPECT_EQ(all.residual, 1e-9);
  EXPECT_EQ(all.brief_report(), "converged: residual 1e-09 after 42 iterations");
}

TEST(StagedSummary, TheNextStageCountsFromTheFirst) {
  StagedSummary all;
  EXPECT_FALSE(all.counting({}));
  int told = -1;
  const auto stop = all.counting([&](int iteration, double, double residual) {
    told = iteration;
    return residual > 0.5;
  });
  all.add({LbfgsStatus::slow, 30, 33, 5, 1e-2});
  EXPECT_TRUE(stop(4, 0, 1));
  EXPECT_EQ(told, 34);
  EXPECT_FALSE(stop(5, 0, 0.1));
  EXPECT_EQ(told, 35);
}

}  // namespace
}  // namespace vasorod
