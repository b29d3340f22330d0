// Graded lines of cells.
#include <cmath>
#include <gtest/gtest.h>

#include "reference_fem/grading.h"

namespace vasorod::fem {
namespace {

TEST(Grading, CellsGrowAwayFromThePoint) {
  const Grading grading;
  const std::vector<double> x = grading.stations(5, 12);
  ASSERT_EQ(x.size(), 13u);
  EXPECT_EQ(x.front(), 0);
  EXPECT_EQ(x.back(), 5);
  for (std::size_t k = 2; k < x.size(); ++k) EXPECT_GT(x[k] - x[k - 1], x[k - 1] - x[k - 2]);
  // the sum of the cells' shares is the number asked for, cell by cell
  for (std::size_t k = 0; k < x.size(); ++k)
    EXPECT_NEAR(grading.cells(x[k]) / grading.cells(5), static_cast<double>(k) / 12, 1e-12);
}

// A mesh of three cells for two has every second line of the coarse one among its own, so the
// meshes of a refinement differ by one ratio everywhere.
TEST(Grading, RefinementKeepsTheCoarseLines) {
  const Grading grading;
  const std::vector<double> coarse = grading.stations(3, 8), fine = grading.stations(3, 12);
  for (std::size_t k = 0; 2 * k < coarse.size(); ++k)
    EXPECT_NEAR(coarse[2 * k], fine[3 * k], 1e-12);
}

// With growth only, the cells are a geometric series.
TEST(Grading, WithoutALargestSizeTheSeriesIsGeometric) {
  const Grading grading{0.1, 0.5, 1e12};
  const std::vector<double> x = grading.stations(4, 6);
  const double ratio = (x[2] - x[1]) / (x[1] - x[0]);
  for (std::size_t k = 2; k < x.size(); ++k)
    EXPECT_NEAR((x[k] - x[k - 1]) / (x[k - 1] - x[k - 2]), ratio, 1e-9);
  EXPECT_NEAR(ratio, std::pow(1 + 0.5 * 4 / 0.1, 1.0 / 6), 1e-9);
}

}  // namespace
}  // namespace vasorod::fem
