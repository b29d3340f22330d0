#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "judge/metrics.h"

namespace vasorod {
namespace {

using shapes::change_of;
using shapes::judged_tube;
using shapes::strained;

VesselMetrics judged(const PreparedVessel& tube, const RodPoses& poses, const Points& current) {
  return vessel_metrics(tube, poses, vertex_fields(tube, poses), current, {},
                        judged_sections(tube, poses, current));
}

TEST(Metrics, RestIsUnstretchedUntwistedAndRound) {
  const PreparedVessel tube = judged_tube();
  const VesselMetrics metrics = judged(tube, tube.vessel.rod.rest, tube.vessel.surface.points);
  EXPECT_NEAR(metrics.largest_twist_shear, 0, 1e-12);
  EXPECT_NEAR(metrics.stretch[0], 1, 1e-12);
  EXPECT_NEAR(metrics.stretch[1], 1, 1e-12);
  EXPECT_NEAR(metrics.flattening, 0, 1e-12);
  EXPECT_NEAR(metrics.smallest_lumen_ratio, 1, 1e-12);
}

TEST(Metrics, TwistShearIsRadiusTimesTwist) {
  const PreparedVessel tube = judged_tube();
  const RodPoses poses = strained(tube.vessel.rod, change_of(0, Vec3(0, 0, 0.013)));
  const VertexFields fields = vertex_fields(tube, poses);
  EXPECT_LT((fields.twist_shear.array() - 0.13).abs().maxCoeff(), 1e-10);
  EXPECT_LT((fields.axial_stretch.array() - 1).abs().maxCoeff(), 1e-10);
}

TEST(Metrics, BendingStretchesTheOuterFibres) {
  const PreparedVessel tube = judged_tube();
  const double k = 0.02, stretch = 0.05;
  const RodPoses poses = strained(tube.vessel.rod, change_of(stretch, Vec3(0, k, 0)));
  const VertexFields fields = vertex_fields(tube, poses);
  for (size_t i = 0; i < tube.vessel.binding.size();
       ++i)  // turning towards +d1 shortens what lies there
    EXPECT_NEAR(fields.axial_stretch[static_cast<Eigen::Index>(i)],
                1 + stretch - k * tube.vessel.binding[i].local.x(), 1e-9);
  const Points carried = carried_points(tube.vessel.rod, poses, tube.vessel.binding);
  const VesselMetrics metrics = judged(tube, poses, carried);
  EXPECT_NEAR(metrics.largest_curvature, k, 1e-9);
  EXPECT_NEAR(metrics.stretch[0], 1 + stretch, 1e-9);
  EXPECT_NEAR(metrics.stretch[1], 1 + stretch, 1e-9);
}

// Sections squeezed to ellipses with semi-axes 8 and 11: width 16 of 20, lumen by Steiner's formula
// for the perimeter.
TEST(Metrics, SqueezedSectionsFlattenAndNarrow) {
  const PreparedVessel tube = judged_tube();
  Points squeezed = tube.vessel.surface.points;
  squeezed.col(0) *= 0.8;
  squeezed.col(1) *= 1.1;
  const VesselMetrics metrics = judged(tube, tube.vessel.rod.rest, squeezed);
  double perimeter = 0;
  constexpr int n = 4096;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * M_PI * (k + 0.5) / n;
    perimeter += std::hypot(8 * std::sin(a), 11 * std::cos(a)) * 2 * M_PI / n;
  }
  const double lumen = M_PI * 8 * 11 - 0.5 * perimeter + M_PI * 0.25;
  EXPECT_NEAR(metrics.flattening, 0.2, 1e-12);
  EXPECT_NEAR(metrics.smallest_lumen_ratio, lumen / (M_PI * 9.5 * 9.5), 2e-3);
  EXPECT_TRUE(metrics.where.contains("flattening"));
}

// An irregular surface: no two sections have vertices at the same angles, and no section has
// vertices on a diameter.
TEST(Metrics, SqueezedSectionsOfAnIrregularMeshFlattenAsMuch) {
  PreparedVessel tube = judged_tube();
  Points& rest = tube.vessel.surface.points;
  for (Eigen::Index i = 0; i < rest.rows(); ++i) {
    const double shift = std::sin(12.9898 * static_cast<double>(i)) * 0.25 * 2 * M_PI / 48;
    const Vec3 p = rest.row(i);
    rest.row(i) << p.x() * std::cos(shift) - p.y() * std::sin(shift),
        p.x() * std::sin(shift) + p.y() * std::cos(shift), p.z();
  }
  Points squeezed = rest;
  squeezed.col(0) *= 0.99;
  EXPECT_NEAR(judged(tube, tube.vessel.rod.rest, squeezed).flattening, 0.01, 1e-12);
}

TEST(Metrics, PressureGivesContactArea) {
  const PreparedVessel tube = judged_tube();
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(tube.vessel.surface.points.rows());
  pressure[2000] = 0.01;
  const VesselMetrics metrics =
      vessel_metrics(tube, tube.vessel.rod.rest, vertex_fields(tube, tube.vessel.rod.rest),
                     tube.vessel.surface.points, pressure, {});
  EXPECT_EQ(metrics.largest_pressure, 0.01);
  ASSERT_TRUE(metrics.contact_area);
  EXPECT_NEAR(*metrics.contact_area, 2 * M_PI * 10 * 100 / (48 * 80),
              0.01 * 1.64);  // one vertex of 48 x 80 equal ones
  EXPECT_EQ(
      (metrics.where.at("largest_pressure") - Vec3(tube.vessel.surface.points.row(2000))).norm(),
      0);
}

TEST(Metrics, WhereContactIsNotModelledThereIsNoPressureAndWhereNothingTouchesItIsZero) {
  const PreparedVessel tube = judged_tube();
  const auto metrics = [&](const Eigen::VectorXd& pressure) {
    return vessel_metrics(tube, tube.vessel.rod.rest, vertex_fields(tube, tube.vessel.rod.rest),
                          tube.vessel.surface.points, pressure, {});
  };
  const VesselMetrics without = metrics({});
  EXPECT_FALSE(without.largest_pressure);
  EXPECT_FALSE(without.contact_area);
  const VesselMetrics apart = metrics(Eigen::VectorXd::Zero(tube.vessel.surface.points.rows()));
  EXPECT_EQ(apart.largest_pressure, 0);
  EXPECT_EQ(apart.contact_area, 0);
  EXPECT_FALSE(apart.where.contains("largest_pressure"));
}

}  // namespace
}  // namespace vasorod
