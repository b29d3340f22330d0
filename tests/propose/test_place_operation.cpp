// A vein above an artery at a right angle: where the operation belongs is plain.
#include <gtest/gtest.h>

#include "propose/place_operation.h"

namespace vasorod {
namespace {

VesselSpec tube(const std::string& name, double length, double radius, const Vec3& position,
                const Vec3& tangent) {
  VesselSpec spec;
  spec.name = name;
  spec.tube.emplace();
  spec.tube->length = length;
  spec.tube->radius = radius;
  spec.tube->around = 28;
  spec.tube->along = static_cast<int>(1.2 * length);
  spec.tube->position = position;
  spec.tube->tangent = tangent;
  spec.tube->normal = Vec3::UnitY();
  spec.surface_is = SurfaceIs::mid;
  spec.wall = Wall{0.4, Material::isotropic(0.5, 0.45)};
  return spec;
}

// The vein from z = 5 to 45, the artery of that length along x through the origin.
struct Vessels {
  Scene scene;
  PreparedVessel vein, artery;

  explicit Vessels(double length) {
    scene.vessels = {tube("svc", 40, 3.3, {0, 0, 5}, Vec3::UnitZ()),
                     tube("pa", length, 4, {-length / 2, 0, 0}, Vec3::UnitX())};
    vein = read_vessel(scene.vessels[0], scene);
    artery = read_vessel(scene.vessels[1], scene);
    fit(vein);
    fit(artery);
  }
};

TEST(PlaceOperation, TheHeadsEndIsTheHigherOneOrTheOneFartherFromTheArtery) {
  Vessels vessels(50);
  EXPECT_EQ(head_end(vessels.vein.vessel, vessels.artery.vessel, ""), 1);
  EXPECT_EQ(head_end(vessels.vein.vessel, vessels.artery.vessel, "LPS"), 1);
  for (VesselEnd& end : vessels.artery.vessel.ends) end.center.z() += 60;
  EXPECT_EQ(head_end(vessels.vein.vessel, vessels.artery.vessel, ""), 0);
  EXPECT_EQ(head_end(vessels.vein.vessel, vessels.artery.vessel, "RAS"), 1);
}

TEST(PlaceOperation, TheVeinComesDownOnTheSideOfTheArteryThatFacesIt) {
  const Vessels vessels(50);
  const auto placed = place_operation(vessels.scene, vessels.vein, vessels.artery, 1);
  ASSERT_TRUE(placed);
  const Vec3 pick = placed->report.incision.pick;
  EXPECT_LT(std::hypot(pick.x(), pick.y()), 2.0);
  EXPECT_GT(pick.z(), 3.5);
  EXPECT_LT(placed->report.join.axis_turn_deg, 20);
  // The kept part is as long as the way from the kept end to the pick.
  EXPECT_NEAR(*placed->spec.cut.along * 40, std::min(45 - pick.z(), 36.0), 0.1);
  EXPECT_FALSE(placed->spec.incision.to);  // the artery has two ends
}

TEST(PlaceOperation, TheScenesRoundedPicksAreTheOnesThatWereTried) {
  const Vessels vessels(50);
  const auto placed = place_operation(vessels.scene, vessels.vein, vessels.artery, 1);
  ASSERT_TRUE(placed);
  PreparedVessel svc = vessels.vein, rpa = vessels.artery;
  VesselConditions conditions = end_conditions(vessels.scene, "svc", svc.vessel);
  const Operation again = operate(vessels.scene, placed->spec, svc, rpa, conditions);
  EXPECT_EQ(again.glenn->incision.pick, placed->report.incision.pick);
  EXPECT_EQ(*placed->spec.cut.along, std::round(1000 * *placed->spec.cut.along) / 1000);
}

// The slit is 10.4 mm long.
TEST(PlaceOperation, OnAnArteryThatIsTooShortThereIsNone) {
  const Vessels vessels(9);
  EXPECT_FALSE(place_operation(vessels.scene, vessels.vein, vessels.artery, 1));
}

}  // namespace
}  // namespace vasorod
