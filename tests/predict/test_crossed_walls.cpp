// A Glenn shunt whose walls pass through each other beside the seam in the minimum that contact
// away from the seam leaves.
#include <algorithm>
#include <gtest/gtest.h>

#include "predict/t_glenn.h"

namespace vasorod {
namespace {

using namespace testing;

// A tilted and turned vein on a slit that is not on its axis. No length of a round number, so that
// no edit meets a line of the mesh.
Scene crossing() {
  Scene scene = t_glenn(36, 2);
  VesselSpec &vein = scene.vessels[0], &artery = scene.vessels[1];
  vein.tube->length = 60;
  vein.tube->radius = 3.3;
  vein.tube->along = 60;
  vein.wall = Wall{0.4, Material::isotropic(0.5, 0.45)};
  artery.tube->length = 44;
  artery.tube->radius = 3.5;
  artery.tube->around = 40;
  artery.tube->along = 84;
  artery.tube->position = Vec3(-22, 0, 30.8);
  artery.wall = Wall{0.45, Material::isotropic(0.45, 0.45)};
  for (VesselSpec& vessel : scene.vessels) vessel.surface_is = SurfaceIs::outer;
  scene.ends.erase(scene.ends.begin() + 1);
  GlennSpec& spec = *scene.glenn;
  spec.cut.point = Vec3(3.3, 0, 27.3);
  spec.incision.point = Vec3(0, 2, 27.3);
  spec.rotation_deg = 60;
  spec.cut_tilt_deg = 20;
  spec.keep.kind = EndSelector::Kind::start;
  return scene;
}

TEST(CrossedWalls, ArePartedBesideTheSeam) {
  SolveOptions options;
  options.fidelity = "coupled";
  Scene scene = crossing();
  const Result parted = predict(scene, options);
  EXPECT_EQ(parted.status, Status::converged) << to_string(parted.status);
  EXPECT_TRUE(parted.self_intersections.empty());
  EXPECT_TRUE(parted.certificate.smallest_curvature_positive.value_or(false));
  for (const Balance& vessel : parted.balance) EXPECT_LT(vessel.residual, 1e-6);

  // Where nothing is to touch anything, the crossing stays and is said.
  scene.contact.emplace();
  const Result crossed = predict(scene, options);
  EXPECT_EQ(crossed.status, Status::self_intersecting) << to_string(crossed.status);
  EXPECT_FALSE(crossed.self_intersections.empty());
}

TEST(CrossedWalls, StayWhereTimeEndsBeforeTheyArePartedAndTheResultSaysSo) {
  SolveOptions options;
  options.fidelity = "coupled";
  // The unknowns are ordered a second time where the walls are parted.
  int ordered = 0;
  bool parting = false, stopped = false;
  options.progress = [&](const std::string& stage) {
    if (stage == "walls: ordering") parting = ++ordered > 1;
  };
  options.stop = [&] {
    stopped |= parting;
    return parting;
  };
  const Result result = predict(crossing(), options);
  ASSERT_TRUE(stopped);
  EXPECT_EQ(result.status, Status::self_intersecting) << to_string(result.status);
  const auto& notes = result.certificate.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.rfind("the search for a better state was stopped by the caller at \"walls", 0) == 0;
  }));
}

}  // namespace
}  // namespace vasorod
