#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vasorod/predict.h>
#include <vasorod/result_folder.h>

#include "explore/option_pictures.h"
#include "explore/small_exploration.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

class OptionPictures : public ScratchFolder {};

TEST(OptionLooks, ACommonOneShowsAllAndHasTheWidestRanges) {
  Look a, b;
  a.towards_eye = {1, 0, 0};
  a.centre = {0, 0, 0};
  a.height = 10;
  a.ranges = {{"twist_shear", {-1, 1}}};
  b.towards_eye = {0, 1, 0};
  b.centre = {3, 4, 0};
  b.height = 12;
  b.ranges = {{"twist_shear", {-0.5, 2}}, {"axial_stretch", {0.9, 1.1}}};
  const Look common = common_look({a, b});
  EXPECT_EQ(common.towards_eye, a.towards_eye);
  EXPECT_EQ(common.height, 12 + 2 * 5);
  EXPECT_EQ(common.ranges.at("twist_shear"), (std::array<double, 2>{-1, 2}));
  EXPECT_EQ(common.ranges.at("axial_stretch"), (std::array<double, 2>{0.9, 1.1}));
}

TEST_F(OptionPictures, OnePictureForEachColour) {
  Scene scene = small_exploration("rotation_deg: 10");
  Result result = predict(scene);
  const Look look = look_of(result);
  write_result_folder(result, folder / "result", {{}, 1, false});
  const auto colours = option_colours({});
  const auto pictures = nlohmann::json::parse(option_pictures(folder / "result", look, colours));
  ASSERT_EQ(pictures.size(), colours.size());
  for (const auto& [colour, title] : colours) {
    const auto text = pictures.at(colour).get<std::string>();
    EXPECT_EQ(text.substr(0, 11), "iVBORw0KGgo") << colour;  // a PNG's first bytes
    EXPECT_GT(text.size(), 3000U) << colour;
  }
  EXPECT_NE(pictures.at("vessel"), pictures.at("twist_shear"));
}

}  // namespace
}  // namespace vasorod::testing
