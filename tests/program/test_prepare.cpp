// `vasorod prepare` on the bundled anatomy, spoilt by meshes/spoil.py in the ways of segmentations.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"
#include "program/run_program.h"
#include "real_anatomy.h"
#include "surface_file/read_polydata.h"

namespace vasorod::testing {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return " '" + path.string() + "'";
}

struct Distances {
  double largest = 0, mean = 0;
};

// From the prepared wall to the original one, whose ends count as on it.
Distances distances(const TriangleSurface& prepared, const TriangleSurface& original) {
  const ClosestPoint wall(original);
  const Eigen::VectorXd area = vertex_areas(prepared);
  Distances out;
  for (Eigen::Index i = 0; i < prepared.points.rows(); ++i) {
    const Vec3 p = prepared.points.row(i);
    const double d = (wall.query(p).point - p).norm();
    out.largest = std::max(out.largest, d);
    out.mean += d * area[i] / area.sum();
  }
  return out;
}

struct Spoilt {
  const char* file;
  const char* words;     // that the report has
  double mean, largest;  // mm
};

// The folder with the spoilt files of a bundled vessel.
fs::path spoilt(const std::string& vessel) {
  static const ScratchFolder scratch;
  fs::path folder = scratch / vessel;
  if (!fs::exists(folder)) {
    const fs::path meshes = fs::path(VASOROD_SOURCE_DIR) / "meshes";
    const ProgramRun run =
        run_program("'" VASOROD_SPOIL_PYTHON "'" + quoted(meshes / "spoil.py") +
                    quoted(meshes / "infant" / (vessel + ".vtp")) + quoted(folder));
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  return folder;
}

class Corpus : public ::testing::TestWithParam<Spoilt> {};

TEST_P(Corpus, TheWallComesBackAndFitReadsIt) {
  const Spoilt& by = GetParam();
  const ScratchFolder scratch;
  for (const auto& [vessel, ends] :
       {std::pair<std::string, std::size_t>{"svc", 2}, {"pulmonary_artery", 3}}) {
    SCOPED_TRACE(vessel + " " + by.file);
    const fs::path out = scratch / (vessel + ".vtp");
    const ProgramRun run = run_program(
        vasorod("prepare" + quoted(spoilt(vessel) / by.file) + " --json -o" + quoted(out)));
    ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
    EXPECT_NE(run.out.find(by.words), std::string::npos) << run.out;
    const Json report = Json::parse(run.out);
    EXPECT_EQ(report["ends"].size(), ends);
    EXPECT_NEAR(report["volume"]["after"].get<double>() / report["volume"]["before"].get<double>(),
                1, 0.01);
    LoadedSurface prepared = read_polydata(out);
    const std::string space = report["space"].is_null() ? "" : report["space"].get<std::string>();
    EXPECT_EQ(prepared.space, space);
    if (space == "RAS") prepared.surface.points.leftCols<2>() *= -1;
    const Distances moved = distances(
        prepared.surface,
        read_polydata(fs::path(VASOROD_SOURCE_DIR) / "meshes/infant" / (vessel + ".vtp")).surface);
    EXPECT_LT(moved.mean, by.mean);
    EXPECT_LT(moved.largest, by.largest);
    const ProgramRun fit =
        run_program(vasorod("fit" + quoted(out) + " --json -o" + quoted(scratch / vessel)));
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    EXPECT_EQ(Json::parse(fit.out)["fit"]["ends"].size(), ends);
  }
}

INSTANTIATE_TEST_SUITE_P(
    EachWay, Corpus,
    ::testing::Values(Spoilt{"closed.vtp", "flat lids taken off", 1e-9, 1e-9},
                      Spoilt{"inverted.vtp", "turned inside out", 1e-9, 1e-9},
                      Spoilt{"mixed.vtp", "triangles turned like their neighbours", 1e-9, 1e-9},
                      Spoilt{"cm.vtp", "cm is a guess", 1e-9, 1e-9},
                      Spoilt{"islands.vtp", "an island of", 1e-9, 1e-9},
                      Spoilt{"holes.vtp", "holes closed", 0.005, 0.2},
                      Spoilt{"ras.ply", "RAS", 1e-7, 1e-7},
                      Spoilt{"double.vtp", "outer of two walls taken as it is", 1e-9, 1e-9},
                      // Half a voxel is 0.25 mm; a crotch or a rim is sharper than the voxels.
                      Spoilt{"stairs.vtp", "stairs of voxels smoothed", 0.15, 0.75},
                      Spoilt{"mask.nii.gz", "label 1 of the mask", 0.15, 0.75},
                      Spoilt{"mask.nrrd", "label 1 of the mask", 0.15, 0.75},
                      Spoilt{"mask.mha", "label 1 of the mask", 0.15, 0.75}),
    [](const auto& way) {
      std::string name = way.param.file;
      for (char& c : name)
        if (c == '.') c = '_';
      return name;
    });

TEST(PrepareCommand, BadInputIsOneSentence) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "text.vtp") << "no surface";
  std::ofstream(scratch / "text.nrrd") << "no mask";
  const fs::path svc = fs::path(VASOROD_SOURCE_DIR) / "meshes/infant/svc.vtp";
  for (const auto& [arguments, code, words] :
       {std::tuple<std::string, int, std::string>{quoted(scratch / "none.nrrd"), 2, "no such file"},
        {quoted(scratch / "text.vtp"), 2, "text.vtp"},
        {quoted(scratch / "text.nrrd"), 2, "does not begin with NRRD"},
        {quoted(svc) + " --label 1", 2, "expected a mask with --label"},
        {quoted(svc) + " --space RAS", 2, "expected --from-space"},
        {quoted(svc) + " --units inch", 2, "inch"},
        {quoted(svc) + " --end 1,2", 2, "--end"},
        {quoted(svc) + " --end 0,0,0", 2, "no closed end within three radii"},
        {quoted(svc) + " --units m", 2, "implausible"}}) {
    const ProgramRun run =
        run_program(vasorod("prepare" + arguments + " -o" + quoted(scratch / "out.vtp")));
    EXPECT_EQ(run.exit_code, code) << arguments << run.out;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  EXPECT_FALSE(fs::exists(scratch / "out.vtp"));
  EXPECT_EQ(
      run_program(vasorod("prepare" + quoted(svc) + " -o" + quoted(scratch / "absent" / "out.vtp")))
          .exit_code,
      3);
  EXPECT_EQ(run_program(vasorod("prepare" + quoted(svc) + " -o" + quoted(svc))).exit_code, 2);
}

// Two tubes of one label side by side, `gap` voxels apart, as a MetaImage of 0.5 mm. The second is
// as long, of two thirds of the radius. `joined` at one end: a hairpin.
fs::path two_tubes_in_one_label(const fs::path& file, int gap, bool joined = false) {
  constexpr int across = 60, deep = 30, along = 90, radius = 9, second = 6;
  std::string voxels(across * deep * along, '\0');
  const int middle = 14, other = middle + radius + gap + second;
  for (int k = 5; k < along - 5; ++k)
    for (int j = 0; j < deep; ++j)
      for (int i = 0; i < across; ++i) {
        const int y = j - deep / 2;
        const bool one = (i - middle) * (i - middle) + y * y <= radius * radius,
                   two = (i - other) * (i - other) + y * y <= second * second;
        const bool bend =
            joined && k < 5 + 2 * second && i >= middle && i <= other && std::abs(y) <= second;
        if (one || two || bend) voxels[static_cast<size_t>((k * deep + j) * across + i)] = 1;
      }
  std::ofstream stream(file, std::ios::binary);
  stream << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
            "ElementSpacing = 0.5 0.5 0.5\nDimSize = "
         << across << ' ' << deep << ' ' << along
         << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
         << voxels;
  return file;
}

TEST(PrepareCommand, WhatFitRefusesIsWrittenWithTheReason) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out.vtp";
  const ProgramRun run = run_program(
      vasorod("prepare" + quoted(two_tubes_in_one_label(scratch / "hairpin.mha", 2, true)) + " -o" +
              quoted(out)));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.out.find("warning: fit refuses it: "), std::string::npos) << run.out;
  EXPECT_GT(read_polydata(out).surface.triangles.rows(), 1000);
}

TEST(PrepareCommand, OfTwoVesselsInOneLabelTheLargerIsKeptAndTheOtherIsNamed) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out.vtp";
  const ProgramRun run = run_program(vasorod(
      "prepare" + quoted(two_tubes_in_one_label(scratch / "two.mha", 6)) + " -o" + quoted(out)));
  ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_NE(run.out.find("a second vessel may be in it"), std::string::npos) << run.out;
  const Points points = read_polydata(out).surface.points;
  EXPECT_LT(points.col(0).maxCoeff(), 0.5 * (14 + 9 + 3)) << "the larger tube alone";
  EXPECT_EQ(boundary_loops(read_polydata(out).surface.triangles).size(), 2U);
  // Where they touch all along they are one part.
  const ProgramRun touching =
      run_program(vasorod("prepare" + quoted(two_tubes_in_one_label(scratch / "touching.mha", 0)) +
                          " -o" + quoted(out)));
  ASSERT_EQ(touching.exit_code, 0) << touching.err << touching.out;
  EXPECT_NE(touching.out.find("two vessels that touch may be in it"), std::string::npos)
      << touching.out;
}

TEST(PrepareCommand, BranchesBelowARadiusAreTakenOffAndOtherEndsOpened) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out.vtp", mask = spoilt("aorta") / "mask.nrrd";
  const auto prepared = [&](const std::string& arguments) {
    return Json::parse(
        run_program(vasorod("prepare" + quoted(mask) + arguments + " --json -o" + quoted(out)))
            .out);
  };
  // The arch's branches have radii of 1.5, 1.6 and 2.1 mm (meshes/infant_anatomy.py).
  const Json thick = prepared(" --cut-branches-below 1.85");
  ASSERT_EQ(thick["ends"].size(), 3U);
  for (const Json& end : thick["ends"]) EXPECT_GT(end["radius"].get<double>(), 1.85);
  EXPECT_EQ(boundary_loops(read_polydata(out).surface.triangles).size(), 3U);
  EXPECT_EQ(prepared(" --end 3,-1.6,-13 --end 9.2,22,-18")["ends"].size(), 2U);
}

// The joined vessels of a result: what a scan after the operation would show of their lumen.
struct Operated {
  const char *scene, *vein, *artery;
  std::vector<Vec3> ends;  // of the result, mm
};

TEST(PrepareCommand, ALumenAfterTheOperationIsFittedWithAllItsEnds) {
  const fs::path root = VASOROD_SOURCE_DIR, meshes = root / "meshes";
  for (const Operated& by :
       {Operated{
            "tests/program/small_glenn.yaml", "svc", "rpa", {{0, 0, 45}, {-25, 0, 0}, {25, 0, 0}}},
        Operated{"benchmarks/cases/glenn/infant.yaml",
                 "svc",
                 "pulmonary_artery",
                 {{-9.2, 2.7, 31}, {10, -11, -12}, {24, 17, 0}, {-26, 12, -9.4}}}}) {
    SCOPED_TRACE(by.scene);
    const ScratchFolder scratch;
    ASSERT_EQ(
        run_program(vasorod("solve" + quoted(root / by.scene) +
                            " --fidelity skin --no-report -q -o" + quoted(scratch / "result")))
            .exit_code,
        0);
    const auto python = [&](const std::string& script, const std::string& arguments) {
      const ProgramRun run =
          run_program("'" VASOROD_SPOIL_PYTHON "'" + quoted(meshes / script) + arguments);
      EXPECT_EQ(run.exit_code, 0) << run.err;
    };
    const fs::path lumen = scratch / "lumen.vtp", out = scratch / "out.vtp";
    python("join.py", quoted(scratch / "result" / (std::string(by.vein) + ".vtp")) +
                          quoted(scratch / "result" / (std::string(by.artery) + ".vtp")) +
                          quoted(lumen));
    python("spoil.py", quoted(lumen) + quoted(scratch / "spoilt"));
    for (const char* file : {"closed.vtp", "mask.nrrd", "stairs.vtp"}) {
      SCOPED_TRACE(file);
      const ProgramRun run = run_program(
          vasorod("prepare" + quoted(scratch / "spoilt" / file) + " --json -o" + quoted(out)));
      ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
      const Json report = Json::parse(run.out);
      EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
      ASSERT_EQ(report["ends"].size(), by.ends.size());
      // Each is found, and loses at most two radii (5 mm for the widest).
      for (const Vec3& end : by.ends) {
        double nearest = HUGE_VAL;
        for (const Json& found : report["ends"])
          nearest = std::min(
              nearest, (Vec3(found["center"].get<std::vector<double>>().data()) - end).norm());
        EXPECT_LT(nearest, 10) << end.transpose();
      }
      // Half a voxel is 0.25 mm; the seam is a crease that smoothing rounds.
      EXPECT_LT(distances(read_polydata(out).surface, read_polydata(lumen).surface).largest, 0.75);
      const ProgramRun fit =
          run_program(vasorod("fit" + quoted(out) + " --json -o" + quoted(scratch / "fit")));
      ASSERT_EQ(fit.exit_code, 0) << fit.err;
      const Json fitted = Json::parse(fit.out)["fit"];
      EXPECT_EQ(fitted["ends"].size(), by.ends.size());
      // n ends of a tree of tubes that fork in twos: 2 n - 3 branches.
      EXPECT_EQ(fitted["branches"].size(), 2 * by.ends.size() - 3);
    }
  }
}

// Its thinnest branch is six voxels wide.
TEST(PrepareCommand, EveryEndOfTheAortaIsOpenedBehindItsCap) {
  const ScratchFolder scratch;
  const auto radii = [](const TriangleSurface& surface) {
    std::vector<double> out;
    for (const auto& loop : boundary_loops(surface.triangles))
      out.push_back(perimeter(surface.points, loop) / (2 * M_PI));
    std::sort(out.begin(), out.end());
    return out;
  };
  const std::vector<double> whole =
      radii(read_polydata(fs::path(VASOROD_SOURCE_DIR) / "meshes/infant/aorta.vtp").surface);
  ASSERT_EQ(whole.size(), 5U);
  for (const char* file : {"mask.nrrd", "mask.nii.gz", "stairs.vtp"}) {
    SCOPED_TRACE(file);
    const fs::path out = scratch / "out.vtp";
    const ProgramRun run = run_program(
        vasorod("prepare" + quoted(spoilt("aorta") / file) + " --json -o" + quoted(out)));
    ASSERT_EQ(run.exit_code, 0) << run.err << run.out;
    const Json report = Json::parse(run.out);
    EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
    const std::vector<double> found = radii(read_polydata(out).surface);
    ASSERT_EQ(found.size(), whole.size());
    for (std::size_t k = 0; k < whole.size(); ++k)
      EXPECT_NEAR(found[k] / whole[k], 1, 0.06) << whole[k];
  }
}

// The spoilt files of a vessel of the real anatomy.
void spoil_real(const std::string& vessel, const fs::path& folder) {
  const ProgramRun spoil = run_program(
      "'" VASOROD_SPOIL_PYTHON "'" + quoted(fs::path(VASOROD_SOURCE_DIR) / "meshes" / "spoil.py") +
      quoted(real_anatomy() / (vessel + ".vtp")) + quoted(folder));
  ASSERT_EQ(spoil.exit_code, 0) << spoil.err;
}

// The arch's branches are cut so near the arch that they have no length of their own. The first
// one's cap goes over into the wall between it and the second: it stays closed and is named.
TEST(PrepareCommand, RealAnatomyOfCutBranchesAllButOneAreOpenedAndThatIsNamed) {
  const ScratchFolder scratch;
  spoil_real("aorta", scratch / "spoilt");
  const fs::path out = scratch / "out.vtp";
  for (const char* file : {"mask.nrrd", "mask.nii.gz", "stairs.vtp"}) {
    SCOPED_TRACE(file);
    const ProgramRun run =
        run_program(vasorod("prepare" + quoted(scratch / "spoilt" / file) + " -o" + quoted(out)));
    EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
    Points points = read_polydata(out).surface.points;
    const auto loops = boundary_loops(read_polydata(out).surface.triangles);
    EXPECT_EQ(loops.size(), 4U);
    if (run.out.find("system: RAS") != std::string::npos) points.leftCols<2>() *= -1;
    // Centres and radii of the ends in the surface, mm; the tubes widen towards the arch.
    for (const auto& [center, radius] :
         {std::pair{Vec3(4.4, 543.5, -57.1), 4.2}, {Vec3(16.2, 546.5, -74.1), 7.5}}) {
      double nearest = HUGE_VAL, found = 0;
      for (const auto& loop : loops) {
        Vec3 middle = Vec3::Zero();
        for (const int v : loop)
          middle += points.row(v).transpose() / static_cast<double>(loop.size());
        if ((middle - center).norm() > nearest) continue;
        nearest = (middle - center).norm();
        found = perimeter(points, loop) / (2 * M_PI);
      }
      EXPECT_LT(nearest, 0.25 * radius);
      EXPECT_NEAR(found / radius, 1, 0.1);
    }
    // The third: (-7.9, 538.4, -55.5).
    const auto place = run.out.find("as over a closed end, at (");
    ASSERT_NE(place, std::string::npos) << run.out;
    EXPECT_NE(run.out.find("53", place), std::string::npos) << run.out;
    // The option that opens every end.
    std::size_t options = 0;
    for (auto at = run.out.find("--end ", place); at != std::string::npos;
         at = run.out.find("--end ", at + 1))
      ++options;
    EXPECT_EQ(options, 5U) << run.out;
  }
}

// Its folded walls have flat places that no plane parts from the rest.
TEST(PrepareCommand, RealAnatomyNoWallIsTakenForAnEnd) {
  const ScratchFolder scratch;
  for (const std::string name : {"svc", "pulmonary_artery"}) {
    spoil_real(name, scratch / name);
    for (const char* file : {"holes.vtp", "mask.nrrd", "mask.nii.gz", "stairs.vtp"}) {
      const ProgramRun run = run_program(
          vasorod("prepare" + quoted(scratch / name / file) + " -o" + quoted(scratch / "out.vtp")));
      EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
      EXPECT_EQ(run.out.find("as over a closed end"), std::string::npos) << run.out;
    }
  }
}

TEST(PrepareCommand, RealAnatomyIsReadAndFits) {
  const ScratchFolder scratch;
  for (const std::string name : {"svc", "aorta", "pulmonary_artery"}) {
    const fs::path out = scratch / (name + ".vtp");
    const ProgramRun run = run_program(
        vasorod("prepare" + quoted(real_anatomy() / (name + ".vtp")) + " --json -o" + quoted(out)));
    EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
    // The left branch of the artery ends flat, about 3 to 1.
    EXPECT_EQ(run.out.find("nearly flat") != std::string::npos, name == "pulmonary_artery")
        << run.out;
  }
}

}  // namespace
}  // namespace vasorod::testing
