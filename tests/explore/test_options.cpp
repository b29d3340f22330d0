#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "explore/options.h"
#include "explore/small_exploration.h"
#include "infant_anatomy.h"
#include "surgery/pick_place.h"

namespace vasorod::testing {
namespace {

std::vector<std::string> texts_of(const std::string& options, const PickSpec& incision = {}) {
  std::vector<std::string> texts;
  for (const Option& option : options_of(small_exploration(options), incision))
    texts.push_back(option.text());
  return texts;
}

TEST(Options, AreEveryCombinationTheLastKeyFastest) {
  EXPECT_EQ(texts_of("rotation_deg: [auto, 45], cut_along: {from: 0.5, to: 0.75, steps: 2}"),
            (std::vector<std::string>{
                "cut_along 0.5, rotation_deg auto", "cut_along 0.5, rotation_deg 45",
                "cut_along 0.75, rotation_deg auto", "cut_along 0.75, rotation_deg 45"}));
}

TEST(Options, AlikeOnesAreOne) {
  EXPECT_EQ(texts_of("cut_along: [0.5, 0.5], rotation_deg: [auto, auto, 0]"),
            (std::vector<std::string>{"cut_along 0.5, rotation_deg auto",
                                      "cut_along 0.5, rotation_deg 0"}));
}

TEST(Options, AnEllipseWithALengthHasNoOther) {
  const auto texts = texts_of(
      "incision_shape: [slit, {ellipse: {length: 9, width: 4}}], incision_length: [1, 1.25]");
  EXPECT_EQ(texts, (std::vector<std::string>{"incision_shape slit, incision_length 1",
                                             "incision_shape slit, incision_length 1.25",
                                             "incision_shape ellipse width 4 length 9"}));
}

TEST(Options, SetTheOperationAndNothingElse) {
  const Scene scene = small_exploration(
      "cut_along: 0.6, cut_tilt_deg: 10, incision_along: 0.4, around_deg: 20, incision_length: "
      "1.25, incision_shape: {ellipse: 0.5}, rotation_deg: 30");
  PickSpec incision;
  incision.along = 0.5;
  incision.to = scene.glenn->keep;
  const auto options = options_of(scene, incision);
  ASSERT_EQ(options.size(), 1U);
  const GlennSpec& glenn = options.front().operation;
  EXPECT_EQ(glenn.cut.along, 0.6);
  EXPECT_EQ(glenn.cut_tilt_deg, 10);
  EXPECT_EQ(glenn.incision.along, 0.4);
  EXPECT_EQ(glenn.incision.around_deg, 20);
  EXPECT_TRUE(glenn.incision.to);
  EXPECT_EQ(glenn.incision_length, 1.25);
  ASSERT_TRUE(glenn.ellipse);
  EXPECT_EQ(glenn.ellipse->ratio, 0.5);
  EXPECT_EQ(glenn.rotation_deg, 30);
  EXPECT_EQ(glenn.keep.near, scene.glenn->keep.near);
  const Scene changed = with_option(scene, options.front(), "one");
  EXPECT_EQ(changed.name, "small-glenn-one");
  EXPECT_FALSE(changed.explore);
  EXPECT_EQ(changed.glenn->cut.along, 0.6);
  EXPECT_EQ(changed.vessels.size(), scene.vessels.size());
}

// What is not listed stays as the scene has it: here, a picked point.
TEST(Options, ARotationAloneLeavesThePicksAlone) {
  const auto options = options_of(small_exploration("rotation_deg: 10"), {});
  EXPECT_FALSE(options.front().operation.cut.along);
  EXPECT_EQ(options.front().operation.incision.point, Vec3(0, 0, 4));
}

TEST(Options, NoneAndTooManyAreOneSentence) {
  const auto refusal = [](const std::string& options) -> std::string {
    try {
      texts_of(options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("best: 3").find("found no values, expected at least one of cut_along"),
            std::string::npos);
  const std::string span = "{from: 0, to: 1, steps: 1000}";
  EXPECT_NE(refusal("cut_along: " + span + ", incision_along: " + span)
                .find("found 1000000 or more options, expected at most 10000"),
            std::string::npos);
}

// A point on a tube along x from -25 to 25 whose d1 is z: known fraction and angle.
TEST(Options, APickedPointIsItsPlaceOnTheAxis) {
  Scene scene = small_exploration("incision_along: 0.5");
  const FittedVessels fitted = fit_vessels(scene);
  for (const double degrees : {0.0, 50.0, -130.0})
    for (const double x : {-10.0, 5.0}) {
      const double angle = degrees * M_PI / 180;
      // d2 = d3 x d1 = x x z = -y.
      scene.glenn->incision = Vec3(x, -4 * std::sin(angle), 4 * std::cos(angle));
      const PickSpec pick = incision_by_fraction(scene, fitted);
      EXPECT_NEAR(pick.along.value(), (x + 25) / 50, 2e-3);
      EXPECT_NEAR(pick.around_deg, degrees, 0.5);
    }
}

// On the bundled artery, whose right branch is not the farthest end: the fraction leads back to the
// point.
TEST(Options, APickOnABranchIsFoundAgainByItsFraction) {
  Scene scene = small_exploration("incision_along: 0.5");
  scene.vessels[1].tube.reset();
  scene.vessels[1].surface = infant_file("pulmonary_artery");
  scene.vessels[1].surface_is = SurfaceIs::outer;
  const Vec3 point(-7.19, 8.47, 2.06);
  scene.glenn->incision = point;
  const FittedVessels fitted = fit_vessels(scene);
  const PickSpec pick = incision_by_fraction(scene, fitted);
  EXPECT_GT(pick.along.value(), 0.3);
  const PickPlace place = place_incision_pick("", pick, fitted.vessels[1]);
  EXPECT_LT((place.point - point).norm(), 0.2);
}

}  // namespace
}  // namespace vasorod::testing
