// predict() called from C++ on scenes that were never files.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include <vasorod/read_scene.h>

#include "obj_text.h"
#include "predict/fitted_vessels.h"
#include "predict/small_scenes.h"
#include "program/small_glenn.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

using namespace testing;
using Kind = EndSelector::Kind;

const EndReaction& end_of(const Result& result, const std::string& name) {
  for (const EndReaction& end : result.ends)
    if (end.end == name) return end;
  throw std::runtime_error("no end " + name);
}

TEST(Predict, ARodBentByAMomentIsAnArc) {
  // A quarter circle: M = EI (pi/2) / L.
  const double length = 20, moment = 50 * std::numbers::pi / 2 / length;
  const Result result = predict(bent_cantilever(length, moment));
  EXPECT_LE(result.status, Status::equilibrium_only) << to_string(result.status);
  EXPECT_EQ(result.fidelity, "rod");
  EXPECT_EQ(result.scene, "cantilever");
  const CenterlineResult& line = *result.vessels.at(0).centerline;
  const double radius = 50 / moment;
  for (Eigen::Index i = 0; i < line.current.rows(); ++i) {
    const double angle = line.abscissa[static_cast<size_t>(i)] / radius;
    const Vec3 arc(radius * std::sin(angle), radius * (1 - std::cos(angle)), 0);
    EXPECT_LT((line.current.row(i).transpose() - arc).norm(), 1e-9 * length) << i;
  }
  EXPECT_NEAR(result.energy.rod, moment * moment * length / (2 * 50), 1e-9);
  EXPECT_NEAR(result.metrics.at(0).largest_curvature, 1 / radius, 1e-10);
  EXPECT_LT((end_of(result, "start").moment - Vec3(0, 0, -moment)).norm(), 1e-9 * moment);
  EXPECT_LT(end_of(result, "start").force.norm(), 1e-9);
}

// What every prediction of a stretched tube says, whatever the fidelity.
void expect_stretched(const Result& result, const std::string& fidelity, double strain) {
  EXPECT_EQ(result.status, Status::converged) << fidelity << ": " << to_string(result.status);
  EXPECT_EQ(result.fidelity, fidelity);
  ASSERT_EQ(result.vessels.size(), 1u);
  ASSERT_EQ(result.balance.size(), 1u);
  EXPECT_LT(result.balance[0].residual, 1e-6) << fidelity;
  ASSERT_EQ(result.ends.size(), 2u);
  const Vec3 pull = end_of(result, "end").force;
  EXPECT_LT((end_of(result, "start").force + pull).norm(), 1e-6 * pull.norm()) << fidelity;
  EXPECT_NEAR(end_of(result, "end").center.z(), 48 * (1 + strain), 1e-6);
  // E A strain, A that of the wall: 24 plane strips.
  const double area = 24 * 2 * 6 * std::sin(std::numbers::pi / 24) * 0.6;
  EXPECT_NEAR(pull.z(), area * strain, 0.01 * area * strain) << fidelity;
  EXPECT_LT(std::hypot(pull.x(), pull.y()), 1e-6 * pull.z()) << fidelity;
}

TEST(Predict, AStretchedTubePullsWithEATimesStrainAtEveryFidelity) {
  const double strain = 1e-3;
  for (const std::string fidelity : {"skin", "paper", "coupled"}) {
    const Result result = predict(stretched_tube(strain, fidelity));
    expect_stretched(result, fidelity, strain);
    const VesselResult& vessel = result.vessels[0];
    ASSERT_EQ(vessel.current.rows(), vessel.rest.rows());
    EXPECT_TRUE(vessel.current.allFinite());
    if (fidelity != "paper") {  // whose springs leave a soft end's rim where they will
      for (Eigen::Index i = 0; i < vessel.rest.rows(); ++i)
        EXPECT_NEAR(vessel.current(i, 2), vessel.rest(i, 2) * (1 + strain), 0.02 * 48 * strain)
            << fidelity;
    }
    EXPECT_TRUE(result.validity.in_range);
  }
}

TEST(Predict, TheCoupledWallContractsByPoissonsRatioAndTheSkinDoesNot) {
  const double strain = 1e-3;
  const auto contraction = [&](const std::string& fidelity) {
    const VesselResult vessel = predict(stretched_tube(strain, fidelity)).vessels.at(0);
    // the middle row
    double change = 0;
    int counted = 0;
    for (Eigen::Index i = 0; i < vessel.rest.rows(); ++i)
      if (std::abs(vessel.rest(i, 2) - 24) < 3) {
        change += 1 - vessel.current.row(i).head<2>().norm() / vessel.rest.row(i).head<2>().norm();
        ++counted;
      }
    return change / counted;
  };
  EXPECT_NEAR(contraction("skin"), 0, 1e-9);
  EXPECT_NEAR(contraction("coupled"), 0.3 * strain, 0.02 * 0.3 * strain);
}

TEST(Predict, TheOptionsFidelityOverridesTheScenes) {
  SolveOptions options;
  options.fidelity = "skin";
  const Result result = predict(stretched_tube(1e-3, "coupled"), options);
  EXPECT_EQ(result.fidelity, "skin");
  EXPECT_EQ(result.iterations.at("surface"), 0);
}

TEST(Predict, ASurfaceAtFidelityRodIsItsCenterlineAlone) {
  const Result result = predict(stretched_tube(1e-3, "rod"));
  expect_stretched(result, "rod", 1e-3);
  EXPECT_EQ(result.vessels[0].current.rows(), 0);
  EXPECT_EQ(result.model.left_out.count("surface"), 1u);
}

TEST(Predict, ATubeThatNothingMovesStaysExactlyAsItIs) {
  for (const std::string fidelity : {"skin", "paper", "coupled"}) {
    Scene scene = stretched_tube(0, fidelity);
    scene.ends.pop_back();
    const Result result = predict(scene);
    EXPECT_EQ(result.status, Status::converged) << fidelity;
    EXPECT_EQ(result.vessels[0].current, result.vessels[0].rest) << fidelity;
    EXPECT_EQ(result.model.left_out.count("rod of aorta"), 1u) << fidelity;
  }
}

TEST(Predict, StoppedItReturnsTheBestStateByName) {
  for (const std::string fidelity : {"rod", "paper", "coupled"}) {
    SolveOptions options;
    int asked = 0;
    options.stop = [&] { return ++asked > 1; };
    Scene scene = stretched_tube(1e-3, fidelity);
    scene.ends[1].move = Vec3(10, 0, -4);
    const Result result = predict(scene, options);
    EXPECT_EQ(result.status, Status::interrupted) << fidelity << ": " << to_string(result.status);
    EXPECT_GT(asked, 1) << fidelity;
    EXPECT_EQ(result.certificate.notes.back().rfind("stopped by the caller at ", 0), 0U)
        << fidelity;
    EXPECT_TRUE(result.vessels.at(0).current.allFinite());
    EXPECT_TRUE(result.vessels.at(0).centerline->current.allFinite());
  }
}

TEST(Predict, ProgressIsTold) {
  std::vector<std::string> told;
  SolveOptions options;
  options.progress = [&](const std::string& line) { told.push_back(line); };
  predict(stretched_tube(1e-3, "paper"), options);
  const auto has = [&](const std::string& text) {
    return std::any_of(told.begin(), told.end(), [&](const std::string& line) {
      return line.find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(has("vessel aorta"));
  EXPECT_TRUE(has("rod of aorta"));
  EXPECT_TRUE(has("converged: residual ")) << "the solver's brief report";
  for (const std::string& line : told) EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

TEST(Predict, TwoRunsAreTheSame) {
  const Result one = predict(stretched_tube(1e-3, "paper"));
  const Result two = predict(stretched_tube(1e-3, "paper"));
  EXPECT_EQ(one.vessels[0].current, two.vessels[0].current);
  EXPECT_EQ(one.energy.total(), two.energy.total());
  EXPECT_EQ(one.iterations, two.iterations);
}

TEST(Predict, AnUnknownFidelityIsRefusedWithTheNearestName) {
  SolveOptions options;
  options.fidelity = "copled";
  EXPECT_EQ(refusal([&] { predict(stretched_tube(0, "skin"), options); }),
            "fidelity: found \"copled\", expected \"coupled\"");
  const std::string far = refusal([] { predict(stretched_tube(0, "finite-elements")); });
  EXPECT_EQ(far.rfind("scene \"stretched\": fidelity: found \"finite-elements\", expected rod, "
                      "skin, paper, section",
                      0),
            0u)
      << far;
  // With a file the sentence begins with its place.
  Scene scene = stretched_tube(0, "papre");
  scene.file = "tube.yaml";
  scene.fidelity_line = 12;
  EXPECT_EQ(refusal([&] { predict(scene); }),
            "tube.yaml:12: fidelity: found \"papre\", expected \"paper\"");
}

TEST(Predict, NoThreadsAreRefused) {
  for (const int threads : {0, -1}) {
    SolveOptions options;
    options.threads = threads;
    EXPECT_EQ(refusal([&] { predict(stretched_tube(0, "skin"), options); }),
              "threads: found " + std::to_string(threads) + ", expected at least 1");
  }
  EXPECT_FALSE(SolveOptions{}.is_invalid());
}

// What the reader of scene files would have refused is refused here too.
TEST(Predict, ScenesThatCannotBeSolvedAreRefusedWithTheVessel) {
  Scene scene = stretched_tube(1e-3, "paper");
  scene.vessels[0].pressure = LumenPressure{0, 0.01};
  EXPECT_NE(
      refusal([&] { predict(scene); })
          .find("vessel aorta: found a pressure at fidelity paper, expected fidelity rod, skin, "
                "section or coupled, whose rods or walls"),
      std::string::npos);

  scene = stretched_tube(1e-3, "paper");
  scene.vessels[0].axial_prestretch = 1.1;
  EXPECT_NE(refusal([&] {
              predict(scene);
            }).find("vessel aorta: found an axial prestretch at fidelity paper"),
            std::string::npos);

  scene = bent_cantilever(10, 1);
  scene.vessels[0].axial_prestretch = 1.1;
  EXPECT_NE(refusal([&] {
              predict(scene);
            }).find("vessel beam: found an axial prestretch on a bare rod, expected a vessel with"),
            std::string::npos);

  scene = stretched_tube(1e-3, "skin");
  scene.vessels[0].wall.reset();
  EXPECT_EQ(
      refusal([&] { predict(scene); }),
      "scene \"stretched\": vessel aorta: found no wall, expected its thickness and material");

  scene = stretched_tube(1e-3, "skin");
  scene.vessels[0].tube.reset();
  EXPECT_EQ(refusal([&] { predict(scene); }),
            "scene \"stretched\": vessel aorta: found no shape, expected a surface, a tube or a "
            "bare rod");

  scene = stretched_tube(1e-3, "skin");
  scene.ends[1].vessel = "vena";
  EXPECT_NE(refusal([&] { predict(scene); }).find("found no vessel \"vena\""), std::string::npos);

  scene = stretched_tube(1e-3, "skin");
  EndToEndSpec& join = scene.end_to_end.emplace();
  join.rims[0].vessel = join.rims[1].vessel = "aorta";
  EXPECT_EQ(refusal([&] { predict(scene); }),
            "scene \"stretched\": surgery: found the vessel \"aorta\" twice, expected two "
            "different vessels");
  join.rims[1].vessel = "heart";
  scene.vessels.push_back(scene.vessels[0]);
  scene.vessels[1].name = "heart";
  scene.vessels[1].role = Role::obstacle;
  EXPECT_NE(
      refusal([&] {
        predict(scene);
      }).find("vessel heart: found an obstacle that the surgery joins, expected a deformable"),
      std::string::npos);
  scene.glenn.emplace();
  EXPECT_NE(refusal([&] { predict(scene); }).find("end_to_end: found it beside glenn"),
            std::string::npos);

  scene = bent_cantilever(20, 1);
  scene.fidelity = "paper";
  EXPECT_EQ(refusal([&] { predict(scene); }),
            "scene \"cantilever\": vessel beam: found a bare rod at fidelity paper, expected "
            "fidelity rod");
}

class Spaces : public ScratchFolder {
 protected:
  // Two tubes side by side as OBJ, with the comment that 3D Slicer writes.
  Scene scene(const std::vector<std::string>& comments) const {
    Scene scene = stretched_tube(0, "skin");
    scene.vessels.clear();
    for (std::size_t k = 0; k < comments.size(); ++k) {
      VesselSpec vessel = tube("v" + std::to_string(k));
      TriangleSurface surface = tube_surface(*vessel.tube);
      surface.points.col(0).array() += 40.0 * static_cast<double>(k);
      const std::string text = "# 3D Slicer output. " + comments[k] + '\n' + obj_text(surface);
      vessel.tube.reset();
      vessel.surface = write(vessel.name + ".obj", text);
      scene.vessels.push_back(vessel);
    }
    scene.ends = {held("v0", EndSelector::Kind::start)};
    return scene;
  }
};

TEST_F(Spaces, StayWithTheirVessels) {
  const Result result = predict(scene({"SPACE=LPS", ""}));
  EXPECT_EQ(result.vessels.at(0).space, "LPS");
  EXPECT_EQ(result.vessels.at(1).space, "");
}

TEST_F(Spaces, ThatDisagreeAreRefused) {
  const std::string said = refusal([&] { predict(scene({"SPACE=LPS", "SPACE=RAS"})); });
  EXPECT_NE(said.find("vessel v1: found a surface in the space RAS"), std::string::npos) << said;
  EXPECT_NE(said.find("v0 is in LPS, expected"), std::string::npos) << said;
}

TEST(Predict, NoVesselIsDroppedBesideABareRod) {
  Scene scene = bent_cantilever(20, 1);
  scene.vessels.push_back(tube("aorta"));
  EXPECT_EQ(refusal([&] { predict(scene); }),
            "scene \"cantilever\": vessel aorta: found a surface beside bare rods, expected bare "
            "rods alone");
}

TEST(Predict, FidelityNamesGoFromCheapToExpensive) {
  const std::vector<std::string> names = fidelity_names();
  ASSERT_GE(names.size(), 5u);
  EXPECT_EQ((std::vector<std::string>{names.begin(), names.begin() + 5}),
            (std::vector<std::string>{"rod", "skin", "paper", "section", "coupled"}));
}

// Scenes that differ in their operation share their vessels, whichever of them comes first.
TEST(Predict, VesselsFittedBeforeGiveTheSameResult) {
  const Scene scene = read_scene_text(small_glenn("skin"));
  const FittedVessels fitted = fit_vessels(scene);
  const auto numbers = [](Result result) {
    result.seconds.clear();
    return to_json(result);
  };
  for (const char* fidelity : {"rod", "skin", "paper"})
    for (const double rotation : {0.0, 40.0}) {
      Scene turned = scene;
      turned.glenn->rotation_deg = rotation;
      SolveOptions options;
      options.fidelity = fidelity;
      EXPECT_EQ(numbers(predict(turned, options, fitted)), numbers(predict(turned, options)))
          << fidelity << ' ' << rotation;
    }
}

}  // namespace
}  // namespace vasorod
