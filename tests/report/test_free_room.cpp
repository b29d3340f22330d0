#include <gtest/gtest.h>
#include <limits>

#include "report/free_room.h"
#include "report/picture.h"

namespace vasorod {
namespace {

Picture with_block(const PixelBox& block) {
  Picture picture{90, 60, std::vector<std::uint8_t>(4 * 90 * 60)};
  for (int row = block.top; row < block.bottom; ++row)
    for (int column = block.left; column < block.right; ++column)
      picture.rgba[4 * static_cast<std::size_t>(90 * row + column) + 3] = 1;
  return picture;
}

TEST(FreeRoom, CountsWhatIsDrawnTakenAndOutside) {
  FreeRoom room(with_block({20, 10, 50, 40}));
  EXPECT_EQ(room.used({0, 0, 90, 60}), 30 * 30);
  EXPECT_EQ(room.used({45, 35, 55, 45}), 5 * 5);
  EXPECT_EQ(room.used({-5, 0, 5, 10}), 5 * 10) << "outside";
  room.take({70, 0, 90, 10});
  EXPECT_EQ(room.used({60, 5, 80, 15}), 10 * 5);
  EXPECT_EQ(room.used({0, 50, 10, 60}), 0);
}

TEST(FreeRoom, FindsTheNearestEmptyBoxAsTryingThemAllDoes) {
  const FreeRoom room(with_block({20, 10, 50, 40}));
  for (const Vec2& place : {Vec2(35, 25), Vec2(0, 0), Vec2(80, 55), Vec2(30, 14)}) {
    const auto found = room.nearest(12, 8, place, 3);
    ASSERT_TRUE(found);
    EXPECT_EQ(room.used(*found), 0);
    double least = std::numeric_limits<double>::infinity();
    for (int top = 3; top + 8 <= 57; ++top)
      for (int left = 3; left + 12 <= 87; ++left) {
        const bool apart = left + 12 <= 20 || left >= 50 || top + 8 <= 10 || top >= 40;
        if (apart) least = std::min(least, (Vec2(left + 6, top + 4) - place).norm());
      }
    const Vec2 middle(found->left + 6, found->top + 4);
    EXPECT_NEAR((middle - place).norm(), least, 1e-12);
  }
  EXPECT_FALSE(room.nearest(89, 59, {0, 0}, 0)) << "there is none as large";
}

TEST(FreeRoom, ALineMeetsATakenBoxOnItsWayOnly) {
  FreeRoom room(with_block({0, 0, 0, 0}));
  room.take({40, 20, 50, 30});
  EXPECT_TRUE(room.meets_taken({10, 25}, {80, 25}));
  EXPECT_TRUE(room.meets_taken({45, 25}, {46, 25}));
  EXPECT_FALSE(room.meets_taken({10, 25}, {39, 25}));
  EXPECT_FALSE(room.meets_taken({10, 5}, {80, 15}));
}

}  // namespace
}  // namespace vasorod
