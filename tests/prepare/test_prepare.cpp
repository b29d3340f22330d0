#include <fstream>

#include <vasorod/error.h>

#include "obj_text.h"
#include "prepare/prepare.h"
#include "prepare/tube_shapes.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

class Prepare : public vasorod::ScratchFolder {
 protected:
  PrepareRequest request(const TriangleSurface& surface) const {
    PrepareRequest out;
    out.files = {write("tube.obj", obj_text(surface))};
    return out;
  }
  static std::string all(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }
};

TEST_F(Prepare, ATubeClosedByFlatLidsLosesThemAndNothingElse) {
  const PreparedSurface out = prepare(request(closed_tube(60, 5, false)));
  EXPECT_NE(all(out.done).find("2 flat lids taken off"), std::string::npos) << all(out.done);
  EXPECT_NE(all(out.done).find("mm is a guess"), std::string::npos) << all(out.done);
  ASSERT_EQ(out.ends.size(), 2u);
  for (const PreparedEnd& end : out.ends) {
    EXPECT_NEAR(end.radius, 5, 0.02);
    EXPECT_NEAR(std::abs(end.center.z() - 30), 30, 1e-6);
    EXPECT_GT(end.normal.z() * (end.center.z() - 30), 29.9);
  }
  EXPECT_LT(out.largest_distance, 1e-9);
  EXPECT_EQ(out.refusal, "");
}

TEST_F(Prepare, RoundEndsAreOpenedAndThePlaceOfOneAloneIsNotEnough) {
  const TriangleSurface tube = closed_tube(60, 5, true);
  const PreparedSurface out = prepare(request(tube));
  EXPECT_EQ(out.ends.size(), 2u);
  EXPECT_EQ(out.refusal, "");
  PrepareRequest one = request(tube);
  one.ends = {Vec3(0, 0, 65)};
  EXPECT_THROW(prepare(one), InputError);  // a vessel has two ends
  one.ends = {Vec3(0, 0, 30)};
  try {
    prepare(one);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no closed end within three radii"), std::string::npos)
        << error.what();
  }
}

TEST_F(Prepare, SpacesAreConvertedAndUnknownOnesAreAskedFor) {
  PrepareRequest ask = request(closed_tube(60, 5, false));
  ask.space = "LPS";
  EXPECT_THROW(prepare(ask), InputError);
  ask.from_space = "RAS";
  TriangleSurface moved = closed_tube(60, 5, false);
  moved.points.rowwise() += Vec3(7, -3, 2).transpose();
  ask.files = {write("moved.obj", obj_text(moved))};
  const PreparedSurface out = prepare(ask);
  EXPECT_EQ(out.space, "LPS");
  for (const PreparedEnd& end : out.ends)
    EXPECT_LT((end.center.head<2>() - Vec2(-7, 3)).norm(), 1e-3);
}

TEST_F(Prepare, ABallIsNoVessel) {
  try {
    prepare(request(closed_tube(1.1, 5, true)));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("end"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace vasorod::testing
