// The seam of the operation on the bundled anatomy and on real vessels: what the solvers start
// from.
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "data/index.h"
#include "rod/binding.h"
#include "surgery/glenn.h"
#include "surgery/surface_checks.h"

namespace vasorod {
namespace {

struct Operated {
  PreparedVessel svc, rpa;
  Operation operation;
};

Operated operated(const std::string& file, const std::function<void(GlennSpec&)>& change) {
  Scene scene =
      read_scene(std::filesystem::path(VASOROD_SOURCE_DIR) / "benchmarks/cases/glenn" / file);
  change(*scene.glenn);
  Operated all;
  for (const VesselSpec& spec : scene.vessels) {
    if (spec.name != scene.glenn->svc && spec.name != scene.glenn->rpa) continue;
    PreparedVessel& vessel = spec.name == scene.glenn->svc ? all.svc : all.rpa;
    vessel = read_vessel(spec, scene);
    fit(vessel);
  }
  VesselConditions conditions = end_conditions(scene, scene.glenn->svc, all.svc.vessel);
  all.operation = operate(scene, *scene.glenn, all.svc, all.rpa, conditions);
  return all;
}

double distance(const PreparedVessel& vessel, int a, int b) {
  return (vessel.vessel.surface.points.row(a) - vessel.vessel.surface.points.row(b)).norm();
}

// `ratio`: the rim's perimeter over that of the vein's mouth.
Operated expect_equal_seam(
    const std::string& file, double ratio = 1, double tolerance = 2e-3,
    const std::function<void(GlennSpec&)>& change = [](GlennSpec&) {}) {
  SCOPED_TRACE(file);
  Operated all = operated(file, change);
  const auto& pairs = all.operation.pairs;
  const size_t n = pairs.size();
  std::vector<double> mouth, rim;
  for (size_t k = 0; k < n; ++k) {
    mouth.push_back(distance(all.svc, pairs[k][0], pairs[(k + 1) % n][0]));
    rim.push_back(distance(all.rpa, pairs[k][1], pairs[(k + 1) % n][1]));
  }
  const double of_mouth = std::accumulate(mouth.begin(), mouth.end(), 0.0),
               of_rim = std::accumulate(rim.begin(), rim.end(), 0.0);
  EXPECT_NEAR(of_rim / of_mouth, ratio, tolerance * ratio);
  EXPECT_NEAR(all.operation.glenn->incision.perimeter_ratio, ratio, tolerance * ratio);
  for (size_t k = 0; k < n; ++k)
    EXPECT_NEAR(mouth[k] / of_mouth * of_rim, rim[k], 1e-9 * of_rim / double(n)) << k;
  // Both tips of the incision are pairs.
  for (const Vec3& tip : all.operation.glenn->incision.ends)
    EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(),
                            [&](const auto& pair) {
                              return all.rpa.vessel.surface.points.row(pair[1]) == tip.transpose();
                            }),
              1);
  // No short edge and no thin triangle at the seam, and the binding is that of the moved vertices.
  for (const auto& [vessel, side] : {std::pair(&all.svc, 0), std::pair(&all.rpa, 1)}) {
    const TriangleSurface& surface = vessel->vessel.surface;
    std::vector<char> on_seam(index(surface.points.rows()), 0);
    for (const auto& pair : pairs) on_seam[index(pair[index(side)])] = 1;
    const double mean = mean_edge_length(surface);
    for (int t = 0; t < surface.triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = surface.triangles(t, k), b = surface.triangles(t, (k + 1) % 3),
                  c = surface.triangles(t, (k + 2) % 3);
        if (!on_seam[index(a)] && !on_seam[index(b)] && !on_seam[index(c)]) continue;
        EXPECT_GT(distance(*vessel, a, b), 0.05 * mean);
        const Vec3 ab = surface.points.row(b) - surface.points.row(a),
                   ac = surface.points.row(c) - surface.points.row(a);
        EXPECT_GT(std::atan2(ab.cross(ac).norm(), ab.dot(ac)) * 180 / M_PI, 5);
      }
    const Points bound =
        carried_points(vessel->vessel.rod, vessel->vessel.rod.rest, vessel->vessel.binding);
    EXPECT_LT((bound - surface.points).cwiseAbs().maxCoeff(), 1e-9);
  }
  return all;
}

TEST(GlennSeam, PairedSegmentsAreEqualOnTheBundledAnatomy) {
  for (const char* file : {"infant.yaml", "infant_short.yaml", "infant_long.yaml"})
    expect_equal_seam(file);
}

TEST(GlennSeam, ALongerOrShorterIncisionIsDividedInTheSameProportions) {
  for (const double length : {0.75, 1.25, 1.6})
    expect_equal_seam("infant.yaml", length, 2e-3,
                      [&](GlennSpec& spec) { spec.incision_length = length; });
}

// An ellipse without a length has a rim as long as the vein's mouth, up to the chords of its edges.
TEST(GlennSeam, AnEllipseIsDividedInTheSameProportions) {
  struct Case {
    double length, ratio, width;  // either a ratio or a width
  };
  for (const Case& c : {Case{1, 0.5, 0}, {1.25, 0.3, 0}, {1, 0, 4}}) {
    const auto all = expect_equal_seam("infant.yaml", c.length, 6e-3, [&](GlennSpec& spec) {
      spec.incision_length = c.length;
      spec.ellipse.emplace();
      if (c.width > 0)
        spec.ellipse->width = c.width;
      else
        spec.ellipse->ratio = c.ratio;
    });
    const auto& incision = all.operation.glenn->incision;
    EXPECT_EQ(incision.shape, "ellipse");
    if (c.width > 0)
      EXPECT_NEAR(incision.width, c.width, 0.02 * c.width);
    else
      EXPECT_NEAR(incision.width / incision.length, c.ratio, 0.02 * c.ratio);
    const double wanted = M_PI / 4 * incision.length * incision.width;
    EXPECT_NEAR(incision.removed_area / wanted, 1, 0.02);
    // Beside the mouth only what was taken out is missing, and the artery's ends are still its own.
    EXPECT_EQ(all.rpa.vessel.ends.size(), 3U);
    EXPECT_EQ(boundary_loops(all.rpa.vessel.surface.triangles).size(), 4U);
  }
}

std::string refusal(const std::function<void(GlennSpec&)>& change) {
  try {
    operated("infant.yaml", change);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// A tilted cut gives a longer mouth and with it a longer incision. Its plane lies on the artery's
// wall where that of the straight cut does, and the vein leans to the side to which the artery
// runs.
TEST(GlennSeam, ATiltedCutIsJoinedFlatAndLeansByItsTilt) {
  const auto tilted = [](double degrees) {
    return expect_equal_seam("infant.yaml", 1, 2e-3,
                             [&](GlennSpec& spec) { spec.cut_tilt_deg = degrees; });
  };
  const Operated straight = tilted(0);
  // Carried from rest to the join: the cut's normal and the vein's axis towards the mouth.
  const auto joined = [](const Operated& all, const Vec3& direction) -> Vec3 {
    const auto node = index(all.operation.vessels[0].rim_node);
    return all.operation.vessels[0].rod->poses[node].rotation *
           (all.svc.vessel.rod.rest[node].rotation.transpose() * direction);
  };
  const auto& before = *straight.operation.glenn;
  const Vec3 normal = joined(straight, before.cut.normal);
  const Vec3 along = (before.incision.ends[1] - before.incision.ends[0]).normalized();
  for (const double degrees : {30.0, -40.0}) {
    SCOPED_TRACE(degrees);
    const Operated all = tilted(degrees);
    const auto& report = *all.operation.glenn;
    EXPECT_EQ(report.cut.tilt_deg, degrees);
    EXPECT_EQ(report.join.rotation_deg, before.join.rotation_deg);
    EXPECT_EQ(report.cut.fraction, before.cut.fraction);
    EXPECT_NEAR(report.cut.normal.dot(before.cut.normal), std::cos(degrees * M_PI / 180), 1e-9);
    EXPECT_LT((joined(all, report.cut.normal) - normal).norm(), 1e-9);
    // The straight cut's normal is the vein's axis; its kept part leans towards `along`.
    const Vec3 axis = joined(all, before.cut.normal);
    EXPECT_NEAR(axis.dot(normal), std::cos(degrees * M_PI / 180), 1e-9);
    EXPECT_NEAR(-axis.dot(along), std::sin(degrees * M_PI / 180), 0.05);
    // The mouth of an about round vein: an ellipse with the semi-axes R and R / cos(tilt).
    const double tilt = std::abs(degrees) * M_PI / 180;
    const double exact = 2 / M_PI / std::cos(tilt) * std::comp_ellint_2(std::sin(tilt));
    EXPECT_NEAR(report.cut.perimeter / before.cut.perimeter, exact, 0.04);
    EXPECT_NEAR(report.incision.length / before.incision.length,
                report.cut.perimeter / before.cut.perimeter, 2e-3);
  }
}

TEST(GlennSeam, ATiltThatLeavesTheVeinIsRefusedWithASentence) {
  const std::string said = refusal([](GlennSpec& spec) {
    spec.cut = {-9.2, 2.7, 28};  // 3 mm below the kept end
    spec.cut_tilt_deg = 60;
  });
  EXPECT_NE(said.find("infant.yaml:"), std::string::npos) << said;
  EXPECT_NE(said.find(": cut_tilt_deg: found 60, expected at most "), std::string::npos) << said;
  EXPECT_NE(said.find("open end"), std::string::npos) << said;
}

TEST(GlennSeam, AnEllipseThatCannotBeIsRefusedWithASentence) {
  const auto says = [](double length, double width, const std::string& part) {
    const std::string said = refusal([&](GlennSpec& spec) {
      spec.ellipse.emplace();
      if (length > 0) spec.ellipse->length = length;
      spec.ellipse->width = width;
    });
    EXPECT_NE(said.find("infant.yaml:"), std::string::npos) << said;
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  says(9, 8,
       "incision_shape: found an ellipse 8 wide on the wall of pulmonary_artery, expected at "
       "most its diameter there, ");
  says(0, 7, "incision_shape: found an ellipse 7 wide whose rim is to be ");
  says(40, 5, "runs into ");
  says(40, 5, "expected one of at most ");
}

TEST(GlennSeam, PairedSegmentsAreEqualOnRealAnatomy) {
  expect_equal_seam("adult.yaml");
}

}  // namespace
}  // namespace vasorod
