// The seam of the operation on the bundled anatomy and on real vessels: what the solvers start
// from.
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include <vasorod/read_scene.h>

#include "data/index.h"
#include "rod/binding.h"
#include "surgery/glenn.h"
#include "surgery/surface_checks.h"

namespace vasorod {
namespace {

struct Operated {
  PreparedVessel svc, rpa;
  GlennOperation operation;
};

Operated operated(const std::string& file, double incision_length = 1) {
  Scene scene =
      read_scene(std::filesystem::path(VASOROD_SOURCE_DIR) / "benchmarks/cases/glenn" / file);
  scene.glenn->incision_length = incision_length;
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

void expect_equal_seam(const std::string& file, double incision_length = 1) {
  SCOPED_TRACE(file);
  const Operated all = operated(file, incision_length);
  const auto& pairs = all.operation.pairs;
  const size_t n = pairs.size();
  std::vector<double> mouth, rim;
  for (size_t k = 0; k < n; ++k) {
    mouth.push_back(distance(all.svc, pairs[k][0], pairs[(k + 1) % n][0]));
    rim.push_back(distance(all.rpa, pairs[k][1], pairs[(k + 1) % n][1]));
  }
  const double of_mouth = std::accumulate(mouth.begin(), mouth.end(), 0.0),
               of_rim = std::accumulate(rim.begin(), rim.end(), 0.0);
  EXPECT_NEAR(of_rim / of_mouth, incision_length, 2e-3 * incision_length);
  for (size_t k = 0; k < n; ++k)
    EXPECT_NEAR(mouth[k] / of_mouth * of_rim, rim[k], 1e-9 * of_rim / double(n)) << k;
  // Both tips of the incision are pairs.
  for (const Vec3& tip : all.operation.report.incision.ends)
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
}

TEST(GlennSeam, PairedSegmentsAreEqualOnTheBundledAnatomy) {
  for (const char* file : {"infant.yaml", "infant_short.yaml", "infant_long.yaml"})
    expect_equal_seam(file);
}

TEST(GlennSeam, ALongerOrShorterIncisionIsDividedInTheSameProportions) {
  for (const double length : {0.75, 1.25, 1.6}) expect_equal_seam("infant.yaml", length);
}

TEST(GlennSeam, PairedSegmentsAreEqualOnRealAnatomy) {
  expect_equal_seam("adult.yaml");
}

}  // namespace
}  // namespace vasorod
