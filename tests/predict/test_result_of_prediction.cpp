#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "predict/result_of_prediction.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

// One tube held at both ends with made-up reactions, and a load.
struct Fixture {
  Scene scene;
  Prediction prediction;
  Fixture() {
    scene.name = "made-up";
    prediction.scene = &scene;
    prediction.fidelity = "skin";
    PredictedVessel& vessel = prediction.vessels.emplace_back();
    vessel.prepared = shapes::judged_tube();
    vessel.prepared.spec.name = "aorta";
    const auto& ends = vessel.prepared.vessel.ends;
    vessel.rod.poses = vessel.prepared.vessel.rod.rest;
    vessel.rod_solved = true;
    vessel.rod.summary.status = Status::converged;
    vessel.rod.summary.energy = 2;
    vessel.rod.summary.iterations = 6;
    vessel.rod.summary.residual = 1e-11;
    vessel.rod.reactions = {{ends[0].node, {0, 0, -5}, {1, 0, 0}, {0, 0, 0}},
                            {ends[1].node, {0, 0, 2}, {0, 1, 0}, {0, 0, 100}}};
    vessel.conditions.ends = {{"start", 0, true}, {"end", 1, false}};
    vessel.conditions.rod.loads = {{ends[1].node, Vec3(0, 0, 3), Vec3::Zero(), false}};
    vessel.positions = vessel.prepared.vessel.surface.points;
  }
};

TEST(ResultOfPrediction, RodsReactionsAndLoadsBecomeEndsAndBalance) {
  const Fixture f;
  const Result result = result_of(f.prediction, 2);
  EXPECT_EQ(result.scene, "made-up");
  EXPECT_EQ(result.fidelity, "skin");
  EXPECT_EQ(result.environment.threads, 2);
  ASSERT_EQ(result.ends.size(), 2u);
  EXPECT_EQ(result.ends[0].end, "start");
  EXPECT_EQ(result.ends[0].force, Vec3(0, 0, -5));
  EXPECT_EQ(result.ends[1].end, "end");
  EXPECT_EQ(result.ends[1].moment, Vec3(0, 1, 0));
  EXPECT_EQ(result.ends[1].center, Vec3(0, 0, 100));
  ASSERT_EQ(result.balance.size(), 1u);
  EXPECT_EQ(result.balance[0].support, Vec3(0, 0, -3));
  EXPECT_EQ(result.balance[0].load, Vec3(0, 0, 3));
  EXPECT_EQ(result.balance[0].residual, 0);
  EXPECT_FALSE(result.balance[0].binding);
  EXPECT_EQ(result.energy.rod, 2);
  EXPECT_EQ(result.energy.total(), 2);
  EXPECT_EQ(result.certificate.smallest_curvature_positive, true);
  EXPECT_EQ(result.model.terms, std::vector<std::string>{"rod"});
  EXPECT_EQ(result.model.vertices, f.prediction.vessels[0].positions.rows());
}

TEST(ResultOfPrediction, AnUnbalancedRodSaysByHowMuch) {
  Fixture f;
  f.prediction.vessels[0].rod.reactions[0].force = Vec3(0, 0, -4);
  EXPECT_NEAR(result_of(f.prediction, 1).balance.at(0).residual, 0.25, 1e-15);
}

SolvedSurfaces surfaces_of(const Prediction& prediction) {
  SolvedSurfaces surfaces;
  surfaces.solution.status = Status::buckled;
  surfaces.solution.residual = 1e-8;
  surfaces.solution.stretching_energy = 0.5;
  surfaces.solution.iterations = 9;
  BodySolution& body = surfaces.solution.bodies.emplace_back();
  body.modelled = true;
  body.positions = prediction.vessels[0].positions;
  body.support = Vec3(0, 1, 0);
  body.binding = Vec3(0, -1, 0);
  body.residual = 1e-7;
  return surfaces;
}

TEST(ResultOfPrediction, SurfacesBesideTheirRodsAddToThem) {
  Fixture f;
  f.prediction.surfaces = surfaces_of(f.prediction);
  const Result result = result_of(f.prediction, 1);
  EXPECT_EQ(result.status, Status::buckled) << "the worse of the two";
  EXPECT_EQ(result.energy.total(), 2.5);
  EXPECT_EQ(result.certificate.relative_residual, 1e-8);
  EXPECT_FALSE(result.certificate.smallest_curvature_positive) << "the rod's is not the whole's";
  const Balance& balance = result.balance.at(0);
  EXPECT_EQ(balance.support, Vec3(0, 1, -3));
  EXPECT_EQ(*balance.binding, Vec3(0, -1, 0));
  EXPECT_EQ(*balance.rod_unbalanced, Vec3(0, 1, 0));
  EXPECT_EQ(balance.residual, 1e-7);
  EXPECT_EQ(result.iterations.at("rod"), 6);
  EXPECT_EQ(result.iterations.at("surface"), 9);
}

TEST(ResultOfPrediction, SurfacesThatCarryEverythingLeaveTheRodsOut) {
  Fixture f;
  f.prediction.surfaces = surfaces_of(f.prediction);
  SolvedSurfaces& surfaces = *f.prediction.surfaces;
  surfaces.carry_everything = true;
  surfaces.load = {Vec3(0, 0.25, 0)};
  surfaces.ends = {{"aorta", "end", {0, 1, 0}, {}, {0, 0, 100}}};
  surfaces.solution.status = Status::converged;
  f.prediction.vessels[0].rod.summary.status = Status::iteration_limit;
  const Result result = result_of(f.prediction, 1);
  EXPECT_EQ(result.status, Status::converged) << "the rod was no more than the start";
  EXPECT_EQ(result.energy.rod, 0);
  EXPECT_EQ(result.iterations.at("rod"), 6);
  ASSERT_EQ(result.ends.size(), 1u);
  EXPECT_EQ(result.ends[0].force, Vec3(0, 1, 0));
  const Balance& balance = result.balance.at(0);
  EXPECT_EQ(balance.load, Vec3(0, 0.25, 0));
  EXPECT_EQ(balance.support, Vec3(0, 0.75, 0)) << "what the load does is not the support's";
  EXPECT_FALSE(balance.binding);
}

TEST(ResultOfPrediction, ContactsWithinReachAreNamedAndRemarkedOn) {
  Fixture f;
  PredictedVessel heart = f.prediction.vessels[0];
  heart.prepared.spec.name = "heart";
  heart.prepared.spec.role = Role::obstacle;
  heart.rod_solved = false;
  f.prediction.vessels.push_back(heart);
  f.prediction.surfaces = surfaces_of(f.prediction);
  SurfaceSolution& solution = f.prediction.surfaces->solution;
  solution.bodies.push_back(solution.bodies[0]);
  ContactSolution contact;
  contact.a = 0;
  contact.b = 1;
  solution.contacts.push_back(contact);
  EXPECT_TRUE(result_of(f.prediction, 1).contact.empty()) << "never near";
  solution.contacts[0].within_reach = true;
  solution.contacts[0].force = Vec3(1, 0, 0);
  solution.contacts[0].area = 12;
  solution.contacts[0].swallowed = 4;
  solution.contacts[0].held_depth = 0.5;
  const Result result = result_of(f.prediction, 1);
  ASSERT_EQ(result.contact.size(), 1u);
  EXPECT_EQ(result.contact[0].a, "aorta");
  EXPECT_EQ(result.contact[0].b, "heart");
  EXPECT_EQ(result.contact[0].area, 12);
  ASSERT_EQ(result.certificate.notes.size(), 2u);
  EXPECT_NE(result.certificate.notes[0].find("held 0.5 inside each other"), std::string::npos);
  EXPECT_NE(result.certificate.notes[1].find("4 points"), std::string::npos);
  EXPECT_EQ(result.balance.size(), 1u) << "obstacles are not balanced";
  EXPECT_EQ(result.model.terms, (std::vector<std::string>{"contact", "rod"}));
}

}  // namespace
}  // namespace vasorod
