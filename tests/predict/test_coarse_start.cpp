// Fidelity coupled with and without coarse walls before the fine ones.
#include <algorithm>
#include <gtest/gtest.h>

#include "predict/coarse_start.h"
#include "predict/fidelities/fidelities.h"
#include "predict/get_ready.h"
#include "predict/t_glenn.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double radius = 6;
constexpr int around = 56;
constexpr const char* found_on_coarse =
    "the vein's folds were found on walls with edges twice as long";

Result solved(const Scene& scene) {
  SolveOptions options;
  options.fidelity = "coupled";
  return predict(scene, options);
}

// The same from a closed seam alone: without the whole vessels no coarser ones are made.
Prediction closed_only(const Scene& scene) {
  SolveOptions options;
  options.stop = [] { return false; };
  options.progress = [](const std::string&) {};
  Prediction prediction;
  prediction.scene = &scene;
  for (const VesselSpec& spec : scene.vessels) {
    PredictedVessel& vessel = prediction.vessels.emplace_back();
    vessel.prepared = read_vessel(spec, scene);
    fit(vessel.prepared);
    vessel.conditions = end_conditions(scene, spec.name, vessel.prepared.vessel);
  }
  get_ready(prediction, LumenOf::wall, options, options.progress);
  solve_coupled(prediction, options);
  return prediction;
}

void expect_same(const Result& a, const Prediction& b, double tolerance) {
  ASSERT_LE(a.vessels.size(), b.vessels.size());  // the prediction may have the vein's stump, too
  for (size_t v = 0; v < a.vessels.size(); ++v) {
    ASSERT_EQ(a.vessels[v].name, b.vessels[v].prepared.spec.name);
    ASSERT_EQ(a.vessels[v].current.rows(), b.vessels[v].positions.rows());
    EXPECT_LT((a.vessels[v].current - b.vessels[v].positions).rowwise().norm().maxCoeff(),
              tolerance * radius)
        << a.vessels[v].name;
  }
}

struct BothWays {
  Result coarse;
  Prediction closed;
};

BothWays solved_both_ways(const Scene& scene) {
  BothWays both{solved(scene), closed_only(scene)};
  EXPECT_EQ(both.coarse.status, Status::converged) << to_string(both.coarse.status);
  EXPECT_EQ(both.closed.surfaces->solution.status, Status::converged);
  EXPECT_TRUE(both.coarse.certificate.smallest_curvature_positive.value_or(false));
  EXPECT_TRUE(both.coarse.self_intersections.empty());
  return both;
}

int times_noted(const Result& result, const std::string& note) {
  const auto& notes = result.certificate.notes;
  return static_cast<int>(std::count(notes.begin(), notes.end(), note));
}

TEST(CoarseStart, TheMinimumIsThatOfAClosedStart) {
  const Scene scene = t_glenn(around, 4);
  const auto [coarse, closed] = solved_both_ways(scene);
  expect_same(coarse, closed, 1e-6);
  // Both meshes count.
  EXPECT_GT(coarse.counts->outer, closed.work.counts.outer);
}

// The artery's other side rests on a tube that yields, which the coarse walls find out.
TEST(CoarseStart, WhatIsTouchedTakesPartFromTheBeginning) {
  Scene scene = t_glenn(around, 4);
  VesselSpec below = tube("below", 60, {-30, 4, -6.5}, around);
  below.tube->tangent = {1, 0, 0};
  below.tube->normal = {0, 0, 1};
  scene.vessels.push_back(below);
  for (const auto kind : {EndSelector::Kind::start, EndSelector::Kind::end})
    scene.ends.push_back(held("below", kind));
  for (EndCondition& end : scene.ends)
    if (end.vessel == "artery") {
      end.hold = false;
      end.move = Vec3(0, 0, -0.3);
    }
  const auto [coarse, closed] = solved_both_ways(scene);
  double pressure = 0;
  for (const ContactSolution& contact : closed.surfaces->solution.contacts)
    pressure = std::max(pressure, contact.largest_pressure);
  EXPECT_GT(pressure, 0);
  expect_same(coarse, closed, 1e-4);
}

// Its rod says that it has to fold; its walls flatten, and have one minimum.
TEST(CoarseStart, AVeinThatFoldsDoesSoOnCoarseWallsFirst) {
  const Scene scene = t_glenn(around, 12);
  const auto [coarse, closed] = solved_both_ways(scene);
  EXPECT_EQ(times_noted(coarse, found_on_coarse), 1);
  expect_same(coarse, closed, 1e-4);
}

TEST(CoarseStart, FoldsOfCoarseWallsAreKeptWhereTimeEndsBeforeTheFineOnes) {
  bool fine = false;
  SolveOptions options;
  options.fidelity = "coupled";
  options.progress = [&](const std::string& stage) { fine |= stage == "walls: ordering"; };
  options.stop = [&] { return fine; };
  const Result result = predict(t_glenn(around, 12), options);
  ASSERT_TRUE(fine);
  EXPECT_EQ(result.status, Status::interrupted) << to_string(result.status);
  EXPECT_EQ(times_noted(result, found_on_coarse), 1);
}

TEST(CoarseStart, MeshesThatAreCoarseAlreadyAreNotCoarsened) {
  const Scene scene = t_glenn(24, 4);
  const Result coarse = solved(scene);
  const Prediction closed = closed_only(scene);
  EXPECT_EQ(coarse.counts->factorisations, closed.work.counts.factorisations);
  expect_same(coarse, closed, 1e-15);
}

// The picks lie beside the mesh's lines, where rounding could decide how the surgery cuts them.
TEST(CoarseStart, TheUnitDoesNotMatter) {
  Scene mm = t_glenn(around, 4);
  mm.glenn->cut.point += Vec3(0, 0.3, 0.23);
  mm.glenn->incision.point += Vec3(0.37, 0.29, 0);
  Scene m = mm;
  m.units.length = "m";
  m.units.metres = 1;
  for (VesselSpec& vessel : m.vessels) {
    vessel.tube->length *= 1e-3;
    vessel.tube->radius *= 1e-3;
    vessel.tube->position *= 1e-3;
    vessel.wall->thickness *= 1e-3;
    vessel.check = false;
  }
  m.glenn->cut.point = 1e-3 * m.glenn->cut.point;
  m.glenn->incision.point = 1e-3 * m.glenn->incision.point;
  const Result first = solved(mm), second = solved(m);
  EXPECT_EQ(second.status, first.status);
  for (size_t v = 0; v < first.vessels.size(); ++v)
    EXPECT_LT(
        (1e3 * second.vessels[v].current - first.vessels[v].current).rowwise().norm().maxCoeff(),
        1e-6 * radius);
}

}  // namespace
}  // namespace vasorod
