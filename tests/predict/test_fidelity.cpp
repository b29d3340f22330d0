// A fidelity brought by a program: registered here, found by scenes, results and names.
#include <algorithm>
#include <gtest/gtest.h>

#include <vasorod/read_scene.h>

#include "predict/fidelity.h"
#include "predict/small_scenes.h"
#include "predict/surface_bodies.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

using namespace testing;

const Vec3 offset(0.5, -0.25, 2);

Points shifted_skin(const PredictedVessel& vessel) {
  const Vessel& v = vessel.prepared.vessel;
  return carried_points(v.rod, vessel.rod.poses, v.binding).rowwise() + offset.transpose();
}

// Every vertex goes where its section is carried, and from there by the offset.
void solve_toy(Prediction& prediction, const SolveOptions& options) {
  for (PredictedVessel& vessel : prediction.vessels) {
    if (options.progress) options.progress("toy of " + vessel.prepared.spec.name);
    if (vessel.prepared.obstacle())
      vessel.positions = vessel.prepared.vessel.surface.points;
    else
      vessel.positions = shifted_skin(vessel);
  }
  prediction.left_out["physics"] = "a toy has none";
}

// The same with energies, forces and a status of its own.
void solve_toy_with_forces(Prediction& prediction, const SolveOptions& /*options*/) {
  SolvedSurfaces surfaces;
  SurfaceSolution& solution = surfaces.solution;
  solution.status = Status::equilibrium_only;
  solution.iterations = 3;
  solution.bending_energy = 0.125;
  solution.residual = 1e-4;
  for (const PredictedVessel& vessel : prediction.vessels) {
    BodySolution& body = solution.bodies.emplace_back();
    body.modelled = true;
    body.positions = shifted_skin(vessel);
    body.pressure.setZero(body.positions.rows());
    body.support = Vec3(0, 0, 7);
  }
  surfaces.notes = {"forces by decree"};
  surfaces.terms = {"toying"};
  surfaces.smallest_curvature_positive = true;
  take_surfaces(std::move(surfaces), "toy", prediction);
}

// Registered once per program: the tests of this file share it.
void register_toys() {
  if (find_fidelity("toy")) return;
  register_fidelity({"toy", "sections carried rigidly, and moved on", true, false, solve_toy});
  register_fidelity({"toy_forces", "the same with forces", true, false, solve_toy_with_forces});
}

class ToyFidelity : public ScratchFolder {
 protected:
  ToyFidelity() { register_toys(); }
};

TEST_F(ToyFidelity, IsAmongTheNamesAfterThoseThereAre) {
  const std::vector<std::string> names = fidelity_names();
  ASSERT_EQ(names.size(), fidelities().size());
  const auto toy = std::find(names.begin(), names.end(), "toy");
  ASSERT_NE(toy, names.end());
  EXPECT_GT(toy - names.begin(), 3);
  ASSERT_NE(find_fidelity("toy"), nullptr);
  EXPECT_EQ(find_fidelity("toy")->sentence, "sections carried rigidly, and moved on");
  EXPECT_EQ(find_fidelity("toys"), nullptr);
}

TEST_F(ToyFidelity, ASceneFileThatAsksForItIsSolvedWithIt) {
  const Scene scene = read_scene(write("toy.yaml", R"(scene: toy
units: {length: mm, stress: MPa}
vessels:
  - name: aorta
    tube: {length: 48, radius: 6, around: 24, along: 28}
    wall: {thickness: 0.6, young: 1, poisson: 0.3}
ends:
  - {vessel: aorta, end: start, hold: true}
  - {vessel: aorta, end: end, move: [0, 0, 4.8]}
fidelity: toy
)"));
  std::vector<std::string> told;
  SolveOptions options;
  options.progress = [&](const std::string& line) { told.push_back(line); };
  const Result result = predict(scene, options);
  EXPECT_EQ(result.fidelity, "toy");
  EXPECT_EQ(result.status, Status::converged) << "the rod's";
  EXPECT_EQ(result.model.left_out.at("physics"), "a toy has none");
  EXPECT_NE(std::find(told.begin(), told.end(), "toy of aorta"), told.end());
  const VesselResult& vessel = result.vessels.at(0);
  ASSERT_EQ(vessel.current.rows(), 24 * 29);
  for (Eigen::Index i = 0; i < vessel.rest.rows(); ++i) {
    const Vec3 rest = vessel.rest.row(i),
               expected = Vec3(rest.x(), rest.y(), 1.1 * rest.z()) + offset;
    EXPECT_LT((vessel.current.row(i).transpose() - expected).norm(), 1e-8) << i;
  }
  // Metrics, stages and balance come from what is there.
  ASSERT_EQ(result.metrics.size(), 1u);
  EXPECT_NEAR(result.metrics[0].stretch[1], 1.1, 1e-8);
  EXPECT_NEAR(result.metrics[0].smallest_lumen_ratio, 1, 2e-3);
  ASSERT_FALSE(result.stages.empty());
  EXPECT_EQ(result.stages.back().surfaces.at(0).points, vessel.current);
  EXPECT_EQ(result.balance.size(), 1u);
  EXPECT_EQ(result.environment.inputs.count("toy.yaml"), 1u);
}

TEST_F(ToyFidelity, TheOptionsMayAskForItToo) {
  SolveOptions options;
  options.fidelity = "toy";
  Scene scene = stretched_tube(1e-3, "skin");
  const Result toy = predict(scene, options), skin = predict(scene);
  EXPECT_EQ(toy.fidelity, "toy");
  EXPECT_LT(((toy.vessels[0].current - skin.vessels[0].current).rowwise() - offset.transpose())
                .cwiseAbs()
                .maxCoeff(),
            1e-12);
}

TEST_F(ToyFidelity, ItsEnergiesForcesAndStatusAreTheResults) {
  const Result result = predict(stretched_tube(1e-3, "toy_forces"));
  EXPECT_EQ(result.fidelity, "toy_forces");
  EXPECT_EQ(result.status, Status::equilibrium_only);
  EXPECT_EQ(result.energy.bending, 0.125);
  EXPECT_GT(result.energy.rod, 0);
  EXPECT_EQ(result.iterations.at("surface"), 3);
  EXPECT_EQ(result.certificate.relative_residual, 1e-4);
  EXPECT_EQ(result.certificate.smallest_curvature_positive, true);
  EXPECT_EQ(result.certificate.notes, std::vector<std::string>{"forces by decree"});
  EXPECT_EQ(result.model.terms, (std::vector<std::string>{"rod", "toying"}));
  EXPECT_EQ(result.model.left_out.at("contact"), "no vessel within reach");
  // The rod's two supports pull against each other; what is left is the decree.
  EXPECT_LT((result.balance.at(0).support - Vec3(0, 0, 7)).norm(), 1e-9);
}

TEST_F(ToyFidelity, AMisspeltToyIsMeantToo) {
  EXPECT_EQ(refusal([] { predict(stretched_tube(0, "tyo_forces")); }),
            "scene \"stretched\": fidelity: found \"tyo_forces\", expected \"toy_forces\"");
}

TEST_F(ToyFidelity, WhatCannotBeChosenIsNotWhatAccuracyFallsBackTo) {
  Scene scene = stretched_tube(1e-3, "");
  scene.fidelity.reset();
  scene.accuracy = 0.5;
  EXPECT_EQ(predict(scene).fidelity.find("toy"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
