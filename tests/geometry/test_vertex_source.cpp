#include <gtest/gtest.h>

#include "geometry/vertex_source.h"

namespace vasorod {
namespace {

TEST(VertexSource, TwoEditsInARowAreOneMean) {
  // First edit: vertex 2 halfway between 0 and 1. Second edit: its vertex 1 a quarter of the way
  // from 2 to 1 of the first.
  const VertexSources first{
      VertexSource::original(0), VertexSource::original(1), {{0, 1}, {0.5, 0.5}}};
  const VertexSources second{VertexSource::original(0), {{1, 2}, {0.25, 0.75}}};
  const auto both = compose(second, first);
  ASSERT_EQ(both[1].vertex, (std::vector<int>{0, 1}));
  EXPECT_DOUBLE_EQ(both[1].weight[0], 0.375);
  EXPECT_DOUBLE_EQ(both[1].weight[1], 0.625);
  EXPECT_TRUE(both[0].is_original());

  Eigen::MatrixXd values(2, 2);
  values << 1, 10, 3, 20;
  const Eigen::MatrixXd once = interpolate(both, values),
                        twice = interpolate(second, interpolate(first, values));
  EXPECT_LT((once - twice).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(once(1, 0), 0.375 * 1 + 0.625 * 3);
}

TEST(VertexSource, LabelsFollowTheLargestWeight) {
  const VertexSources sources{
      {{4, 7}, {0.4, 0.6}}, {{4, 7}, {0.5, 0.5}}, VertexSource::original(2)};
  EXPECT_EQ(carry_labels(sources, {9, 9, 3, 9, 1, 9, 9, 2}), (std::vector<int>{2, 1, 3}));
}

}  // namespace
}  // namespace vasorod
