#include <algorithm>
#include <gtest/gtest.h>

#include "report/glyphs.h"
#include "report/lettering.h"

namespace vasorod {
namespace {

Picture blank(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width * height))};
}

double covered(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) sum += picture.rgba[i] / 255.0;
  return sum;
}

// The shoelace formula on the table's own data: contours of opposite orientation are holes.
double area_of(const Glyph& glyph) {
  double sum = 0;
  std::string contour;
  const auto add = [&] {
    const std::size_t n = contour.size() / 2;
    double part = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      part += contour[2 * i] * contour[2 * j + 1] - contour[2 * j] * contour[2 * i + 1];
    }
    sum += part / 2;
    contour.clear();
  };
  for (const char* at = glyph.contours; *at; ++at)
    if (*at == ' ')
      add();
    else
      contour += *at;
  add();
  return std::abs(sum);
}

TEST(Lettering, EveryLetterCoversItsOutlinesArea) {
  for (const Glyph& glyph : glyphs) {
    if (glyph.character > 127) continue;
    Picture picture = blank(200, 200);
    draw_text(picture, 40, 140, std::string(1, static_cast<char>(glyph.character)), 128, {0, 0, 0});
    const double area = area_of(glyph) * 4;  // two pixels per unit
    EXPECT_NEAR(covered(picture), area, 0.04 * area + 6) << static_cast<char>(glyph.character);
  }
}

TEST(Lettering, StaysInsideItsWidthAndAboveItsDescent) {
  Picture picture = blank(300, 60);
  draw_text(picture, 50, 40, "0.25 MPa", 30, {0, 0, 0});
  const double width = text_width("0.25 MPa", 30);
  int left = 300, right = 0, top = 60, bottom = 0;
  for (int row = 0; row < 60; ++row)
    for (int column = 0; column < 300; ++column)
      if (picture.rgba[4 * static_cast<std::size_t>(row * 300 + column) + 3] > 0) {
        left = std::min(left, column);
        right = std::max(right, column);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
      }
  EXPECT_GE(left, 50);
  EXPECT_LE(right, 50 + width + 1);
  EXPECT_GE(top, 40 - 30);
  EXPECT_LE(bottom, 40 + 1) << "no letter here goes below the base line";
}

TEST(Lettering, KnowsUtf8) {
  EXPECT_DOUBLE_EQ(text_width("mm²", 10), text_width("mm", 10) + text_width("²", 10));
  EXPECT_DOUBLE_EQ(text_width("漢", 10), text_width("?", 10));
  EXPECT_DOUBLE_EQ(text_width("\xff", 10), text_width("?", 10));
}

TEST(Lettering, OutsideThePictureNothingHappens) {
  Picture picture = blank(20, 20);
  draw_text(picture, -500, 10, "left", 12, {0, 0, 0});
  draw_text(picture, 5, 500, "below", 12, {0, 0, 0});
  EXPECT_EQ(covered(picture), 0);
}

}  // namespace
}  // namespace vasorod
