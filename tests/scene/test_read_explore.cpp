#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

ExploreSpec read(const std::string& options) {
  return read_scene_text(small_glenn("skin") + "explore: {" + options + "}\n").explore.value();
}

TEST(ReadExplore, OneValueAListAndStepsAreLists) {
  EXPECT_EQ(read("cut_along: 0.5").cut_along, std::vector<double>{0.5});
  EXPECT_EQ(read("cut_along: [0.5, 0.25]").cut_along, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(read("around_deg: {from: -90, to: 90, steps: 5}").around_deg,
            (std::vector<double>{-90, -45, 0, 45, 90}));
  EXPECT_EQ(read("around_deg: {from: 30, to: 90, steps: 1}").around_deg, std::vector<double>{30});
  EXPECT_EQ(read("incision_length: {from: 1, to: 1.5, steps: 3}").incision_length,
            (std::vector<double>{1, 1.25, 1.5}));
}

TEST(ReadExplore, WordsAndShapes) {
  const ExploreSpec spec =
      read("rotation_deg: [auto, -45], incision_shape: [slit, {ellipse: 0.4}], stages: paper");
  EXPECT_EQ(spec.rotation_deg, (std::vector<std::optional<double>>{std::nullopt, -45}));
  ASSERT_EQ(spec.incision_shape.size(), 2U);
  EXPECT_FALSE(spec.incision_shape[0]);
  EXPECT_EQ(spec.incision_shape[1]->ratio, 0.4);
  EXPECT_EQ(spec.stages, std::vector<std::string>{"paper"});
  EXPECT_EQ(read("rotation_deg: auto").rotation_deg.size(), 1U);
  EXPECT_EQ(read("rotation_deg: {from: 0, to: 90, steps: 2}").rotation_deg,
            (std::vector<std::optional<double>>{0, 90}));
}

TEST(ReadExplore, TheRestHasDefaults) {
  const ExploreSpec spec = read("weights: {mouth: 2}, thresholds: {lumen: 0.5}");
  EXPECT_EQ(spec.stages, (std::vector<std::string>{"skin", "coupled"}));
  EXPECT_EQ(spec.best, 10);
  EXPECT_EQ(spec.weights, (std::map<std::string, double>{{"mouth", 2}}));
  EXPECT_EQ(spec.thresholds, (std::map<std::string, double>{{"lumen", 0.5}}));
}

TEST(ReadExplore, BadOptionsAreOneSentence) {
  for (const auto& [options, says] : std::vector<std::pair<std::string, std::string>>{
           {"cut_along: 1.5", "explore.cut_along: found 1.5, expected a number from 0 to 1"},
           {"cut_along: [0.5, high]", "explore.cut_along[1]: found \"high\""},
           {"cut_along: []", "explore.cut_along: found an empty list"},
           {"cut_along: {from: 0, to: 1}", "explore.cut_along.steps: found nothing"},
           {"cut_along: {from: 0, to: 1, steps: 2.5}", "explore.cut_along.steps: found 2.5"},
           {"rotation_deg: [automatic]", "explore.rotation_deg[0]: found \"automatic\""},
           {"stages: [skin, fine]", "explore.stages[1]: found \"fine\""},
           {"best: 0", "explore.best: found 0"},
           {"weights: {mouth: -1}", "explore.weights.mouth: found -1"},
           {"thresholds: {lumen: 1}", "explore.thresholds.lumen: found 1"},
           {"cut: 0.5", "explore: found the unknown key \"cut\""}})
    try {
      read(options);
      ADD_FAILURE() << options;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(", expected "), std::string::npos) << error.what();
    }
}

TEST(ReadExplore, NeedsAGlenn) {
  try {
    read_scene_text(
        "scene: a\nunits: {length: mm, stress: MPa}\nvessels:\n  - name: t\n    tube: {length: 10, "
        "radius: 3, around: 8, along: 8}\n    wall: {thickness: 0.4, young: 1, poisson: 0.3}\n"
        "ends: [{vessel: t, end: start, hold: true}]\nfidelity: rod\nexplore: {best: 3}\n");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("found it without surgery: glenn"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace vasorod::testing
