#include <cmath>
#include <gtest/gtest.h>

#include "report/picture.h"

namespace vasorod {
namespace {

const std::uint8_t* pixel(const Picture& picture, int column, int row) {
  return &picture.rgba[4 * static_cast<std::size_t>(row * picture.width + column)];
}

TEST(ColourBar, TheColourBarRunsFromLowBelowToHighAbove) {
  Picture picture{400, 300, std::vector<std::uint8_t>(4 * 400 * 300)};
  const ColourScale scale{ColourMap::diverging, -0.05, 0.05, "twist shear"};
  draw_colour_bar(picture, scale);
  int top = -1, bottom = -1;
  for (int row = 0; row < 300; ++row)
    for (int column = 0; column < 400; ++column) {
      const std::uint8_t* at = pixel(picture, column, row);
      if (at[3] == 255 && std::abs(at[0] - at[2]) > 100) {
        if (top < 0) {
          top = row;
          EXPECT_GT(at[0], at[2]) << "high is red";
        }
        bottom = row;
      }
    }
  ASSERT_GT(bottom - top, 150);
  int blue = 0;
  for (int column = 0; column < 400; ++column) blue += pixel(picture, column, bottom)[2] > 150;
  EXPECT_GT(blue, 5) << "low is blue";
}

TEST(ColourBar, NothingIsDrawnInTheLeftHalf) {
  Picture picture{400, 300, std::vector<std::uint8_t>(4 * 400 * 300)};
  draw_colour_bar(picture, {ColourMap::sequential, 0, 1, "contact pressure, MPa"});
  int drawn = 0;
  for (int row = 0; row < 300; ++row)
    for (int column = 0; column < 400; ++column) {
      if (pixel(picture, column, row)[3] == 0) continue;
      ++drawn;
      EXPECT_GT(column, 200) << row;
    }
  EXPECT_GT(drawn, 1000);
}

}  // namespace
}  // namespace vasorod
