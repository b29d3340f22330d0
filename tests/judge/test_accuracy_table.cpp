#include <gtest/gtest.h>
#include <string_view>
#include <vector>

#include "judge/accuracy_table.h"

namespace vasorod {
namespace {

TEST(AccuracyTable, IsSortedAndErrorsGrowWithTheDemand) {
  const auto rows = accuracy_table();
  ASSERT_FALSE(rows.empty());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_GT(rows[k].edge, 0);
    EXPECT_GT(rows[k].demand, 0);
    EXPECT_GT(rows[k].error, 0);
    if (k == 0 || rows[k].fidelity != rows[k - 1].fidelity || rows[k].kind != rows[k - 1].kind ||
        rows[k].edge != rows[k - 1].edge)
      continue;
    EXPECT_GT(rows[k].demand, rows[k - 1].demand);
    EXPECT_GE(rows[k].error, rows[k - 1].error);
  }
}

TEST(AccuracyTable, FidelitiesGoFromCheapToDearAndCoverEveryLoad) {
  std::vector<std::string_view> order;
  for (const AccuracyRow& row : accuracy_table())
    if (order.empty() || order.back() != row.fidelity) order.push_back(row.fidelity);
  EXPECT_EQ(order, (std::vector<std::string_view>{"skin", "paper", "section", "coupled"}));
  for (const std::string_view fidelity : order)
    for (const LoadKind kind : {LoadKind::stretch, LoadKind::twist, LoadKind::bend}) {
      int rows = 0;
      for (const AccuracyRow& row : accuracy_table())
        rows += row.fidelity == fidelity && row.kind == kind;
      EXPECT_GT(rows, 0) << fidelity;
    }
}

TEST(AccuracyTable, TheScopeIsThatOfVessels) {
  const AccuracyScope scope = accuracy_scope();
  EXPECT_GT(scope.thickness[0], 0);
  EXPECT_LT(scope.thickness[0], scope.thickness[1]);
  EXPECT_LT(scope.thickness[1], 1);
  EXPECT_GT(scope.length[0], 0);
  EXPECT_LE(scope.length[0], scope.length[1]);
}

}  // namespace
}  // namespace vasorod
