#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "scratch_folder.h"
#include "surface_file/open_caps.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

LoadedSurface opened(const TriangleSurface& surface) {
  LoadedSurface loaded;
  loaded.surface = surface;
  open_caps(loaded);
  return loaded;
}

TEST(OpenCaps, TakesFlatLidsOff) {
  const auto loaded = opened(closed_tube({0, 1}, 0));
  EXPECT_EQ(loaded.report.removed_caps, 2);
  EXPECT_EQ(loaded.surface.points, sample_tube().points);
  EXPECT_EQ(loaded.surface.triangles, sample_tube().triangles);
}

TEST(OpenCaps, TakesOneLidOff) {
  const auto loaded = opened(closed_tube({1}, 0));
  EXPECT_EQ(loaded.report.removed_caps, 1);
  EXPECT_EQ(loaded.surface.triangles, sample_tube().triangles);
}

TEST(OpenCaps, TakesObliqueLidsOff) {
  TriangleSurface surface = closed_tube({0, 1}, 0);
  for (int i = 0; i < surface.points.rows();
       ++i)  // sheared: the lids stand at 45 degrees to the axis
    surface.points(i, 2) += surface.points(i, 0);
  EXPECT_EQ(opened(surface).report.removed_caps, 2);
}

TEST(OpenCaps, LeavesOpenTubesRoundEndsAndCoarseTubesAlone) {
  EXPECT_EQ(opened(sample_tube()).report.removed_caps, 0);
  EXPECT_EQ(opened(closed_tube({0, 1}, 8)).report.removed_caps, 0);
  TubeSpec coarse = small_tube();
  coarse.around = 8;
  coarse.along = 4;
  EXPECT_EQ(opened(tube_surface(coarse)).report.removed_caps, 0);
}

TEST(OpenCaps, ACubeHasNoLidsToTakeOff) {
  // Its faces are flat with creases all around, but they share their borders.
  TriangleSurface cube;
  cube.points.resize(14, 3);
  for (int i = 0; i < 8; ++i)
    cube.points.row(i) << (i & 1 ? 10 : -10), (i & 2 ? 10 : -10), (i & 4 ? 10 : -10);
  const int around[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  cube.triangles.resize(24, 3);
  for (int f = 0; f < 6; ++f) {
    cube.points.row(8 + f).setZero();
    for (int k = 0; k < 4; ++k) {
      cube.points.row(8 + f) += 0.25 * cube.points.row(around[f][k]);
      cube.triangles.row(4 * f + k) << around[f][k], around[f][(k + 1) % 4], 8 + f;
    }
  }
  EXPECT_EQ(opened(cube).report.removed_caps, 0);
}

TEST(OpenCaps, UsesTheFacesASimVascularModelNames) {
  // A lid domed by 7 degrees: its facets differ by up to 14 degrees, so they are no flat region by
  // angle, but the file names them one face.
  LoadedSurface loaded;
  loaded.surface = closed_tube({0, 1}, 1.2);
  EXPECT_EQ(opened(loaded.surface).report.removed_caps, 0);
  const Eigen::Index wall = sample_tube().triangles.rows();
  NamedArray face{"ModelFaceID", {}, true, "Int32"};
  face.values.resize(loaded.surface.triangles.rows(), 1);
  face.values.topRows(wall).setConstant(1);
  face.values.middleRows(wall, 24).setConstant(2);
  face.values.bottomRows(24).setConstant(3);
  loaded.cell_arrays = {face};
  open_caps(loaded);
  EXPECT_EQ(loaded.report.removed_caps, 2);
  EXPECT_EQ(loaded.cell_arrays[0].values, face.values.topRows(wall));
  // The tube stands on the origin along z and is 40 long.
  ASSERT_EQ(loaded.lids.size(), 2U);
  for (const Lid& lid : loaded.lids) {
    EXPECT_EQ(lid.name, lid.center.z() < 20 ? "2" : "3");
    EXPECT_NEAR(lid.center.z(), lid.center.z() < 20 ? 0 : 40, 1);
    EXPECT_LT(lid.center.head<2>().norm(), 1e-9);
  }
}

TEST(OpenCaps, LidsWithoutFacesHaveNoNames) {
  const auto loaded = opened(closed_tube({0, 1}, 0));
  ASSERT_EQ(loaded.lids.size(), 2U);
  for (const Lid& lid : loaded.lids) EXPECT_EQ(lid.name, "");
}

class CappedFile : public ScratchFolder {};

TEST_F(CappedFile, OpensWithStartAtTheLowestPoint) {
  const auto surface = closed_tube({0, 1}, 0);
  write_vtp(folder / "tube.vtp", surface);
  const auto loaded = load_surface(vessel_of(folder / "tube.vtp"), Scene());
  EXPECT_EQ(loaded.report.text(), "2 lids over ends removed");
  EXPECT_EQ(boundary_loops(loaded.surface.triangles)[0][0], 0);
  VesselSpec obstacle = vessel_of(folder / "tube.vtp");
  obstacle.role = Role::obstacle;  // without flow: stays closed
  EXPECT_EQ(load_surface(obstacle, Scene()).surface.triangles, surface.triangles);
}

}  // namespace
}  // namespace vasorod
