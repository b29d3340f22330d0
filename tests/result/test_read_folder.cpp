#include <fstream>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "result/example_result.h"
#include "result/read_folder.h"
#include "result/write_vtp.h"

namespace vasorod {
namespace {

void write_all(const std::filesystem::path& folder, const Result& result) {
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  write("result.json", to_json(result));
  for (const VesselResult& vessel : result.vessels) {
    write(vessel.name + ".vtp", vessel_vtp(vessel, stamp_of(result, vessel)));
    if (vessel.centerline)
      write(vessel.name + "_centerline.vtp", centerline_vtp(*vessel.centerline));
    if (vessel.stump) write(vessel.name + "_stump.vtp", surface_vtp(*vessel.stump));
  }
}

TEST(ReadFolder, ReadsBackWhatWasWritten) {
  const test::TemporaryFolder folder;
  Result written = test::example_result();
  written.vessels[0].space = "RAS";
  write_all(folder.path, written);
  const Result read = read_result_folder(folder.path);
  ASSERT_EQ(read.vessels.size(), written.vessels.size());
  const VesselResult &a = written.vessels[0], &b = read.vessels[0];
  EXPECT_EQ(b.rest, a.rest);
  EXPECT_EQ(b.current, a.current);
  EXPECT_EQ(b.triangles, a.triangles);
  EXPECT_EQ(b.axial_stretch, a.axial_stretch);
  EXPECT_EQ(b.twist_shear, a.twist_shear);
  EXPECT_EQ(b.contact_pressure, a.contact_pressure);
  EXPECT_EQ(b.space, "RAS");
  EXPECT_EQ(read.vessels[1].space, "");
  ASSERT_TRUE(b.centerline);
  EXPECT_EQ(b.centerline->current, a.centerline->current);
  EXPECT_EQ(b.centerline->radius, a.centerline->radius);
  EXPECT_EQ(b.centerline->abscissa, a.centerline->abscissa);
  EXPECT_EQ(b.centerline->lines, a.centerline->lines);
  EXPECT_EQ(b.centerline->directors, a.centerline->directors);
  EXPECT_EQ(b.centerline->u, a.centerline->u);
  EXPECT_EQ(b.centerline->v, a.centerline->v);
  EXPECT_EQ(b.centerline->u0, a.centerline->u0);
  EXPECT_EQ(b.centerline->v0, a.centerline->v0);
  EXPECT_EQ(b.centerline->lumen_area, a.centerline->lumen_area);
  EXPECT_EQ(b.centerline->flattening, a.centerline->flattening);
  ASSERT_TRUE(b.stump);
  EXPECT_EQ(b.stump->points, a.stump->points);
  EXPECT_EQ(b.stump->triangles, a.stump->triangles);
  EXPECT_TRUE(read.vessels[1].obstacle);
  EXPECT_FALSE(read.vessels[1].centerline);
  ASSERT_EQ(read.glenn.has_value(), written.glenn.has_value());
  if (read.glenn) {
    EXPECT_EQ(read.glenn->svc, written.glenn->svc);
    EXPECT_EQ(read.glenn->incision.ends, written.glenn->incision.ends);
  }
}

TEST(ReadFolder, AFolderThatIsNoneIsRefusedInASentence) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(read_result_folder(folder.path), InputError);
  write_all(folder.path, test::example_result());
  std::ofstream(folder.path / "svc.vtp") << "no VTP";
  EXPECT_THROW(read_result_folder(folder.path), InputError);
}

}  // namespace
}  // namespace vasorod
