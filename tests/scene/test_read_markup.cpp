#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "scene/read_markup.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

class ReadMarkup : public ScratchFolder {
 protected:
  std::vector<MarkupPoint> read(const std::string& text) const {
    return read_markups(write("picks.mrk.json", text));
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      const std::string sentence = error.what();
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      EXPECT_LT(sentence.size(), 500u);
      return sentence;
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
  }
};

std::string markup(const std::string& keys) {
  return R"({"@schema": "markups-schema-v1.0.3.json#", "markups": [{"type": "Fiducial", )" + keys +
         R"("controlPoints": [{"id": "1", "label": "cut", "position": [1, -2, 3.5],
            "orientation": [-1, 0, 0, 0, -1, 0, 0, 0, 1], "positionStatus": "defined"}]}]})";
}

TEST_F(ReadMarkup, ReadsEveryNameOfASpace) {
  for (const auto& [keys, space] : {std::pair("", "LPS"),
                                    {R"("coordinateSystem": "LPS", )", "LPS"},
                                    {R"("coordinateSystem": "RAS", )", "RAS"},
                                    {R"("coordinateSystem": 0, )", "RAS"},
                                    {R"("coordinateSystem": "1", )", "LPS"},
                                    {R"("coordinateUnits": ["mm", "UCUM", "millimeter"], )", "LPS"},
                                    {R"("coordinateUnits": "mm", )", "LPS"}}) {
    const auto points = read(markup(keys));
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].label, "cut");
    EXPECT_EQ(points[0].point, Vec3(1, -2, 3.5));
    EXPECT_EQ(points[0].space, space) << keys;
  }
}

TEST_F(ReadMarkup, PointsOfAllMarkupsAreReadAndThoseNotPlacedAreNot) {
  const auto points = read(R"({"markups": [
    {"coordinateSystem": "RAS", "controlPoints": [{"label": "a", "position": [1, 2, 3]}]},
    {"type": "Plane"},
    {"controlPoints": [{"label": "b", "positionStatus": "undefined"},
                       {"label": "c", "position": [4, 5, 6]}]}]})");
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].label + points[0].space, "aRAS");
  EXPECT_EQ(points[1].label + points[1].space, "cLPS");
}

TEST_F(ReadMarkup, WhatIsNoMarkupsFileIsOneSentence) {
  for (const auto& [text, words] : std::vector<std::array<std::string, 2>>{
           {"", "found no JSON"},
           {R"({"markups": [)", "found no JSON"},
           {"[]", "found other JSON"},
           {R"({"markups": {}})", "found other JSON"},
           {R"({"markups": [7]})", "markups[0]: found 7"},
           {R"({"markups": [{"controlPoints": 7}]})", "markups[0].controlPoints: found 7"},
           {R"({"markups": [{"controlPoints": [7]}]})", "controlPoints[0]: found 7"},
           {R"({"markups": [{"controlPoints": [{"label": "a"}]}]})", "found no position"},
           {R"({"markups": [{"controlPoints": [{"label": 7, "position": [1, 2, 3]}]}]})",
            "controlPoints[0].label: found 7"},
           {R"({"markups": [{"controlPoints": [{"position": [1, 2]}]}]})", "found [1,2]"},
           {R"({"markups": [{"controlPoints": [{"position": [1, 2, "x"]}]}]})", "three numbers"},
           {R"({"markups": [{"controlPoints": [{"position": [1, 2, 1e300]}]}]})", "three numbers"},
           {markup(R"("coordinateSystem": "IJK", )"), "coordinateSystem: found \"IJK\""},
           {markup(R"("coordinateSystem": 2, )"), "expected LPS or RAS"},
           {markup(R"("coordinateUnits": "um", )"), "coordinateUnits: found \"um\", expected mm"}})
    EXPECT_NE(refusal(text).find(words), std::string::npos) << text << '\n' << refusal(text);
  EXPECT_THROW(read_markups(folder / "none.mrk.json"), InputError);
  EXPECT_THROW(read_markups(folder), InputError);
}

TEST_F(ReadMarkup, DepthFillsNoStack) {
  EXPECT_NE(refusal(std::string(1'000'000, '[')).find("no JSON"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
