#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "explore/small_exploration.h"
#include "explore/uncertain_scene.h"

namespace vasorod::testing {
namespace {

using What = Uncertain::What;

Uncertain uniform(What what, double low, double high, const std::string& vessel = "") {
  return {what, vessel, low, high, 0};
}

Uncertain normal(What what, double sd) {
  return {what, "", 0, 0, sd};
}

TEST(UncertainScene, ValuesAreThoseOfTheDistribution) {
  const Uncertain factor = uniform(What::young, 0.5, 1.5);
  EXPECT_DOUBLE_EQ(value_at(factor, 0), 0.5);
  EXPECT_DOUBLE_EQ(value_at(factor, 0.25), 0.75);
  // The normal distribution's function, by the error function of the C library.
  for (const Uncertain& one : {normal(What::thickness, 0.1), normal(What::cut, 2)})
    for (const double deviations : {-2.5, -1.0, 0.0, 0.3, 3.0}) {
      const double share = 0.5 * std::erfc(-deviations / std::sqrt(2.));
      EXPECT_NEAR(value_at(one, share), (one.scales() ? 1 : 0) + one.sd * deviations,
                  1e-9 * one.sd);
    }
  EXPECT_DOUBLE_EQ(value_at(normal(What::thickness, 0.2), 0), 1 - 4 * 0.2);
  EXPECT_DOUBLE_EQ(value_at(normal(What::cut, 1), 1 - 1e-12), 4);
}

TEST(UncertainScene, SamplesAreNamedByTheirValues) {
  VarySpec spec;
  spec.uncertain = {uniform(What::young, 1, 2, "svc"), uniform(What::cut, -1, 1)};
  spec.samples = 3;
  const auto samples = samples_of(spec);
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].text.rfind("young svc 1.", 0), 0U) << samples[0].text;
  EXPECT_NE(samples[0].text.find(", cut "), std::string::npos) << samples[0].text;
  EXPECT_NE(samples[0].text, samples[1].text);
}

TEST(UncertainScene, WallsAndPressuresAreScaled) {
  Scene scene = small_exploration("rotation_deg: 0");
  scene.vessels[0].pressure = LumenPressure{0.01, 0.02};
  VarySpec spec;
  spec.uncertain = {uniform(What::young, 1, 2, "svc"), uniform(What::thickness, 1, 2),
                    uniform(What::poisson, 0.5, 1, "rpa"), uniform(What::pressure, 0.5, 2)};
  const Scene changed = with_sampled_walls(scene, spec, {{2, 1.5, 0.8, 0.5}, ""});
  const Wall &svc = *scene.vessels[0].wall, &rpa = *scene.vessels[1].wall;
  EXPECT_DOUBLE_EQ(changed.vessels[0].wall->material.young_axial, 2 * svc.material.young_axial);
  EXPECT_DOUBLE_EQ(changed.vessels[0].wall->material.shear_axial, 2 * svc.material.shear_axial);
  EXPECT_DOUBLE_EQ(changed.vessels[1].wall->material.young_axial, rpa.material.young_axial);
  EXPECT_DOUBLE_EQ(changed.vessels[0].wall->thickness, 1.5 * svc.thickness);
  EXPECT_DOUBLE_EQ(changed.vessels[1].wall->thickness, 1.5 * rpa.thickness);
  EXPECT_DOUBLE_EQ(changed.vessels[1].wall->material.poisson_tt, 0.8 * rpa.material.poisson_tt);
  EXPECT_TRUE(changed.vessels[1].wall->material.is_isotropic());
  EXPECT_DOUBLE_EQ(changed.vessels[0].pressure->scan, 0.005);
  EXPECT_DOUBLE_EQ(changed.vessels[0].pressure->after, 0.01);
  spec.uncertain = {uniform(What::poisson, 0.5, 2)};
  EXPECT_THROW(with_sampled_walls(scene, spec, {{1.5}, "poisson 1.5"}), InputError);
}

// A straight vein from z = 5 to 45, kept at its upper end, and an artery along x of length 50: an
// offset is a length along the axis.
TEST(UncertainScene, PicksMoveAlongTheAxes) {
  const Scene scene = small_exploration("rotation_deg: 0");
  const FittedVessels fitted = fit_vessels(scene);
  VarySpec spec;
  spec.uncertain = {uniform(What::cut, -5, 5), uniform(What::incision, -5, 5)};
  const auto still = with_sample(scene, spec, {{0, 0}, ""}, fitted),
             moved = with_sample(scene, spec, {{2, -3}, ""}, fitted);
  double vein = 0, artery = 0;
  for (const RodElement& element : fitted.vessels[0].vessel.rod.elements) vein += element.length;
  for (const RodElement& element : fitted.vessels[1].vessel.rod.elements) artery += element.length;
  EXPECT_NEAR(*moved.glenn->cut.along - *still.glenn->cut.along, 2 / vein, 1e-12);
  EXPECT_NEAR(*moved.glenn->incision.along - *still.glenn->incision.along, -3 / artery, 1e-12);
  EXPECT_EQ(moved.glenn->incision.around_deg, still.glenn->incision.around_deg);
  EXPECT_THROW(with_sample(scene, spec, {{60, 0}, ""}, fitted), InputError);
}

}  // namespace
}  // namespace vasorod::testing
