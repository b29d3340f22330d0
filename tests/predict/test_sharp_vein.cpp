#include <gtest/gtest.h>

#include "predict/sharp_vein.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;
using Kind = EndSelector::Kind;

// The strain of a tube whose end is moved aside between held ends, from its solved rod.
double strain_aside(double length, double offset) {
  Scene scene;
  scene.name = "aside";
  scene.vessels = {tube("vein", length)};
  scene.ends = {held("vein", Kind::start), moved("vein", Kind::end, {offset, 0, 0})};
  scene.fidelity = "rod";
  return predict(scene).validity.largest_strain;
}

// The solved rod agrees that over the stated length the offset is within range.
TEST(SharpVein, TheStatedLengthIsThatOfTheSolvedRod) {
  const SharpVein vein{"vein", "mm", 40, 12, strain_aside(40, 24)};
  ASSERT_GT(vein.strain, 0.3);
  EXPECT_NEAR(strain_aside(length_in_range(vein), 24), 0.2, 0.05);
}

TEST(SharpVein, TheSentenceSaysWhatWouldDo) {
  const SharpVein vein{"svc", "mm", 27, 19, 0.8};
  EXPECT_EQ(
      sharp_vein_sentence(vein),
      "vessel svc keeps 27 mm up to a mouth 19 mm wide, and its way to the incision strains "
      "its wall by 0.8: it has to fold; over about 54 mm the same way would strain it by 0.2; "
      "expected a cut that keeps more of it or an incision nearer to its own line");
  SharpVein turned = vein;
  turned.turned = true;
  EXPECT_TRUE(sharp_vein_sentence(turned)->ends_with("rotation_deg: auto, which twists it least"));
}

TEST(SharpVein, AVeinWithinTheModelsRangeNeedsNone) {
  EXPECT_FALSE(sharp_vein_sentence({"svc", "mm", 60, 12, 0.2}));
}

TEST(SharpVein, WithoutAnOperationThereIsNone) {
  const Scene scene = stretched_tube(0.01, "skin");
  Prediction prediction;
  prediction.scene = &scene;
  EXPECT_FALSE(sharp_vein(prediction));
}

}  // namespace
}  // namespace vasorod
