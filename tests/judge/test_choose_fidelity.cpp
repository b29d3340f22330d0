#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "judge/choose_fidelity.h"
#include "judge/judged_tube.h"

namespace vasorod {
namespace {

using shapes::change_of;
using shapes::judged_tube;
using shapes::strained;
using enum LoadKind;

constexpr const char *skin = "skin", *paper = "paper", *coupled = "coupled";

// Two meshes. The error of skin increases with every load, paper is better in bending but has a
// smaller range, coupled has the largest range.
constexpr AccuracyRow table[] = {
    {skin, stretch, 0.1, 0.1, 0.03},    {skin, twist, 0.1, 0.5, 0.001},
    {skin, bend, 0.1, 0.2, 0.01},       {skin, bend, 0.1, 0.4, 0.03},
    {skin, stretch, 0.3, 0.1, 0.04},    {skin, twist, 0.3, 0.5, 0.002},
    {skin, bend, 0.3, 0.4, 0.05},       {paper, stretch, 0.1, 0.1, 0.02},
    {paper, twist, 0.1, 0.5, 0.001},    {paper, bend, 0.1, 0.2, 0.004},
    {coupled, stretch, 0.1, 0.1, 1e-4}, {coupled, twist, 0.1, 0.5, 1e-4},
    {coupled, bend, 0.1, 0.6, 6e-4},
};

Demand demand(double s, double t, double b, double edge = 0.1) {
  return {s, t, b, edge};
}

TEST(PromisedError, InterpolatesBetweenRowsFromZeroAtRest) {
  EXPECT_EQ(*promised_error(table, skin, demand(0, 0, 0)), 0);
  EXPECT_NEAR(*promised_error(table, skin, demand(0, 0, 0.1)), 0.005, 1e-15);
  EXPECT_NEAR(*promised_error(table, skin, demand(0, 0, 0.2)), 0.01, 1e-15);
  EXPECT_NEAR(*promised_error(table, skin, demand(0, 0, 0.3)), 0.02, 1e-15);
  EXPECT_NEAR(*promised_error(table, skin, demand(0.05, 0.25, 0.3)), 0.02 + 0.015 + 0.0005, 1e-15);
}

TEST(PromisedError, EndsWhereTheTableEnds) {
  EXPECT_FALSE(promised_error(table, skin, demand(0, 0, 0.41)));
  EXPECT_FALSE(promised_error(table, skin, demand(0.11, 0, 0)));
  EXPECT_FALSE(promised_error(table, paper, demand(0, 0, 0.3)));
  EXPECT_FALSE(promised_error(table, skin, demand(0, 0, 0.1, 0.31)));
  EXPECT_FALSE(promised_error({}, skin, demand(0, 0, 0)));
}

TEST(PromisedError, TakesTheMeshThatIsNotFinerThanTheScenes) {
  EXPECT_NEAR(*promised_error(table, skin, demand(0, 0, 0.2, 0.2)), 0.025, 1e-15);
  EXPECT_NEAR(*promised_error(table, skin, demand(0, 0, 0.2, 0.05)), 0.01, 1e-15);
}

// R = 10, t = 1: the local wrinkling curvature is 0.605 t / R^2.
class ChooseFidelity : public testing::Test {
 protected:
  PreparedVessel tube = judged_tube();
  RodPoses poses;
  Scene scene;

  FidelityChoice choose(double wanted, double bend, std::span<const AccuracyRow> rows = table,
                        double stretch = 0) {
    poses = strained(tube.vessel.rod, change_of(stretch, Vec3(0, bend * 0.605 / 100, 0)));
    scene.file = "bend.yaml";
    scene.accuracy = wanted;
    scene.vessels.assign(1, tube.spec);
    return choose_fidelity(scene, {{&tube, &poses, {}}}, coupled, rows);
  }
  // for the tube's own mesh, whatever its mean edge is
  std::vector<AccuracyRow> for_its_mesh() {
    std::vector<AccuracyRow> rows(std::begin(table), std::end(table));
    std::erase_if(rows, [](const AccuracyRow& row) { return row.edge > 0.1; });
    for (AccuracyRow& row : rows) row.edge = 0.5;
    return rows;
  }
};

TEST_F(ChooseFidelity, TheCheapestThatWillDo) {
  const auto rows = for_its_mesh();
  const FidelityChoice rough = choose(0.02, 0.2, rows);
  EXPECT_EQ(rough.fidelity, skin);
  EXPECT_NEAR(*rough.promised, 0.01, 1e-6);
  EXPECT_EQ(choose(0.005, 0.2, rows).fidelity, paper);
  EXPECT_EQ(choose(0.001, 0.2, rows).fidelity, coupled);
  EXPECT_EQ(choose(0.01, 0.4, rows).fidelity, coupled);  // beyond the range of paper
  EXPECT_NE(choose(0.02, 0.2, rows).reason.find("bend ratio 0.2"), std::string::npos);
}

TEST_F(ChooseFidelity, MoreThanAnythingPromisesIsRefusedWithTheBestThereIs) {
  const auto rows = for_its_mesh();
  try {
    choose(1e-5, 0.3, rows);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("bend.yaml: accuracy: found 1e-05, expected 0.0003 or more"),
              std::string::npos)
        << what;
  }
}

TEST_F(ChooseFidelity, OutsideOfTheTableTheDearestWithoutAPromise) {
  const auto rows = for_its_mesh();
  const FidelityChoice past = choose(0.02, 0.7, rows);
  EXPECT_EQ(past.fidelity, coupled);
  EXPECT_FALSE(past.promised);
  EXPECT_NE(past.reason.find("does not reach to"), std::string::npos) << past.reason;

  tube.spec.wall->thickness = 4;
  const FidelityChoice thick = choose(0.02, 0.05, rows);
  EXPECT_FALSE(thick.promised);
  EXPECT_NE(thick.reason.find("t/R"), std::string::npos) << thick.reason;
  tube.spec.wall->thickness = 1;

  Material& material = tube.spec.wall->material;
  material.shear_axial /= 100;
  const FidelityChoice soft = choose(0.02, 0.05, rows);
  EXPECT_FALSE(soft.promised);
  EXPECT_NE(soft.reason.find("isotropic"), std::string::npos) << soft.reason;
  material.shear_axial *= 100;

  EXPECT_TRUE(choose(0.05, 0.05, rows, 0.02).promised);
  const FidelityChoice pressed = choose(0.05, 0.05, rows, -0.02);
  EXPECT_FALSE(pressed.promised);
  EXPECT_NE(pressed.reason.find("not pressed"), std::string::npos) << pressed.reason;
  EXPECT_TRUE(choose(0.05, 0.05, rows, -0.001).promised);  // as may remain of a bend along an arc

  scene.glenn.emplace();
  EXPECT_NE(choose(0.02, 0.2, rows).reason.find("not of operations"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
