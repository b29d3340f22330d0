#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "surgery/incision.h"
#include "surgery/surface_checks.h"
#include "surgery/tube_binding.h"

namespace vasorod {
namespace {

TEST(Incision, HundredsOfSlitsAreCleanParallelToTheAxisAndOfTheLengthAskedFor) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::MadeBySurgery worst;
  int inexact = 0;
  for (int i = 0; i < 80; ++i) {
    const int around = 10 + static_cast<int>(uniform(random) * 40);
    auto shape = testing::irregular_shape(i, around, 1.5, random);
    shape.along = std::max(12, shape.along);
    const auto tube = testing::noisy_tube(shape);
    const double theta = 2 * M_PI * uniform(random), s = 14 + 12 * uniform(random);
    // A length on the outside of the bend is longer than on the axis: keeps away from the ends.
    const double length = 4 + 12 * uniform(random);
    const Vec3 pick = testing::on_tube(shape, theta, s, 5 + uniform(random));
    SCOPED_TRACE("slit " + std::to_string(i));
    const auto outcome =
        open_incision(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points), {},
                      pick, length, 5);

    ASSERT_TRUE(testing::tube_with_a_hole(outcome.surface.triangles, outcome.rim));
    const int n = outcome.other_tip;
    ASSERT_EQ(outcome.rim.size(), 2 * static_cast<size_t>(n));

    // Both banks coincide, have the requested length, and the pick's vertex in the middle.
    double bank = 0, half = 0;
    const auto at = [&](int k) {
      return Vec3(outcome.surface.points.row(outcome.rim[static_cast<size_t>(k)]));
    };
    for (int k = 0; k < n; ++k) {
      bank += (at(k + 1) - at(k)).norm();
      if (k + 1 == outcome.middle) half = bank;
      if (k > 0) {
        EXPECT_EQ((at(k) - at(2 * n - k)).norm(), 0);
      }
    }
    EXPECT_NEAR(bank, outcome.length, 1e-12 * length);
    if (std::abs(outcome.length / length - 1) > 1e-6) ++inexact;
    EXPECT_NEAR(outcome.length, length, 0.3 * mean_edge_length(tube));
    EXPECT_NEAR(half, length / 2, 1e-6 * length + std::abs(outcome.length - length));
    EXPECT_LT((at(outcome.middle) - outcome.pick).norm(), 0.2 * mean_edge_length(tube));

    // On the isoline of the angle, from small s to large s.
    const auto exact = testing::tube_binding(shape, outcome.surface.points);
    for (int k = 0; k <= n; ++k) {
      const Vec3& x = exact[static_cast<size_t>(outcome.rim[static_cast<size_t>(k)])].local;
      EXPECT_LT(std::abs(x.y() * std::cos(theta) - x.x() * std::sin(theta)),
                0.3 * mean_edge_length(tube));
      EXPECT_GT(x.x() * std::cos(theta) + x.y() * std::sin(theta), 4);
    }
    const double first = exact[static_cast<size_t>(outcome.rim[0])].s;
    EXPECT_LT(first, exact[static_cast<size_t>(outcome.rim[static_cast<size_t>(n)])].s);

    EXPECT_LT(testing::source_error(tube, outcome.surface, outcome.sources), 1e-11);
    EXPECT_NEAR(total_area(outcome.surface) / total_area(tube), 1, shape.around < 16 ? 0.01 : 2e-3);
    for (int v = 0; v < tube.points.rows(); ++v)
      if (outcome.sources[static_cast<size_t>(v)].is_original()) {
        EXPECT_EQ(outcome.sources[static_cast<size_t>(v)].vertex[0], v);
      }
    const auto made = testing::made_by_surgery(tube, outcome.surface, outcome.sources);
    worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
    worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 4);
  EXPECT_LE(inexact, 1);
}

TEST(Incision, OnABentTubeTheSlitIsAsLongOnTheOuterSideAsOnTheInnerOne) {
  testing::TubeShape shape;
  shape.around = 48;
  shape.along = 60;
  shape.bend = 1.2;
  const auto tube = testing::noisy_tube(shape);
  const auto rod = testing::tube_rod(shape);
  const auto binding = testing::tube_binding(shape, tube.points);
  for (const double theta : {0.0, M_PI / 2, M_PI}) {
    const auto outcome =
        open_incision(tube, rod, binding, {}, testing::on_tube(shape, theta, 20, 5), 10, 5);
    EXPECT_NEAR(outcome.length, 10, 1e-9);
    // In arc length of the rod, the same slit covers more of the axis on the inner side (theta = 0,
    // towards the centre).
    const auto exact = testing::tube_binding(shape, outcome.surface.points);
    const double covered =
        exact[static_cast<size_t>(outcome.rim[static_cast<size_t>(outcome.other_tip)])].s -
        exact[static_cast<size_t>(outcome.rim[0])].s;
    const double arc = shape.length / shape.bend;
    EXPECT_NEAR(covered, 10 * arc / (arc - 5 * std::cos(theta)), 0.02);
  }
}

TEST(Incision, TheJumpOfTheAngleIsNoSeam) {
  // theta0 = pi, where atan2 jumps.
  testing::TubeShape shape;
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  const auto outcome =
      open_incision(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points), {},
                    {-5, 0, 20}, 12, 5);
  EXPECT_NEAR(outcome.length, 12, 1e-9);
  for (const int v : outcome.rim) EXPECT_LT(outcome.surface.points(v, 0), -4.5);
}

TEST(Incision, BadIncisionsAreRefusedWithASentence) {
  testing::TubeShape shape;
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  std::vector<int> branches(static_cast<size_t>(tube.points.rows()), 0);
  for (int v = 0; v < tube.points.rows(); ++v)
    if (tube.points(v, 2) > 25) branches[static_cast<size_t>(v)] = 1;
  const auto says = [&](const Vec3& pick, double length, const std::string& part) {
    try {
      open_incision(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points),
                    branches, pick, length, 5);
      ADD_FAILURE() << "accepted, expected: " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  says({5, 0, 10}, 24, "runs into an open end");
  says({5, 0, 20}, 15, "runs into a fork");
  says({5, 0, 20}, 15, "expected one of at most ");
  says({10.3, 0, 10}, 5, "off the vessel");
  says({5, 0, 41}, 5, "lies at an open end");
  says({5, 0, 10}, 0.2, "too short");
  int mixed = 0;  // a triangle between the two branches
  while (branches[static_cast<size_t>(tube.triangles(mixed, 0))] ==
         branches[static_cast<size_t>(tube.triangles(mixed, 1))])
    ++mixed;
  const Vec3 middle =
      (tube.points.row(tube.triangles(mixed, 0)) + tube.points.row(tube.triangles(mixed, 1)) +
       tube.points.row(tube.triangles(mixed, 2))) /
      3;
  says(middle, 5, "lies at a fork");
}

TEST(Incision, TheLengthThatFitsIsSaidAndFits) {
  testing::TubeShape shape;
  shape.jitter = 0.2;
  const auto tube = testing::noisy_tube(shape);
  const auto open = [&](const Vec3& pick, double length) {
    return open_incision(tube, testing::tube_rod(shape), testing::tube_binding(shape, tube.points),
                         {}, pick, length, 5, 8);
  };
  for (const double s : {6.0, 10.0, 31.0}) {  // the nearer end decides, whichever side it is on
    const Vec3 pick(5, 0, s);
    std::string sentence;
    try {
      open(pick, 30);
    } catch (const InputError& error) {
      sentence = error.what();
    }
    const std::string says = "expected one of at most ";
    ASSERT_NE(sentence.find(says), std::string::npos) << sentence;
    const double fits = std::stod(sentence.substr(sentence.find(says) + says.size()));
    const double end = 2 * std::min(s, shape.length - s), edge = shape.length / shape.along;
    EXPECT_LT(fits, end);
    EXPECT_GT(fits, end - 4 * edge);
    EXPECT_NEAR(open(pick, fits).length, fits, 1e-6);
    const std::string factor = "`incision_length: ";
    EXPECT_NEAR(std::stod(sentence.substr(sentence.find(factor) + factor.size())), fits / 8, 0.01);
  }
}

}  // namespace
}  // namespace vasorod
