#include <fstream>
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "program/small_glenn.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

class ReadVary : public ScratchFolder {
 protected:
  ExploreSpec read(const std::string& options) const {
    std::ofstream(folder / "scene.yaml")
        << small_glenn("skin") << "explore: {rotation_deg: 0, " << options << "}\n";
    return read_scene(folder / "scene.yaml").explore.value();
  }
};

TEST_F(ReadVary, DistributionsAndDefaults) {
  const ExploreSpec more = read(
      "vary: {uncertain: [{what: young, vessel: svc, factor: [0.7, 1.4]}, {what: cut, sd: 1.5}]}");
  EXPECT_FALSE(more.refine);
  ASSERT_TRUE(more.vary);
  EXPECT_EQ(more.vary->samples, 20);
  EXPECT_EQ(more.vary->best, 3);
  EXPECT_EQ(more.vary->seed, 1);
  EXPECT_FALSE(more.vary->fidelity);
  const auto& [young, cut] = std::tie(more.vary->uncertain[0], more.vary->uncertain[1]);
  EXPECT_EQ(young.vessel, "svc");
  EXPECT_EQ(young.low, 0.7);
  EXPECT_EQ(young.high, 1.4);
  EXPECT_TRUE(young.scales());
  EXPECT_EQ(cut.sd, 1.5);
  EXPECT_FALSE(cut.scales());
  EXPECT_EQ(to_string(cut.what), "cut");
  EXPECT_EQ(read("refine: {evaluations: 7, best: 2}").refine->evaluations, 7);
  EXPECT_EQ(read("refine: {}").refine->best, 1);
  EXPECT_FALSE(read("best: 3").vary);
}

TEST_F(ReadVary, WhatIsWrongIsOneSentence) {
  for (const auto& [one, says] : std::vector<std::pair<std::string, std::string>>{
           {"{what: colour, sd: 0.1}", "what: found \"colour\""},
           {"{what: young}", "found neither factor nor sd, expected factor: [low, high] or sd"},
           {"{what: young, sd: 0.1, factor: [1, 2]}", "found both factor and sd"},
           {"{what: young, offset: [1, 2]}", "offset: found it with young"},
           {"{what: cut, factor: [1, 2]}", "factor: found it with cut, expected offset"},
           {"{what: young, factor: [2, 1]}", "a low end that is not below the high one"},
           {"{what: young, factor: [1]}", "found 1 numbers, expected two"},
           {"{what: young, factor: [0, 1]}", "expected a number from 0.1 to 10"},
           {"{what: young, sd: 0.3}", "found 0.3, expected at most 0.2 of a factor"},
           {"{what: young, vessel: svx, sd: 0.1}", "svx"},
           {"{what: cut, vessel: svc, sd: 0.1}", "vessel: found it with cut"},
           {"{what: pressure, sd: 0.1}", "found pressure in a scene without one"}})
    try {
      read("vary: {uncertain: [" + one + "]}");
      ADD_FAILURE() << one << " is taken";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("explore.vary.uncertain[0]"), std::string::npos)
          << error.what();
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  EXPECT_THROW(read("vary: {uncertain: []}"), InputError);
  EXPECT_THROW(read("vary: {uncertain: [{what: cut, sd: 1}], samples: 1}"), InputError);
  EXPECT_THROW(read("refine: {evaluations: 0}"), InputError);
}

}  // namespace
}  // namespace vasorod::testing
