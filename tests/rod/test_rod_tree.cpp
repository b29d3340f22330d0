#include <gtest/gtest.h>

#include "rod/rod_tree.h"
#include "rod/rods.h"
#include "rod/section.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(RodTree, OnlyTheFirstElementsOfSideBranchesLeaveAFork) {
  const Vec6 any = isotropic(1, 1, 1, 1);
  RodTree rod = chain(Pose{}, 10, {0, 0, 0}, 5, any);
  EXPECT_EQ(leaves_fork(rod), std::vector<char>(5, 0));
  append(rod, rod.rest[5], 5, 4, {0, 0, 0}, 2, any);
  append(rod, rod.rest[5], 5, 6, {0, 0, 0}, 3, any);
  EXPECT_EQ(leaves_fork(rod), (std::vector<char>{0, 0, 0, 0, 0, 1, 0, 1, 0, 0}));
}

}  // namespace
}  // namespace vasorod
