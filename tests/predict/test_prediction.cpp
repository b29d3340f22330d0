#include <gtest/gtest.h>

#include "predict/prediction.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;

Prediction two_vessels() {
  Prediction prediction;
  for (const char* name : {"svc", "rpa"}) {
    PredictedVessel& vessel = prediction.vessels.emplace_back();
    vessel.prepared.spec.name = name;
    for (const int node : {0, 7}) vessel.conditions.rod.supports.push_back(clamp(node));
  }
  return prediction;
}

TEST(Prediction, VesselsAreFoundByName) {
  const Prediction prediction = two_vessels();
  EXPECT_EQ(vessel_named(prediction, "svc"), 0u);
  EXPECT_EQ(vessel_named(prediction, "rpa"), 1u);
  EXPECT_EQ(refusal([&] { vessel_named(prediction, "vena"); }), "no vessel vena");
}

TEST(Prediction, OnlyAPlacedRimIsAMouthAndThatIsNotRigid) {
  Prediction prediction = two_vessels();
  EXPECT_EQ(mouth_of(prediction, prediction.vessels[0]), -1);
  EXPECT_EQ(rigid_nodes(prediction, prediction.vessels[0]), (std::vector<int>{0, 7}));
  prediction.operation.emplace();
  prediction.operation->vessels[0].name = "svc";
  prediction.operation->vessels[0].rim_node = 7;
  prediction.operation->vessels[1].name = "rpa";
  EXPECT_EQ(mouth_of(prediction, prediction.vessels[0]), 7);
  EXPECT_EQ(mouth_of(prediction, prediction.vessels[1]), -1);
  EXPECT_EQ(rigid_nodes(prediction, prediction.vessels[0]), std::vector<int>{0});
  EXPECT_EQ(rigid_nodes(prediction, prediction.vessels[1]), (std::vector<int>{0, 7}));
  // End to end, both vessels have a rim.
  prediction.operation->vessels[1].rim_node = 0;
  EXPECT_EQ(mouth_of(prediction, prediction.vessels[1]), 0);
  EXPECT_EQ(rigid_nodes(prediction, prediction.vessels[1]), std::vector<int>{7});
}

}  // namespace
}  // namespace vasorod
