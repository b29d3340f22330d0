#include <gtest/gtest.h>

#include "bodies/spring_coefficients.h"
#include "geometry/triangle_surface.h"
#include "judge/judged_tube.h"
#include "predict/small_scenes.h"
#include "predict/surface_bodies.h"

namespace vasorod {
namespace {

// A bent tube held rigidly at its start and softly at its end, beside a tube at rest and an
// obstacle.
struct Fixture {
  Scene scene;
  Prediction prediction;
  Fixture() {
    prediction.scene = &scene;
    for (const char* name : {"svc", "rpa", "heart"}) {
      PredictedVessel& vessel = prediction.vessels.emplace_back();
      vessel.prepared = shapes::judged_tube(50);
      vessel.prepared.spec.name = name;
    }
    PredictedVessel& svc = prediction.vessels[0];
    svc.rod.poses = shapes::strained(svc.prepared.vessel.rod, shapes::change_of(0, {0, 0.002, 0}));
    svc.rod_solved = true;
    svc.conditions.ends = {{"start", 0, true}, {"end", 1, false}};
    prediction.vessels[2].prepared.spec.role = Role::obstacle;
  }
};

TEST(SurfaceBodies, BodiesAreTheVesselsWithTheirWalls) {
  const Fixture f;
  const BodyProblem problem = body_problem(f.prediction);
  ASSERT_EQ(problem.bodies.size(), 3u);
  const PredictedVessel& svc = f.prediction.vessels[0];
  const SurfaceBody& body = problem.bodies[0];
  EXPECT_EQ(body.name, "svc");
  EXPECT_EQ(body.rest.points, svc.prepared.vessel.surface.points);
  EXPECT_EQ(body.thickness, 1);
  EXPECT_EQ(body.offset, 0.5) << "the surface is mid-wall";
  EXPECT_EQ(body.carried,
            carried_points(svc.prepared.vessel.rod, svc.rod.poses, svc.prepared.vessel.binding));
  EXPECT_EQ(body.rotations.size(), static_cast<size_t>(body.rest.points.rows()));
  // Stiff where the start's ring is, nowhere else: a soft end's ring is free.
  int fixed = 0;
  for (const char flag : body.fixed) fixed += flag;
  const auto& ring = svc.prepared.vessel.ends[0].loop;
  EXPECT_EQ(fixed, static_cast<int>(ring.size()));
  for (const int vertex : ring) EXPECT_TRUE(body.fixed[static_cast<size_t>(vertex)]);
  EXPECT_EQ(problem.bodies[1].carried.rows(), 0) << "its rod was not solved";
  EXPECT_TRUE(problem.bodies[2].obstacle);
}

TEST(SurfaceBodies, SpringsComeFromTheWallOrFromTheScene) {
  Fixture f;
  const Coefficients own = body_problem(f.prediction).bodies[0].k;
  EXPECT_GT(own.binding, 0);
  EXPECT_GT(own.stretching, own.bending);
  // Twice as stiff a wall has springs twice as stiff.
  f.prediction.vessels[0].prepared.spec.wall->material = Material::isotropic(1, 0.3);
  const Coefficients twice = body_problem(f.prediction).bodies[0].k;
  EXPECT_NEAR(twice.binding, 2 * own.binding, 1e-12 * own.binding);
  EXPECT_NEAR(twice.bending, 2 * own.bending, 1e-12 * own.bending);
  EXPECT_NEAR(twice.stretching, 2 * own.stretching, 1e-12 * own.stretching);
  f.prediction.vessels[0].prepared.spec.coefficients = Coefficients{1, 2, 3};
  const Coefficients given = body_problem(f.prediction).bodies[0].k;
  EXPECT_EQ(given.binding, 1);
  EXPECT_EQ(given.bending, 2);
  EXPECT_EQ(given.stretching, 3);
}

TEST(SurfaceBodies, SeamsAndContactsNameBodies) {
  Fixture f;
  EXPECT_EQ(body_problem(f.prediction).contacts,
            (std::vector<std::pair<int, int>>{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_TRUE(body_problem(f.prediction).seams.empty());
  f.scene.contact = {{{"heart", "svc"}}};
  f.prediction.operation.emplace();
  f.prediction.operation->vessels[0].name = "svc";
  f.prediction.operation->vessels[1].name = "rpa";
  f.prediction.operation->pairs = {{5, 6}, {7, 8}};
  const BodyProblem problem = body_problem(f.prediction);
  EXPECT_EQ(problem.contacts, (std::vector<std::pair<int, int>>{{2, 0}}));
  ASSERT_EQ(problem.seams.size(), 2u);
  EXPECT_EQ(problem.seams[1].body_a, 0);
  EXPECT_EQ(problem.seams[1].vertex_a, 7);
  EXPECT_EQ(problem.seams[1].body_b, 1);
  EXPECT_EQ(problem.seams[1].vertex_b, 8);
}

TEST(SurfaceBodies, WhatIsSolvedComesBackAndWhatWasLeftOutIsSaid) {
  Fixture f;
  SolvedSurfaces surfaces;
  for (int b = 0; b < 3; ++b) {
    BodySolution& body = surfaces.solution.bodies.emplace_back();
    body.modelled = b == 0;
    body.positions = Points::Constant(4, 3, b);
    body.pressure = Eigen::VectorXd::Constant(4, 10 * b);
  }
  f.prediction.crossings.emplace();
  take_surfaces(std::move(surfaces), "skin", f.prediction);
  ASSERT_TRUE(f.prediction.surfaces);
  EXPECT_FALSE(f.prediction.crossings) << "those of where the walls were";
  for (int b = 0; b < 3; ++b) {
    EXPECT_EQ(f.prediction.vessels[static_cast<size_t>(b)].positions, Points::Constant(4, 3, b));
    EXPECT_EQ(f.prediction.vessels[static_cast<size_t>(b)].pressure[0], 10 * b);
  }
  EXPECT_EQ(f.prediction.left_out.count("skin of svc"), 0u);
  EXPECT_EQ(f.prediction.left_out.count("skin of rpa"), 1u);
  EXPECT_EQ(f.prediction.left_out.count("skin of heart"), 0u) << "an obstacle never moves";
  EXPECT_EQ(f.prediction.left_out.at("contact"), "no vessel within reach");
}

TEST(SurfaceBodies, AContactWithinReachIsNotLeftOut) {
  Fixture f;
  SolvedSurfaces surfaces;
  surfaces.solution.bodies.resize(3);
  surfaces.solution.contacts.resize(2);
  surfaces.solution.contacts[1].within_reach = true;
  take_surfaces(std::move(surfaces), "skin", f.prediction);
  EXPECT_EQ(f.prediction.left_out.count("contact"), 0u);
}

TEST(SurfaceBodies, ProgressIsToldEverySoManyIterations) {
  SolveOptions options;
  EXPECT_FALSE(iteration_progress("walls", 10, options));
  std::vector<std::string> told;
  options.progress = [&](const std::string& line) { told.push_back(line); };
  const auto progress = iteration_progress("walls", 10, options);
  for (int i = 1; i <= 25; ++i) progress({2, i, 0.5});
  EXPECT_EQ(told, (std::vector<std::string>{"walls: update 2, iteration 10",
                                            "walls: update 2, iteration 20"}));
}

}  // namespace
}  // namespace vasorod
