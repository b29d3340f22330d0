// Scenes through the reference: units, placement, solid and shell compared, loads, refused scenes,
// paths that end early.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "geometry/rigid_motion.h"
#include "reference_fem/solve_scene.h"

namespace vasorod::fem {
namespace {

const char* bend =
    "scene: bend\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - {name: tube, tube: {length: 40, radius: 10}, wall: {thickness: 2, young: 1, poisson: "
    "0.3}}\nends:\n"
    "  - {vessel: tube, end: start, hold: true}\n"
    "  - {vessel: tube, end: end, rotate_deg: [0, 8, 0], move: [2.8, 0, -0.1]}\n";

Scene scene_of(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      (std::string("vasorod_fem_") +
       ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml");
  std::ofstream(file) << text;
  Scene scene = read_scene(file);
  std::filesystem::remove(file);
  return scene;
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

SolveOptions coarse(ModelKind model = ModelKind::solid) {
  SolveOptions options;
  options.model = model;
  options.degree = 3;
  options.refine = 0;
  options.around = 6;
  options.along = 4;
  return options;
}

TEST(SolveScene, MillimetresAndMetresGiveTheSameAnswer) {
  SolveOptions options = coarse();
  options.degree = 2;
  const Result a = solve_scene(scene_of(bend), options);
  std::string metres = with(bend, "length: mm, stress: MPa", "length: m, stress: Pa");
  metres = with(metres, "length: 40, radius: 10", "length: 0.040, radius: 0.010");
  metres = with(metres, "thickness: 2, young: 1,", "thickness: 0.002, young: 1e6,");
  metres = with(metres, "[2.8, 0, -0.1]", "[0.0028, 0, -0.0001]");
  const Result b = solve_scene(scene_of(metres), options);
  ASSERT_EQ(a.status, Status::converged);
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_LT((a.ends[e].force - b.ends[e].force).norm(), 1e-9 * a.ends[e].force.norm());
    EXPECT_LT((a.ends[e].moment - 1e3 * b.ends[e].moment).norm(), 1e-9 * a.ends[e].moment.norm());
  }
  EXPECT_LT((a.vessels[0].current - 1e3 * b.vessels[0].current).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT(a.balance[0].residual, 1e-6);
}

TEST(SolveScene, APlacedTubeIsTheSameTube) {
  SolveOptions options = coarse();
  options.degree = 2;
  const Result a = solve_scene(scene_of(bend), options);
  // the whole scene rotated so that z becomes x, x becomes y, y becomes z, and shifted
  std::string turned =
      with(bend, "radius: 10}",
           "radius: 10, position: [5, -3, 7], tangent: [1, 0, 0], normal: [0, 1, 0]}");
  turned = with(turned, "[0, 8, 0], move: [2.8, 0, -0.1]", "[0, 0, 8], move: [-0.1, 2.8, 0]");
  const Result b = solve_scene(scene_of(turned), options);
  const auto turn = [](const Vec3& v) { return Vec3(v[2], v[0], v[1]); };
  EXPECT_LT((turn(a.ends[1].force) - b.ends[1].force).norm(), 1e-9);
  EXPECT_LT((turn(a.ends[1].moment) - b.ends[1].moment).norm(), 1e-8);
  EXPECT_LT((turn(a.ends[1].center) + Vec3(5, -3, 7) - b.ends[1].center).norm(), 1e-12);
  EXPECT_NEAR(a.metrics[0].flattening, b.metrics[0].flattening, 1e-9);
}

TEST(SolveScene, SolidAndShellAgree) {
  const Scene scene = scene_of(bend);
  const Result solid = solve_scene(scene, coarse()),
               shell = solve_scene(scene, coarse(ModelKind::shell));
  EXPECT_EQ(solid.fidelity, "solid");
  EXPECT_EQ(shell.fidelity, "shell");
  EXPECT_NEAR(shell.ends[1].moment[1] / solid.ends[1].moment[1], 1, 5e-3);
  EXPECT_NEAR(shell.energy.strain / solid.energy.strain, 1, 5e-3);
  EXPECT_LT((shell.vessels[0].current - solid.vessels[0].current).cwiseAbs().maxCoeff(), 0.01 * 10);
}

TEST(SolveScene, TwistIsReportedAsTwist) {
  const Result r =
      solve_scene(scene_of(with(bend, "[0, 8, 0], move: [2.8, 0, -0.1]", "[0, 0, 4]")), coarse());
  const double angle = 4 * 3.14159265358979 / 180;
  EXPECT_NEAR(r.metrics[0].largest_twist_shear, 10 * angle / 40, 1e-4);
  const double J = 12692.0343205028, G = 1 / 2.6;
  EXPECT_NEAR(r.ends[1].moment[2], G * J * angle / 40, 2e-3 * G * J * angle / 40);
  EXPECT_NEAR(r.ends[0].moment[2], -r.ends[1].moment[2], 1e-8);
}

TEST(SolveScene, ErrorEstimateFromTwoMeshesHoldsAgainstAFinerOne) {
  SolveOptions options = coarse(ModelKind::shell);
  options.refine = 1;
  const Scene scene = scene_of(bend);
  const Result two = solve_scene(scene, options);
  ASSERT_TRUE(two.discretisation->error_estimate);
  EXPECT_FALSE(two.discretisation->observed_order);
  options.refine = 0;
  options.around = 14;
  options.along = 10;
  const Result fine = solve_scene(scene, options);
  EXPECT_LT(std::abs(two.energy.strain / fine.energy.strain - 1),
            *two.discretisation->error_estimate);
  EXPECT_LT(std::abs(two.ends[1].moment[1] / fine.ends[1].moment[1] - 1),
            *two.discretisation->error_estimate);
}

TEST(SolveScene, PressureWidensTheTube) {
  // soft ends that can slide: Lame's open tube, u(r = 10) at p = 1e-3 times a small factor
  const std::string text =
      "scene: lame\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - {name: tube, tube: {length: 40, radius: 10}, wall: {thickness: 2, young: 1, poisson: "
      "0.3}, "
      "pressure: {after: 1e-6}}\nends:\n"
      "  - {vessel: tube, end: start, hold: true, section: soft}\n";
  // the shell with t / R = 0.2 has a linear strain through the thickness, Lame's solution has not
  for (const auto& [model, bound] :
       {std::pair{ModelKind::solid, 2e-3}, std::pair{ModelKind::shell, 5e-3}}) {
    const Result r = solve_scene(scene_of(text), coarse(model));
    EXPECT_EQ(r.status, Status::equilibrium_only);
    const auto& v = r.vessels[0];
    const Eigen::Index middle = v.rest.rows() / 2 / 96 * 96;
    const Vec3 rest = v.rest.row(middle), u = v.current.row(middle) - v.rest.row(middle);
    EXPECT_NEAR(u.head<2>().dot(rest.head<2>().normalized()) / 4.602825e-5, 1, bound) << r.fidelity;
  }
}

// Inflated by a third of its modulus times t / R and bent: solid and shell under the same follower
// pressure.
TEST(SolveScene, SolidAndShellAgreeUnderPressure) {
  const Scene scene =
      scene_of(with(with(with(bend, "thickness: 2", "thickness: 0.5"), "poisson: 0.3}",
                         "poisson: 0.3}, pressure: {after: 0.004}"),
                    "radius: 10}", "radius: 10}"));
  const Result solid = solve_scene(scene, coarse()),
               shell = solve_scene(scene, coarse(ModelKind::shell));
  EXPECT_LT((shell.vessels[0].current - solid.vessels[0].current).cwiseAbs().maxCoeff(),
            0.002 * 10);
  EXPECT_NEAR(shell.ends[1].moment[1] / solid.ends[1].moment[1], 1, 0.01);
  EXPECT_NEAR(shell.ends[1].force[2] / solid.ends[1].force[2], 1, 0.01);
  EXPECT_GT((solid.vessels[0].current - solid.vessels[0].rest).cwiseAbs().maxCoeff(), 0.5);
}

// A tube seen at 5 and taken to 12 mmHg and bent, in other units and places, and by both models.
TEST(SolveScene, ATubeSeenUnderPressure) {
  const std::string seen =
      with(with(bend, "thickness: 2", "thickness: 0.5"), "poisson: 0.3}",
           "poisson: 0.3}, pressure: {scan: 0.002, after: 0.004}, axial_prestretch: 1.04");
  const Result solid = solve_scene(scene_of(seen), coarse()),
               shell = solve_scene(scene_of(seen), coarse(ModelKind::shell));
  EXPECT_LT((shell.vessels[0].current - solid.vessels[0].current).cwiseAbs().maxCoeff(),
            0.002 * 10);
  EXPECT_NEAR(shell.ends[1].moment[1] / solid.ends[1].moment[1], 1, 0.01);
  EXPECT_NEAR(shell.ends[1].force[2] / solid.ends[1].force[2], 1, 0.01);
  EXPECT_NEAR(shell.energy.strain / solid.energy.strain, 1, 0.01);
  std::string metres = with(seen, "length: mm, stress: MPa", "length: m, stress: Pa");
  metres = with(metres, "length: 40, radius: 10", "length: 0.040, radius: 0.010");
  metres = with(metres, "thickness: 0.5, young: 1,", "thickness: 0.0005, young: 1e6,");
  metres = with(metres, "scan: 0.002, after: 0.004", "scan: 2e3, after: 4e3");
  metres = with(metres, "[2.8, 0, -0.1]", "[0.0028, 0, -0.0001]");
  const Result same = solve_scene(scene_of(metres), coarse(ModelKind::shell));
  EXPECT_LT((shell.vessels[0].current - 1e3 * same.vessels[0].current).cwiseAbs().maxCoeff(), 1e-7);
  // A note names a first step that is rough.
  const Result far = solve_scene(
      scene_of(with(with(seen, "scan: 0.002", "scan: 0.008"), "after: 0.004", "after: 0.008")),
      coarse(ModelKind::shell));
  const auto named = [](const Result& result) {
    return std::any_of(result.certificate.notes.begin(), result.certificate.notes.end(),
                       [](const std::string& note) { return note.find("prestress of tube") == 0; });
  };
  EXPECT_FALSE(named(shell));
  EXPECT_TRUE(named(far));
}

TEST(SolveScene, RefusesWhatItCannotDo) {
  const auto refused = [](const std::string& text, const std::string& part,
                          const SolveOptions& options = coarse()) {
    try {
      solve_scene(scene_of(text), options);
      ADD_FAILURE() << "accepted: " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused(with(bend, "ends:\n",
               "  - {name: other, tube: {length: 40, radius: 10, position: [50, 0, 0]}, wall: "
               "{thickness: 2, "
               "young: 1, "
               "poisson: 0.3}}\nends:\n"),
          "found 2 vessels");
  SolveOptions degree = coarse();
  degree.degree = 7;
  refused(bend, "--degree", degree);
  refused(
      "scene: x\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
      "  - {name: tube, tube: {length: 40, radius: 10}, wall: {thickness: 2, young: 1, poisson: "
      "0.3}}\nends:\n"
      "  - {vessel: tube, end: start, fix: [x, y, z]}\n",
      "found 3 components held");
  refused(with(bend, "poisson: 0.3}", "poisson: 0.3}, pressure: {after: 0.2}"),
          "tube: pressure.after: found 0.2 MPa, which would stretch the wall by 90 %, expected at "
          "most 0.1111 MPa");
  SolveOptions law = coarse();
  law.law = LawKind::neo_hookean;
  refused(with(bend, "young: 1, poisson: 0.3", "young: 1, shear: 0.4, transverse: {poisson: 0.3}"),
          "isotropic here", law);
}

TEST(SolveScene, APathThatEndsSaysWhere) {
  SolveOptions options = coarse();
  options.degree = 1;
  options.law = LawKind::svk;
  options.stepper.arc_steps = 4;
  const Result r = solve_scene(
      scene_of(with(bend, "rotate_deg: [0, 8, 0], move: [2.8, 0, -0.1]", "move: [0, 0, -39.5]")),
      options);
  EXPECT_EQ(r.status, Status::iteration_limit);
  EXPECT_GT(r.ends[1].center[2], 0.5);
  EXPECT_LT(r.ends[1].center[2], 40);
  bool says = false;
  for (const std::string& note : r.certificate.notes)
    says = says || note.find("the path ended at") != std::string::npos;
  EXPECT_TRUE(says);
}

}  // namespace
}  // namespace vasorod::fem
