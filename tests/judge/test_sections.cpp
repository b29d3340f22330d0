#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "judge/sections.h"

namespace vasorod {
namespace {

using shapes::change_of;
using shapes::judged_tube;
using shapes::strained;

TEST(Sections, RestIsRoundAndOpen) {
  const PreparedVessel tube = judged_tube();
  const auto sections = judged_sections(tube, tube.vessel.rod.rest, tube.vessel.surface.points);
  ASSERT_GT(sections.size(), 10U);
  for (const JudgedSection& section : sections) {
    EXPECT_NEAR(section.flattening, 0, 1e-12);
    EXPECT_NEAR(section.lumen_ratio(), 1, 1e-12);
    EXPECT_NEAR(section.rest_lumen, M_PI * 9.5 * 9.5, 0.01 * M_PI * 9.5 * 9.5);
  }
}

// Ellipses with semi-axes 10 and b, down to almost nothing: lumen by Steiner's formula.
TEST(Sections, CollapsedSectionsCount) {
  const PreparedVessel tube = judged_tube();
  for (const double b : {5.0, 2.0, 0.5}) {
    Points squeezed = tube.vessel.surface.points;
    squeezed.col(1) *= b / 10;
    const auto sections = judged_sections(tube, tube.vessel.rod.rest, squeezed);
    ASSERT_GT(sections.size(), 10U) << b;
    double perimeter = 0;
    constexpr int n = 4096;
    for (int k = 0; k < n; ++k) {
      const double a = 2 * M_PI * (k + 0.5) / n;
      perimeter += std::hypot(10 * std::sin(a), b * std::cos(a)) * 2 * M_PI / n;
    }
    const double lumen = std::max(0.0, M_PI * 10 * b - 0.5 * perimeter + M_PI * 0.25);
    for (const JudgedSection& section : sections) {
      EXPECT_NEAR(section.flattening, 1 - b / 10, 1e-9) << b;
      EXPECT_NEAR(section.lumen, lumen, 0.01 * M_PI * 100) << b;
    }
  }
}

// Bent to most of a circle, every section's plane meets the tube on the other side of the circle
// too: that curve belongs to other nodes. Squeezed there, only those nodes tell it.
TEST(Sections, TheOtherSideOfABentTubeIsNotTheSection) {
  const PreparedVessel tube = judged_tube(200);
  const RodPoses poses = strained(tube.vessel.rod, change_of(0, Vec3(0, 1.7 * M_PI / 200, 0)));
  Binding moved = tube.vessel.binding;
  for (size_t i = 0; i < moved.size(); ++i)
    if (tube.vessel.surface.points(static_cast<Eigen::Index>(i), 2) > 120)
      moved[i].local.x() *= 0.2;
  const Points current = carried_points(tube.vessel.rod, poses, moved);
  int narrow = 0;
  for (const JudgedSection& section : judged_sections(tube, poses, current)) {
    if (section.abscissa < 110) {
      EXPECT_NEAR(section.lumen_ratio(), 1, 0.02) << section.abscissa;
    }
    if (section.abscissa > 130) {
      EXPECT_LT(section.lumen_ratio(), 0.25) << section.abscissa;
      ++narrow;
    }
  }
  EXPECT_GT(narrow, 5);
}

TEST(Sections, LumenAlongTheCenterlineInterpolates) {
  const PreparedVessel tube = judged_tube();
  const auto sections = judged_sections(tube, tube.vessel.rod.rest, tube.vessel.surface.points);
  const LumenAlong along = lumen_along(tube.vessel.rod, sections);
  ASSERT_EQ(along.area.size(), tube.vessel.rod.rest.size());
  for (size_t i = 0; i < along.area.size(); ++i) {
    EXPECT_NEAR(along.area[i], sections.front().lumen, 1e-3 * sections.front().lumen) << i;
    EXPECT_NEAR(along.flattening[i], 0, 1e-12) << i;
  }
}

// Sections at 20 and 60 only, as beside an incision: nothing is told more than a radius from them.
TEST(Sections, NothingIsToldFarFromASection) {
  const RodTree rod = judged_tube().vessel.rod;
  std::vector<JudgedSection> sections(2);
  double abscissa = 0;
  for (const int e : rod.branches[0].elements) {
    const RodElement& element = rod.elements[static_cast<size_t>(e)];
    abscissa += element.length;
    if (std::abs(abscissa - 20) < element.length / 2)
      sections[0] = {0, element.second, abscissa, 0.1, 200, 280};
    if (std::abs(abscissa - 60) < element.length / 2)
      sections[1] = {0, element.second, abscissa, 0.3, 100, 280};
  }
  const LumenAlong along = lumen_along(rod, sections);
  abscissa = 0;
  for (size_t k = 0; k < rod.branches[0].nodes.size(); ++k) {
    if (k > 0)
      abscissa += rod.elements[static_cast<size_t>(rod.branches[0].elements[k - 1])].length;
    const auto node = static_cast<size_t>(rod.branches[0].nodes[k]);
    const double away = std::min(std::abs(abscissa - sections[0].abscissa),
                                 std::abs(abscissa - sections[1].abscissa));
    EXPECT_EQ(std::isnan(along.area[node]), away > rod.radius[node]) << abscissa;
    if (away > rod.radius[node]) continue;
    const double t = std::clamp(
        (abscissa - sections[0].abscissa) / (sections[1].abscissa - sections[0].abscissa), 0.0,
        1.0);
    EXPECT_NEAR(along.area[node], 200 - 100 * t, 1e-9);
    EXPECT_NEAR(along.flattening[node], 0.1 + 0.2 * t, 1e-9);
  }
}

}  // namespace
}  // namespace vasorod
