#include <cmath>
#include <sstream>

#include <vasorod/error.h>

#include "geometry/ray_hits.h"
#include "infant_anatomy.h"
#include "obj_text.h"
#include "prepare/prepare.h"
#include "prepare/tube_shapes.h"
#include "real_anatomy.h"
#include "scratch_folder.h"
#include "surface_file/read_polydata.h"
#include "vessel/vessel.h"

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

// The fork of the bundled pulmonary artery with 2 to 4 mm of its branches: from two of its ends
// `fit` follows it, from the one that is first here it does not.
TEST_F(Prepare, TheEndFromWhichFitFollowsTheBranchesComesFirst) {
  const TriangleSurface whole = infant("pulmonary_artery");
  std::vector<int> near;
  for (int t = 0; t < whole.triangles.rows(); ++t)
    if ((triangle_center(whole, t) - Vec3(10, 9.5, 1.8)).norm() < 8) near.push_back(t);
  TriangleSurface fork = part_with(whole, near);
  const int last = static_cast<int>(fork.points.rows()) - 1;
  fork.points = fork.points.colwise().reverse().eval();
  fork.triangles = (last - fork.triangles.array()).eval();
  EXPECT_THROW(fit_vessel("fork", fork), InputError);
  PrepareRequest short_fork = request(fork);
  short_fork.units = "mm";
  const PreparedSurface out = prepare(short_fork);
  EXPECT_EQ(out.refusal, "");
  EXPECT_EQ(out.ends.size(), 3U);
  EXPECT_EQ(out.surface.points.rows(), fork.points.rows());
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

// The voxels of 0.5 mm, as a MetaImage, whose centres lie in a vessel with flat lids.
std::string mask_of(TriangleSurface vessel) {
  constexpr double spacing = 0.5;
  for (const auto& loop : boundary_loops(vessel.triangles)) {
    TriangleSurface lid;
    lid.points = vessel.points(loop, Eigen::all).colwise().mean();
    const auto n = static_cast<int>(vessel.points.rows());
    append(vessel, lid);
    const auto first = vessel.triangles.rows();
    vessel.triangles.conservativeResize(first + static_cast<Eigen::Index>(loop.size()), 3);
    for (std::size_t k = 0; k < loop.size(); ++k)
      vessel.triangles.row(first + static_cast<Eigen::Index>(k)) << loop[(k + 1) % loop.size()],
          loop[k], n;
  }
  const Vec3 low = vessel.points.colwise().minCoeff(), high = vessel.points.colwise().maxCoeff();
  const Vec3 origin = low.array() - 2.2 * spacing;
  const Eigen::Array3i size = ((high - origin).array() / spacing + 2.2).ceil().cast<int>();
  std::string voxels(static_cast<std::size_t>(size.prod()), '\0');
  const RayHits rays(vessel);
  for (int j = 0; j < size[1]; ++j)
    for (int i = 0; i < size[0]; ++i) {
      const Vec3 start = origin + Vec3(i * spacing + 1e-5, j * spacing + 2e-5, 0);
      for (const RayHit& hit : rays.along(start, Vec3::UnitZ()))
        for (int k = static_cast<int>(std::ceil(hit.distance / spacing)); k < size[2]; ++k)
          voxels[static_cast<std::size_t>((k * size[1] + j) * size[0] + i)] ^= 1;
    }
  std::ostringstream head;
  head << "ObjectType = Image\nNDims = 3\nBinaryData = True\nCompressedData = False\n"
       << "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = " << origin.transpose()
       << "\nElementSpacing = 0.5 0.5 0.5\nDimSize = " << size.transpose()
       << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  return head.str() + voxels;
}

// From the first point of its cap that is found, no section parts the trunk from the rest.
TEST_F(Prepare, EveryEndOfRealAnatomyAsAMaskIsOpened) {
  const TriangleSurface artery = read_polydata(real_anatomy() / "pulmonary_artery.vtp").surface;
  PrepareRequest ask;
  ask.files = {write("artery.mha", mask_of(artery))};
  ask.units = "mm";
  const PreparedSurface out = prepare(ask);
  EXPECT_EQ(out.refusal, "");
  const auto loops = boundary_loops(artery.triangles);
  ASSERT_EQ(out.ends.size(), loops.size());
  for (const auto& loop : loops) {
    const Vec3 center = artery.points(loop, Eigen::all).colwise().mean().transpose();
    double nearest = 1e300;
    for (const PreparedEnd& end : out.ends)
      nearest = std::min(nearest, (end.center - center).norm());
    EXPECT_LT(nearest, 1.5 * perimeter(artery.points, loop) / (2 * M_PI));
  }
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
