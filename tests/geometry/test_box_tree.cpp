#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>

#include "geometry/box_tree.h"

namespace vasorod {
namespace {

// Boxes of all sizes, some of them points, some of them alike.
std::vector<Box> boxes(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3, 3), size(0, 0.4);
  std::vector<Box> made;
  for (int i = 0; i < count; ++i) {
    const Vec3 low(place(random), place(random), 0.1 * place(random));
    made.push_back({low, i % 7 == 0 ? low : Vec3(low + Vec3::Constant(size(random)))});
    if (i % 11 == 0) made.push_back(made.back());
  }
  return made;
}

TEST(BoxTree, AVisitTakesWhatTryingEveryBoxTakes) {
  for (const int count : {0, 1, 3, 5, 300}) {
    const std::vector<Box> all = boxes(count);
    const BoxTree tree(all);
    for (const double x : {-2.0, 0.1, 5.0}) {
      const Box window{{x, -1, -1}, {x + 0.7, 1, 1}};
      std::multiset<int> expected, found;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].meets(window)) expected.insert(static_cast<int>(i));
      tree.visit([&](const Box& box) { return box.meets(window); },
                 [&](int item) { found.insert(item); });
      EXPECT_EQ(found, expected) << count << " " << x;
    }
  }
}

// Each item is a point: the low corner of its box.
int nearest_of_all(const std::vector<Box>& all, const Vec3& point) {
  int nearest = -1;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (nearest < 0 || (point - all[i].low).squaredNorm() <
                           (point - all[static_cast<std::size_t>(nearest)].low).squaredNorm())
      nearest = static_cast<int>(i);
  return nearest;
}

TEST(BoxTree, TheNearestIsThatOfTryingAllWhereverTheSearchBeginsAlsoAfterARefit) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-5, 5);
  for (const int count : {0, 1, 3, 5, 300}) {
    std::vector<Box> all = boxes(count);
    BoxTree tree(all);
    for (int round = 0; round < 2; ++round) {
      int asked = 0;
      for (int i = 0; i < 100; ++i) {
        const Vec3 point(place(random), place(random), place(random));
        const int expected = nearest_of_all(all, point);
        const auto squared = [&](int item) {
          ++asked;
          return (point - all[static_cast<std::size_t>(item)].low).squaredNorm();
        };
        EXPECT_EQ(tree.nearest(point, squared), expected);
        for (const int first : {0, expected, static_cast<int>(all.size()) - 1})
          if (first >= 0 && !all.empty()) {
            EXPECT_EQ(tree.nearest(point, squared, first), expected);
          }
      }
      if (count == 300 && round == 0) {
        EXPECT_LT(asked, 0.2 * 400 * static_cast<double>(all.size()));
      }
      for (Box& box : all) {  // all items elsewhere, one beside another
        const Vec3 by(place(random), 0.1 * place(random), 0);
        box.low += by;
        box.high += by;
      }
      tree.refit(all);
    }
  }
}

TEST(BoxTree, NothingIsNearestToAPointThatIsNotANumber) {
  const std::vector<Box> all = boxes(20);
  const Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(BoxTree(all).nearest(point, [&](int i) { return (point - all[i].low).squaredNorm(); }),
            -1);
}

TEST(BoxTree, MeetingPairsAreThoseOfTryingAllWithAMark) {
  const std::vector<Box> all = boxes(400);
  const BoxTree tree(all);
  for (const std::size_t every : {1, 3, 50}) {
    std::vector<char> marked(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); i += every) marked[i] = 1;
    std::multiset<std::pair<int, int>> expected, found;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j)
        if ((marked[i] || marked[j]) && all[i].meets(all[j])) expected.insert({i, j});
    tree.meeting_pairs(marked, [&](int i, int j) {
      found.insert(std::minmax(i, j));
      return true;
    });
    ASSERT_GT(expected.size(), 10U);
    EXPECT_EQ(found, expected) << every;
  }
}

// Enough of them for several parts.
TEST(BoxTree, ThePartsOfASharedSearchHaveThePairsInTheSameOrder) {
  const std::vector<Box> all = boxes(9000);
  const BoxTree tree(all);
  std::vector<char> marked(all.size(), 0);
  for (std::size_t i = 0; i < all.size(); i += 2) marked[i] = 1;
  using Pairs = std::vector<std::pair<int, int>>;
  Pairs expected;
  tree.meeting_pairs(marked, [&](int i, int j) {
    expected.emplace_back(i, j);
    return true;
  });
  for (const int threads : {1, 3}) {
    std::vector<Pairs> parts;
    tree.meeting_pairs(
        marked, threads, [&](std::size_t count) { parts.resize(count); },
        [&](std::size_t part, int i, int j) {
          parts[part].emplace_back(i, j);
          return true;
        });
    EXPECT_GT(parts.size(), 8U);
    Pairs found;
    for (const Pairs& part : parts) found.insert(found.end(), part.begin(), part.end());
    EXPECT_EQ(found, expected) << threads << " threads";
    std::vector<int> seen(parts.size());
    tree.meeting_pairs(
        marked, threads, [](std::size_t) {},
        [&](std::size_t part, int, int) { return ++seen[part] < 5; });
    for (std::size_t p = 0; p < parts.size(); ++p)
      EXPECT_EQ(seen[p], std::min<int>(5, static_cast<int>(parts[p].size())));
  }
  int parts = 0;
  const auto count = [&](std::size_t found) { parts += static_cast<int>(found); };
  const auto never = [](std::size_t, int, int) { return ADD_FAILURE(), false; };
  tree.meeting_pairs(std::vector<char>(all.size(), 0), 2, count, never);
  BoxTree().meeting_pairs({}, 2, count, never);
  EXPECT_EQ(parts, 0);
}

TEST(BoxTree, ASearchForPairsEndsWhereItIsToldTo) {
  const std::vector<Box> all = boxes(400);
  int seen = 0;
  BoxTree(all).meeting_pairs(std::vector<char>(all.size(), 1),
                             [&](int, int) { return ++seen < 5; });
  EXPECT_EQ(seen, 5);
}

}  // namespace
}  // namespace vasorod
