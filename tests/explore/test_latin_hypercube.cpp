#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "explore/latin_hypercube.h"

namespace vasorod::testing {
namespace {

// What makes it a Latin hypercube.
TEST(LatinHypercube, EveryStratumOfEveryDimensionHasOnePoint) {
  for (const int samples : {1, 2, 7, 40, 333})
    for (const int dimensions : {1, 3, 8}) {
      const auto points = latin_hypercube(samples, dimensions, 5);
      ASSERT_EQ(points.size(), static_cast<std::size_t>(samples));
      for (int d = 0; d < dimensions; ++d) {
        std::set<int> strata;
        for (const auto& point : points) {
          const double x = point[static_cast<std::size_t>(d)];
          ASSERT_GE(x, 0);
          ASSERT_LT(x, 1);
          strata.insert(static_cast<int>(std::floor(x * samples)));
        }
        EXPECT_EQ(strata.size(), static_cast<std::size_t>(samples)) << samples << " " << d;
      }
    }
}

TEST(LatinHypercube, TheSeedSaysAllOfIt) {
  EXPECT_EQ(latin_hypercube(9, 3, 1), latin_hypercube(9, 3, 1));
  EXPECT_NE(latin_hypercube(9, 3, 1), latin_hypercube(9, 3, 2));
}

// Of two independent dimensions; three standard deviations of the correlation of 1000 points.
TEST(LatinHypercube, DimensionsArePairedAtRandom) {
  const auto points = latin_hypercube(1000, 2, 3);
  double sum = 0;
  for (const auto& point : points) sum += (point[0] - 0.5) * (point[1] - 0.5);
  EXPECT_LT(std::abs(sum / 1000 * 12), 3 / std::sqrt(1000.));
}

// A sum of functions of one coordinate each is integrated far better than by independent draws:
// every stratum is within 1 / 2n of its middle.
TEST(LatinHypercube, TheMeanOfACoordinateIsThatOfTheStrata) {
  double sum = 0;
  for (const auto& point : latin_hypercube(100, 2, 1)) sum += point[1];
  EXPECT_NEAR(sum / 100, 0.5, 0.5 / 100);
}

}  // namespace
}  // namespace vasorod::testing
