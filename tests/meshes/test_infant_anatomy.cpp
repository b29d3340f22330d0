// The bundled infant anatomy: checks what the scenes in benchmarks/cases/glenn and the README state
// about it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include <vasorod/read_scene.h>

#include "geometry/closest_point.h"
#include "geometry/crossing_triangles.h"
#include "geometry/plane_section.h"
#include "geometry/triangle_surface.h"
#include "surface_file/read_surface.h"

namespace vasorod {
namespace {

const Scene& scene() {
  static const Scene result = read_scene(VASOROD_SOURCE_DIR "/benchmarks/cases/glenn/infant.yaml");
  return result;
}

const TriangleSurface& part(const std::string& name) {
  static std::map<std::string, TriangleSurface> loaded;
  const auto found = loaded.find(name);
  if (found != loaded.end()) return found->second;
  return loaded[name] = load_surface(scene().vessel(name), scene()).surface;
}

// Equivalent radius (circle of equal area) of the section nearest to `point`, perpendicular to
// `direction`.
double radius_at(const std::string& name, const Vec3& point, const Vec3& direction) {
  const auto loops = plane_sections(part(name), point, direction.normalized());
  const int around = section_around(loops, point, direction.normalized());
  EXPECT_GE(around, 0) << name;
  return std::sqrt(section_area(loops.at(static_cast<std::size_t>(around))) / M_PI);
}

struct Expected {
  const char* name;
  int vertices, ends;
};

class InfantPart : public ::testing::TestWithParam<Expected> {};

TEST_P(InfantPart, HasThePapersSizeAndCleanTopology) {
  const auto& [name, vertices, ends] = GetParam();
  const TriangleSurface& surface = part(name);
  EXPECT_NEAR(static_cast<double>(surface.points.rows()), vertices, 0.05 * vertices);
  EXPECT_EQ(static_cast<int>(boundary_loops(surface.triangles).size()), ends);
  EXPECT_EQ(euler_number(surface.triangles), 2 - ends);  // a sphere with that many holes
  const auto component = components(surface.triangles, static_cast<int>(surface.points.rows()));
  EXPECT_EQ(*std::max_element(component.begin(), component.end()), 0);
  EXPECT_EQ(*std::min_element(component.begin(), component.end()), 0);  // no unused point
}

TEST_P(InfantPart, NeedsNoRepair) {
  const LoadedSurface loaded = load_surface(scene().vessel(GetParam().name), scene());
  EXPECT_TRUE(loaded.report.lines().empty()) << loaded.report.text();
}

TEST_P(InfantPart, DoesNotCrossItself) {
  EXPECT_TRUE(self_intersections(part(GetParam().name)).empty());
}

TEST_P(InfantPart, HasNearEquilateralTriangles) {
  const TriangleSurface& surface = part(GetParam().name);
  double smallest = M_PI;
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = surface.points.row(surface.triangles(t, k));
      const Vec3 a = surface.points.row(surface.triangles(t, (k + 1) % 3)).transpose() - p;
      const Vec3 b = surface.points.row(surface.triangles(t, (k + 2) % 3)).transpose() - p;
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  EXPECT_GT(smallest * 180 / M_PI, 30);
}

TEST_P(InfantPart, EndsArePlanarCircles) {
  const TriangleSurface& surface = part(GetParam().name);
  for (const auto& loop : boundary_loops(surface.triangles)) {
    const Vec3 normal = area_vector(surface.points, loop).normalized();
    Vec3 center = Vec3::Zero();
    for (const int v : loop)
      center += surface.points.row(v).transpose() / static_cast<double>(loop.size());
    const double radius = perimeter(surface.points, loop) / (2 * M_PI);
    for (const int v : loop) {
      const Vec3 arm = surface.points.row(v).transpose() - center;
      EXPECT_LT(std::abs(arm.dot(normal)), 1e-6);
      EXPECT_NEAR(arm.norm(), radius, 0.01 * radius);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, InfantPart,
                         ::testing::Values(Expected{"svc", 5600, 2},
                                           Expected{"pulmonary_artery", 9800, 3},
                                           Expected{"aorta", 9000, 5}, Expected{"heart", 2434, 0}),
                         [](const auto& made) { return std::string(made.param.name); });

TEST(InfantAnatomy, NeighboursLieApartAsInAChest) {
  const char* names[] = {"svc", "pulmonary_artery", "aorta", "heart"};
  std::map<std::string, double> gap;
  for (int i = 0; i < 4; ++i) {
    const ClosestPoint closest(part(names[i]));
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      const auto& points = part(names[j]).points;
      double smallest = 1e9;
      for (int v = 0; v < points.rows(); ++v) {
        const auto hit = closest.query(points.row(v));
        smallest =
            std::min(smallest, hit.on_boundary ? (points.row(v).transpose() - hit.point).norm()
                                               : hit.signed_distance);
      }
      EXPECT_GT(smallest, 0.4) << names[j] << " from " << names[i];
      const std::string pair = std::string(names[std::min(i, j)]) + "-" + names[std::max(i, j)];
      const auto known = gap.find(pair);
      gap[pair] = known == gap.end() ? smallest : std::min(known->second, smallest);
    }
  }
  for (const char* neighbours : {"svc-aorta", "svc-pulmonary_artery", "pulmonary_artery-aorta"}) {
    EXPECT_LT(gap.at(neighbours), 2.0) << neighbours;
  }
}

TEST(InfantAnatomy, RadiiAreThoseOfAnInfant) {
  EXPECT_NEAR(radius_at("svc", {-10.3, 1.3, 16}, {0, 0, 1}), 3.3, 0.1);
  EXPECT_NEAR(radius_at("aorta", {-0.6, 0.2, 2}, {-0.15, 0.2, 1}), 5.0, 0.15);
  EXPECT_NEAR(radius_at("aorta", {9.8, 21.2, 2}, {0, 0.1, -1}), 3.7, 0.15);
  EXPECT_NEAR(radius_at("pulmonary_artery", {-5, 9.5, -0.2}, {-1, 0, -0.2}), 3.3, 0.15);
  EXPECT_NEAR(radius_at("pulmonary_artery", {11.6, -6, -6.5}, {0.15, 0.7, 0.65}), 5.0, 0.2);
}

}  // namespace
}  // namespace vasorod
