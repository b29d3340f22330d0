#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "report/colour_scale.h"

namespace vasorod {
namespace {

TEST(ColourScale, EndsHaveTheMapsEnds) {
  const ColourScale scale{ColourMap::diverging, -2, 2, ""};
  EXPECT_FLOAT_EQ(scale(-2)[2], 0xc0 / 255.0F);
  EXPECT_FLOAT_EQ(scale(2)[0], 0xb4 / 255.0F);
  EXPECT_EQ(scale(-5), scale(-2));
  EXPECT_EQ(scale(5), scale(2));
  EXPECT_NEAR(scale(0)[0], scale(0)[2], 0.01) << "the middle is grey";
  EXPECT_EQ(scale(std::nan("")), (Colour{0.5F, 0.5F, 0.5F}));
}

TEST(ColourScale, TicksAreRoundAndInside) {
  for (const auto& [low, high] :
       {std::pair(-0.05, 0.05), std::pair(0.0, 1.0), std::pair(0.0, 3.7e-4), std::pair(0.93, 1.07),
        std::pair(-1234.0, 1234.0)}) {
    const ColourScale scale{ColourMap::sequential, low, high, ""};
    const std::vector<double> ticks = scale.ticks();
    EXPECT_GE(ticks.size(), 3u) << low;
    EXPECT_LE(ticks.size(), 11u) << low;
    const double step = ticks[1] - ticks[0],
                 mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 ||
                std::abs(mantissa - 5) < 1e-6)
        << step;
    for (const double tick : ticks) {
      EXPECT_GE(tick, low - 1e-9 * (high - low));
      EXPECT_LE(tick, high + 1e-9 * (high - low));
      EXPECT_NEAR(std::stod(tick_text(tick, step)), tick, 0.01 * step);
    }
  }
}

TEST(ColourScale, TickTextHasTheStepsDigits) {
  EXPECT_EQ(tick_text(0.04, 0.02), "0.04");
  EXPECT_EQ(tick_text(1, 0.1), "1.0");
  EXPECT_EQ(tick_text(-200, 100), "-200");
  EXPECT_EQ(tick_text(0, 0.02), "0");
  EXPECT_EQ(tick_text(2e-6, 1e-6), "2e-06");
}

TEST(ColourScale, FitsTheFields) {
  const Eigen::VectorXd a = Eigen::Vector3d(0.98, 1.0, 1.01),
                        b = Eigen::Vector2d(1.06, std::nan("")), none;
  const Eigen::VectorXd* const fields[] = {&a, &b, &none};
  const ColourScale stretch = scale_for(ColourMap::diverging, "stretch", fields, 1);
  EXPECT_DOUBLE_EQ(stretch.low, 0.94);
  EXPECT_DOUBLE_EQ(stretch.high, 1.06);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(5);
  const Eigen::VectorXd* const flat[] = {&zero};
  const ColourScale pressure = scale_for(ColourMap::sequential, "pressure", flat);
  EXPECT_EQ(pressure.low, 0);
  EXPECT_GT(pressure.high, 0);
}

TEST(ColourScale, ReachesAtLeastAsFarAsItIsTold) {
  const Eigen::VectorXd small = Eigen::Vector2d(0.99, 1.01), large = Eigen::Vector2d(0.5, 1.1);
  const auto of = [](ColourMap map, const Eigen::VectorXd& values, double reach) {
    const Eigen::VectorXd* const fields[] = {&values};
    return scale_for(map, "", fields, map == ColourMap::diverging ? 1 : 0, reach);
  };
  EXPECT_DOUBLE_EQ(of(ColourMap::diverging, small, 0.2).low, 0.8);
  EXPECT_DOUBLE_EQ(of(ColourMap::diverging, small, 0.2).high, 1.2);
  EXPECT_DOUBLE_EQ(of(ColourMap::diverging, large, 0.2).high, 1.5);
  EXPECT_DOUBLE_EQ(of(ColourMap::sequential, small, 3).low, 0);
  EXPECT_DOUBLE_EQ(of(ColourMap::sequential, small, 3).high, 3);
}

TEST(ColourScale, TicksAreRoundInTheShownUnit) {
  ColourScale scale{ColourMap::sequential, 0, 0.001, "pressure, mmHg"};
  scale.shown_per = 1e6 / 133.322387415;  // MPa to mmHg
  std::vector<std::string> texts;
  for (const double tick : scale.ticks()) texts.push_back(scale.text_at(tick));
  EXPECT_EQ(texts, (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7"}));
  EXPECT_NEAR(scale.ticks()[1], 133.322387415e-6, 1e-15);
}

}  // namespace
}  // namespace vasorod
