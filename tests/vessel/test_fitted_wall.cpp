#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "program/small_glenn.h"
#include "vessel/fitted_wall.h"

namespace vasorod::testing {
namespace {

// A tapered wall whose outer face is given: radii depend on its thickness.
PreparedVessel fitted(const Scene& scene, const VesselSpec& spec) {
  PreparedVessel vessel = read_vessel(spec, scene);
  fit(vessel);
  return vessel;
}

TEST(FittedWall, AChangedWallIsThatOfANewFit) {
  const Scene scene = read_scene_text(small_glenn("skin"));
  VesselSpec before = scene.vessels[0];
  before.surface_is = SurfaceIs::outer;
  before.tube->end_thickness = 0.5;
  VesselSpec after = before;
  after.wall->thickness *= 1.6;
  *after.tube->end_thickness *= 1.6;
  after.wall->material = Material::isotropic(0.9, 0.3);
  PreparedVessel changed = fitted(scene, before);
  change_wall(changed, after);
  const PreparedVessel expected = fitted(scene, after);
  EXPECT_NEAR(changed.vessel.mean_radius, expected.vessel.mean_radius, 1e-12);
  ASSERT_EQ(changed.node_thickness, expected.node_thickness);
  const RodTree &a = changed.vessel.rod, &b = expected.vessel.rod;
  for (std::size_t k = 0; k < b.radius.size(); ++k) EXPECT_NEAR(a.radius[k], b.radius[k], 1e-12);
  for (std::size_t e = 0; e < b.elements.size(); ++e)
    EXPECT_LT((a.elements[e].stiffness - b.elements[e].stiffness).norm(),
              1e-10 * b.elements[e].stiffness.norm());
  EXPECT_NE(changed.vessel.mean_radius, fitted(scene, before).vessel.mean_radius);
  after.wall->thickness = 50;
  EXPECT_THROW(change_wall(changed, after), InputError);
}

}  // namespace
}  // namespace vasorod::testing
