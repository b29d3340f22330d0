// Joins of scenes solved and reported: places, units, errors, comparison of two results.
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/compare.h>
#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "reference_fem/joined_tubes.h"
#include "reference_fem/solve_scene.h"
#include "scratch_folder.h"

namespace vasorod::fem {
namespace {

constexpr double pi = std::numbers::pi;

SolveOptions coarse() {
  SolveOptions options;
  options.model = ModelKind::shell;
  options.degree = 2;
  options.refine = 0;
  options.around = 8;
  return options;
}

Result solved(const std::string& text, const SolveOptions& options = coarse()) {
  return solve_scene(scene_of_text(text), options);
}

/// Area of a surface.
double area(const Points& points, const Triangles& triangles) {
  double sum = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vec3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
               c = points.row(triangles(t, 2));
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

TEST(SolveJoinScene, TakesTheEllipseOutThatTheSceneAsksFor) {
  const Result slit = solved(joined_tubes_text),
               hole = solved(with(joined_tubes_text, "rotation_deg: 0",
                                  "incision_shape: {ellipse: 0.5}, rotation_deg: 0"));
  ASSERT_EQ(hole.status, Status::converged);
  ASSERT_TRUE(slit.glenn && hole.glenn && slit.glenn->mouth && hole.glenn->mouth);
  EXPECT_EQ(slit.glenn->incision.shape, "slit");
  EXPECT_NEAR(slit.glenn->incision.perimeter_ratio, 1, 1e-12);
  const auto& incision = hole.glenn->incision;
  EXPECT_EQ(incision.shape, "ellipse");
  EXPECT_NEAR(incision.width, 0.5 * incision.length, 1e-9);
  EXPECT_NEAR(incision.perimeter, 4 * pi, 1e-8);
  EXPECT_NEAR(incision.removed_area, pi / 4 * incision.length * incision.width, 1e-9);
  EXPECT_GT(hole.glenn->mouth->area, 2 * slit.glenn->mouth->area);
  EXPECT_LT(hole.energy.total(), 0.5 * slit.energy.total());
  // The artery lacks what was taken out; its triangles lie inside the round wall.
  const auto wall = [](const Result& result) {
    return area(result.vessels[1].rest, result.vessels[1].triangles);
  };
  EXPECT_NEAR(wall(slit) - wall(hole), incision.removed_area, 0.05 * incision.removed_area);
}

// Pressure in both lumens widens the mouth and pulls at the ends, in the shell as in the solid.
TEST(SolveJoinScene, APressureOpensTheMouth) {
  const std::string hole =
      with(joined_tubes_text, "rotation_deg: 0", "incision_shape: {ellipse: 0.5}, rotation_deg: 0");
  const auto under_pressure = [](const std::string& text, const std::string& vessel) {
    return with(text, vessel, vessel + "    pressure: {after: 0.01}\n");
  };
  const std::string pressed =
      under_pressure(under_pressure(hole, "  - name: vein\n"), "  - name: artery\n");
  SolveOptions options = coarse();
  const Result shell = solved(pressed, options);
  options.model = ModelKind::solid;
  const Result solid = solved(pressed, options), free = solved(hole, options);
  ASSERT_EQ(shell.status, Status::equilibrium_only);
  ASSERT_EQ(solid.status, Status::equilibrium_only);
  EXPECT_GT(solid.glenn->mouth->area, 1.05 * free.glenn->mouth->area);
  EXPECT_NEAR(shell.glenn->mouth->area / solid.glenn->mouth->area, 1, 0.02);
  ASSERT_EQ(shell.ends.size(), solid.ends.size());
  double largest = 0;
  for (const EndReaction& end : solid.ends) largest = std::max(largest, end.force.norm());
  for (std::size_t e = 0; e < solid.ends.size(); ++e) {
    EXPECT_LT((shell.ends[e].force - solid.ends[e].force).norm(), 0.03 * largest) << e;
    // The vessel's own tension, 2 nu p pi r_i^2 in a straight tube, pulls the ends outwards.
    EXPECT_GT((solid.ends[e].force - free.ends[e].force).norm(), 0.01) << e;
  }
}

TEST(SolveJoinScene, ReportsTheOperation) {
  SolveOptions options = coarse();
  options.degree = 3;
  const Result r = solved(joined_tubes_text, options);
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_EQ(r.fidelity, "shell");
  ASSERT_TRUE(r.glenn && r.glenn->mouth);
  const GlennReport& glenn = *r.glenn;
  EXPECT_EQ(glenn.svc, "vein");
  EXPECT_EQ(glenn.rpa, "artery");
  EXPECT_NEAR(glenn.cut.fraction, 8.0 / 14, 1e-12);
  EXPECT_NEAR(glenn.cut.perimeter, 4 * pi, 1e-12);
  EXPECT_LT((glenn.cut.point - Vec3(0, 0, 8)).norm(), 1e-12);
  EXPECT_LT((glenn.cut.normal - Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_NEAR(glenn.incision.length, 2 * pi, 1e-12);
  EXPECT_LT((glenn.incision.ends[0] - Vec3(-pi, 0, 8)).norm(), 1e-12);
  EXPECT_LT((glenn.incision.ends[1] - Vec3(pi, 0, 8)).norm(), 1e-12);
  EXPECT_LT(glenn.join.largest_gap, 1e-12);
  EXPECT_EQ(glenn.join.pairs, 24);  // 8 cells of degree 3 around the whole seam
  const MouthReport& mouth = *glenn.mouth;
  EXPECT_NEAR(glenn.incision.opened_area, mouth.area, 1e-9);
  // an opened slit: nearly as long as before, and much narrower than the vein
  EXPECT_NEAR(mouth.perimeter_ratio, 1, 0.1);
  EXPECT_NEAR(mouth.span, 2 * pi, 0.5);
  EXPECT_GT(mouth.width, 0.2);
  EXPECT_LT(mouth.width, 3);
  EXPECT_LT(std::abs(mouth.center[0]) + std::abs(mouth.center[1]), 1e-9);

  ASSERT_EQ(r.vessels.size(), 2u);
  const VesselResult &vein = r.vessels[0], &artery = r.vessels[1];
  EXPECT_EQ(vein.name, "vein");
  EXPECT_NEAR(area(vein.rest, vein.triangles) / (4 * pi * 8), 1, 1e-3);
  EXPECT_NEAR(area(artery.rest, artery.triangles) / (4.4 * pi * 20), 1, 1e-3);
  // triangles face outwards: the volume inside the artery's rest wall, by the divergence theorem
  double volume = 0;
  const Eigen::RowVector3d middle(0, 0, 10.2);
  for (Eigen::Index t = 0; t < artery.triangles.rows(); ++t) {
    const Vec3 a = artery.rest.row(artery.triangles(t, 0)) - middle,
               b = artery.rest.row(artery.triangles(t, 1)) - middle,
               c = artery.rest.row(artery.triangles(t, 2)) - middle;
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(volume / (pi * 2.2 * 2.2 * 20 * 2 / 3), 1, 1e-2);  // without the ends' disks
  // the slit's two lips are closed at rest and open by the mouth in the end
  const Eigen::Index lips = artery.rest.rows() % 192;
  ASSERT_GT(lips, 4);
  double rest_gap = 0, gap = 0;
  for (Eigen::Index k = artery.rest.rows() - lips; k < artery.rest.rows(); ++k) {
    Eigen::Index other = 0;
    const Points to = artery.rest.topRows(artery.rest.rows() - lips);
    rest_gap = std::max(
        rest_gap,
        std::sqrt((to.rowwise() - artery.rest.row(k)).rowwise().squaredNorm().minCoeff(&other)));
    gap = std::max(gap, (artery.current.row(k) - artery.current.row(other)).norm());
  }
  EXPECT_LT(rest_gap, 1e-12);
  EXPECT_NEAR(gap, mouth.width, 0.02);
  for (const VesselResult* vessel : {&vein, &artery}) {
    EXPECT_TRUE(vessel->current.allFinite());
    EXPECT_EQ(vessel->axial_stretch.size(), vessel->rest.rows());
    EXPECT_GE(vessel->triangles.minCoeff(), 0);
    EXPECT_LT(vessel->triangles.maxCoeff(), vessel->rest.rows());
  }
  for (const Balance& balance : r.balance) EXPECT_LT(balance.residual, 1e-6) << balance.vessel;
  EXPECT_LE(r.metrics[0].smallest_lumen_ratio, mouth.area_ratio);
}

// Turned (x, y, z) -> (z, x, y), shifted by (5, -3, 7) mm, in metres, with the artery first and the
// vein drawn from its other end: the same join.
TEST(SolveJoinScene, PlaceUnitsAndOrderDoNotMatter) {
  const Result a = solved(joined_tubes_text);
  const Result b = solved(
      "scene: t\nfidelity: coupled\nunits: {length: m, stress: Pa}\nvessels:\n"
      "  - name: artery\n    tube: {length: 0.020, radius: 0.0022, position: [0.0152, -0.013, "
      "0.007], tangent: [0, 1, 0], normal: [1, 0, 0]}\n"
      "    wall: {thickness: 0.0005, young: 0.45e6, poisson: 0.4}\n    law: neo-hookean\n"
      "  - name: vein\n    tube: {length: 0.014, radius: 0.002, position: [0.019, -0.003, 0.007], "
      "tangent: [-1, 0, 0], normal: [0, 0, 1]}\n"
      "    wall: {thickness: 0.0005, young: 0.5e6, poisson: 0.4}\n    law: neo-hookean\n"
      "ends:\n"
      "  - {vessel: artery, end: end, hold: true}\n"
      "  - {vessel: vein, end: end, hold: true}\n"
      "  - {vessel: artery, end: {near: [0.0152, -0.013, 0.007]}, hold: true}\n"
      "contact: []\n"
      "surgery:\n  glenn: {svc: vein, rpa: artery, cut: [0.013, -0.001, 0.007], incision: [0.013, "
      "-0.003, 0.007], rotation_deg: 0, keep: {near: [0.005, -0.003, 0.007]}}\n");
  ASSERT_EQ(a.status, Status::converged);
  ASSERT_EQ(b.status, Status::converged);
  const auto turn = [](const Vec3& v) { return Vec3(v[2], v[0], v[1]); };
  const Vec3 shift(5, -3, 7);
  EXPECT_NEAR(b.energy.strain / (a.energy.strain * 1e-3), 1, 1e-8);  // Pa m^3 of MPa mm^3
  EXPECT_NEAR(b.glenn->mouth->area * 1e6 / a.glenn->mouth->area, 1, 1e-8);
  EXPECT_NEAR(b.glenn->mouth->span * 1e3 / a.glenn->mouth->span, 1, 1e-8);
  EXPECT_LT((1e3 * b.glenn->mouth->center - turn(a.glenn->mouth->center) - shift).norm(), 1e-6);
  EXPECT_NEAR(b.glenn->cut.fraction, a.glenn->cut.fraction, 1e-12);
  ASSERT_EQ(b.vessels[0].name, "artery");
  ASSERT_EQ(a.vessels[1].name, "artery");
  const auto moved = [](const Result& r, std::size_t v) {
    return Points(r.vessels[v].current - r.vessels[v].rest);
  };
  const Points artery_a = moved(a, 1), artery_b = 1e3 * moved(b, 0);
  ASSERT_EQ(artery_a.rows(), artery_b.rows());
  double largest = 0;
  for (Eigen::Index k = 0; k < artery_a.rows(); ++k)
    largest = std::max(largest, (Vec3(artery_b.row(k)) - turn(artery_a.row(k))).norm());
  EXPECT_LT(largest, 1e-6);
  ASSERT_EQ(b.ends.size(), 3u);
  for (const EndReaction& end : b.ends)
    for (const EndReaction& other : a.ends)
      if (end.vessel == "artery" && other.vessel == "artery" &&
          (end.end == "end") == (other.end == "end")) {
        EXPECT_LT((end.force - turn(other.force)).norm(), 1e-6 * end.force.norm());
        EXPECT_LT((1e3 * end.center - turn(other.center) - shift).norm(), 1e-9);
      }
}

TEST(SolveJoinScene, TheErrorEstimateHoldsAgainstAFinerMesh) {
  SolveOptions options = coarse();
  options.degree = 3;
  options.refine = 1;
  const Result two = solved(joined_tubes_text, options);
  ASSERT_TRUE(two.discretisation->error_estimate);
  options.refine = 0;
  options.around = 32;
  const Result fine = solved(joined_tubes_text, options);
  const double bound = *two.discretisation->error_estimate;
  EXPECT_LT(bound, 0.2);
  EXPECT_LT(std::abs(two.energy.strain / fine.energy.strain - 1), bound);
  EXPECT_LT(std::abs(two.glenn->mouth->area / fine.glenn->mouth->area - 1), bound);
}

class ComparedJoins : public ScratchFolder {};

TEST_F(ComparedJoins, TwoResultsCompareLikeAnyOthers) {
  SolveOptions options = coarse();
  options.degree = 3;
  Result a = solved(joined_tubes_text, options);
  options.around = 12;
  Result b = solved(joined_tubes_text, options);
  a.program = b.program = "vasorod-fem";
  write_result_folder(a, folder / "a");
  write_result_folder(b, folder / "b");
  const Comparison comparison = compare_results(folder / "a", folder / "b");
  ASSERT_EQ(comparison.vessels.size(), 2u);
  for (const VesselComparison& vessel : comparison.vessels) {
    ASSERT_TRUE(vessel.surface && vessel.centerline);
    EXPECT_LT(vessel.surface->rms, 0.01);
    EXPECT_GT(vessel.surface->rms, 0);
    EXPECT_LT(vessel.rest_distance, 0.01);
  }
  EXPECT_EQ(comparison.reactions.size(), 3u);
}

TEST(SolveJoinScene, RefusesOptionsItCannotMeet) {
  const auto refused = [](const SolveOptions& options, const std::string& part) {
    try {
      solved(joined_tubes_text, options);
      ADD_FAILURE() << "accepted: " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  SolveOptions options = coarse();
  options.around = 10;
  refused(options, "--cells: found 10 x 0, expected for a join with --refine 0 multiples of 4");
  options = coarse();
  options.mesh = "wall.msh";
  refused(options, "--mesh: found wall.msh, expected --cells for a join");
  options = coarse();
  options.model = ModelKind::solid;
  options.degree = 1;
  refused(options, "--degree: found 1, expected 2 to 4 for a join's solid");
  options = coarse();
  options.law = LawKind::split_neo_hookean;
  refused(options, "found the law split-neo-hookean");
}

TEST(SolveJoinScene, ReportsAnEndToEndJoin) {
  const Result r = solved(end_to_end_text);
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_FALSE(r.glenn);
  ASSERT_TRUE(r.end_to_end && r.end_to_end->mouth);
  const EndToEndReport& report = *r.end_to_end;
  EXPECT_EQ(report.rims[0].vessel, "wide");
  EXPECT_NEAR(report.rims[0].cut.fraction, 8.0 / 14, 1e-12);
  EXPECT_NEAR(report.rims[0].cut.perimeter, 4 * pi, 1e-12);
  EXPECT_LT((report.rims[0].cut.normal - Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_EQ(report.rims[1].vessel, "narrow");
  EXPECT_EQ(report.rims[1].cut.fraction, 1);
  EXPECT_LT((report.rims[1].cut.point - Vec3(0.2, 0, 8.5)).norm(), 1e-12);
  EXPECT_LT((report.rims[1].cut.normal + Vec3(0, 0, 1)).norm(), 1e-12);
  EXPECT_EQ(report.narrower, 1);
  EXPECT_EQ(report.join.rotation_deg, 10);
  EXPECT_LT(report.join.largest_gap, 1e-12);
  // Between both rims: the narrower is widened, the walls are pulled and become thinner.
  EXPECT_GT(report.mouth->perimeter, 2 * pi * 1.8);
  EXPECT_LT(report.mouth->perimeter, 4 * pi);
  EXPECT_NEAR(report.mouth->perimeter_ratio, report.mouth->perimeter / (2 * pi * 1.8), 1e-3);
  ASSERT_EQ(r.ends.size(), 2u);
  EXPECT_LT((r.ends[0].force + r.ends[1].force).norm(), 1e-6 * r.ends[0].force.norm());
  for (const Balance& balance : r.balance) EXPECT_LT(balance.residual, 1e-6);
}

TEST(SolveJoinScene, TheOrderOfVesselsDoesNotMatterToAnEndToEndJoin) {
  const Result here = solved(end_to_end_text);
  // The vessels' order in the file does not matter.
  std::string other = end_to_end_text;
  const auto wide = other.find("  - name: wide"), narrow = other.find("  - name: narrow"),
             ends = other.find("ends:");
  const std::string first = other.substr(wide, narrow - wide),
                    second = other.substr(narrow, ends - narrow);
  other.replace(wide, ends - wide, second + first);
  const Result there = solved(other);
  ASSERT_EQ(there.vessels[0].name, "narrow");
  EXPECT_NEAR(there.energy.total() / here.energy.total(), 1, 1e-9);
  EXPECT_NEAR(there.end_to_end->mouth->area / here.end_to_end->mouth->area, 1, 1e-9);
  EXPECT_LT((there.vessels[0].current - here.vessels[1].current).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace vasorod::fem
