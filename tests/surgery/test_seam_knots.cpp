#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "data/index.h"
#include "surgery/seam_knots.h"

namespace vasorod {
namespace {

std::vector<double> even(int count, double first) {
  std::vector<double> corners;
  for (int k = 0; k < count; ++k) corners.push_back((k + first) / count);
  return corners;
}

// Every vertex of both loops in one knot, in order from the first tip, both tips where they are.
void expect_ordered(const SeamCorners& corners, const std::vector<SeamKnot>& knots) {
  std::vector<int> mouth, rim;
  for (size_t k = 0; k < knots.size(); ++k) {
    if (knots[k].mouth >= 0) mouth.push_back(knots[k].mouth);
    if (knots[k].rim >= 0) rim.push_back(knots[k].rim);
    EXPECT_TRUE(knots[k].mouth >= 0 || knots[k].rim >= 0);
    if (k > 0) {
      EXPECT_GT(knots[k].position, knots[k - 1].position);
    }
    if (knots[k].rim == corners.other_tip) {
      EXPECT_EQ(knots[k].position, corners.rim[index(corners.other_tip)]);
    }
  }
  EXPECT_EQ(knots.front().rim, 0);
  EXPECT_EQ(knots.front().position, 0);
  EXPECT_LT(knots.back().position, 1);
  std::rotate(mouth.begin(), std::min_element(mouth.begin(), mouth.end()), mouth.end());
  for (const auto& [list, count] :
       {std::pair(&mouth, corners.mouth.size()), std::pair(&rim, corners.rim.size())}) {
    ASSERT_EQ(list->size(), count);
    for (size_t k = 0; k < count; ++k) EXPECT_EQ((*list)[k], static_cast<int>(k));
  }
}

TEST(SeamKnots, EvenLoopsOfOneSizeArePairedVertexByVertex) {
  for (const double shift : {0.0, 0.2, 0.49, 0.8}) {
    const SeamCorners corners{even(40, shift), even(40, 0), 20};
    const auto knots = choose_knots(corners);
    expect_ordered(corners, knots);
    EXPECT_EQ(knots.size(), 40U) << shift;
  }
}

TEST(SeamKnots, AFineLoopGivesItsVerticesToACoarseOne) {
  for (const auto& [m, n] : {std::pair(24, 120), std::pair(120, 24), std::pair(50, 64)}) {
    const SeamCorners corners{even(m, 0.3), even(n, 0), n / 2};
    const auto knots = choose_knots(corners);
    expect_ordered(corners, knots);
    EXPECT_LE(knots.size(), 1.1 * std::max(m, n)) << m << " and " << n;
  }
}

TEST(SeamKnots, IrregularLoopsHaveNoShortGap) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    SeamCorners corners;
    for (auto* loop : {&corners.mouth, &corners.rim}) {
      const int n = 20 + static_cast<int>(60 * uniform(random));
      double sum = 0;
      for (int k = 0; k < n; ++k) {
        loop->push_back(sum);
        sum += 0.1 + uniform(random);
      }
      for (double& x : *loop) x /= sum;
    }
    for (double& x : corners.mouth) x += (1 - corners.mouth.back()) * uniform(random);
    corners.other_tip = static_cast<int>(corners.rim.size()) / 2;
    const auto knots = choose_knots(corners);
    expect_ordered(corners, knots);
    const double fine = 1.0 / double(std::max(corners.mouth.size(), corners.rim.size()));
    for (size_t k = 0; k < knots.size(); ++k) {
      const double next = k + 1 < knots.size() ? knots[k + 1].position : 1;
      EXPECT_GT(next - knots[k].position, 0.12 * fine) << trial << " knot " << k;
    }
  }
}

TEST(SeamKnots, WhatWasRefusedIsLeftOut) {
  const SeamCorners corners{even(30, 0.4), even(30, 0), 15};
  const auto partner = [&](const SeamRefusals& refusals, int rim) {
    const auto knots = choose_knots(corners, refusals);
    expect_ordered(corners, knots);
    return *std::find_if(knots.begin(), knots.end(), [&](const auto& k) { return k.rim == rim; });
  };
  const SeamKnot usual = partner({}, 6);
  EXPECT_EQ(usual.mouth, 6);
  EXPECT_EQ(usual.position, corners.mouth[6]);
  SeamRefusals refusals;
  refusals.share[{6, 6}] = 0.5;
  EXPECT_NEAR(partner(refusals, 6).position, (corners.mouth[6] + corners.rim[6]) / 2, 1e-15);
  refusals.share[{6, 6}] = 2;
  EXPECT_NE(partner(refusals, 6).mouth, 6);
  // A tip that no vertex of the mouth may reach gets a new one.
  refusals = {};
  refusals.share[{0, 0}] = refusals.share[{29, 0}] = 2;
  EXPECT_EQ(partner(refusals, 0).mouth, -1);
  refusals = {};
  for (const int mouth : {14, 15}) refusals.share[{mouth, 15}] = 2;
  const SeamKnot tip = partner(refusals, 15);
  EXPECT_TRUE(tip.mouth != 14 && tip.mouth != 15);
}

TEST(SeamKnots, AVertexThatMustStayStays) {
  // The mouth's vertices 10 and 11 are close together; the first may not move.
  SeamCorners corners{even(24, 0.5), even(20, 0), 10};
  corners.mouth[11] = corners.mouth[10] + 0.002;
  const auto place = [&](const SeamRefusals& refusals, int mouth) {
    const auto knots = choose_knots(corners, refusals);
    return std::find_if(knots.begin(), knots.end(), [&](const auto& k) { return k.mouth == mouth; })
        ->position;
  };
  EXPECT_GT(place({}, 11) - place({}, 10), 0.01);
  SeamRefusals refusals;
  refusals.mouth_stays.assign(24, 1);
  const auto knots = choose_knots(corners, refusals);
  for (const SeamKnot& k : knots)
    if (k.mouth >= 0 && k.rim < 0) {
      EXPECT_EQ(k.position, corners.mouth[index(k.mouth)]);
    }
}

}  // namespace
}  // namespace vasorod
