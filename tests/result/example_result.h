// A hand-made result: a tube twisted, bent and stretched by a formula, beside an obstacle.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <vasorod/result.h>

namespace vasorod::test {

/// An open tube along +z, points (around * (along + 1)), row by row from z = 0.
inline TriangleSurface tube(double radius, double length, int around, int along,
                            const Vec3& at = Vec3::Zero()) {
  TriangleSurface surface;
  surface.points.resize(around * (along + 1), 3);
  surface.triangles.resize(2 * around * along, 3);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * M_PI * (i + 0.5 * (j % 2)) / around;
      surface.points.row(j * around + i) =
          (at + Vec3(radius * std::cos(angle), radius * std::sin(angle), length * j / along))
              .transpose();
    }
  for (int j = 0, t = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = a + around,
                d = b + around;
      if (j % 2 == 0) {
        surface.triangles.row(t++) << a, b, c;
        surface.triangles.row(t++) << b, d, c;
      } else {
        surface.triangles.row(t++) << a, b, d;
        surface.triangles.row(t++) << a, d, c;
      }
    }
  return surface;
}

/// Bends a point of a tube along z to an arc of curvature k in the x z plane, after a twist of rate
/// w and a stretch v.
inline Vec3 deformed(const Vec3& p, double k, double w, double v) {
  const double s = v * p.z(), c = std::cos(w * p.z()), n = std::sin(w * p.z());
  const double x = c * p.x() - n * p.y(), y = n * p.x() + c * p.y();
  return {(1 - std::cos(k * s)) / k + x * std::cos(k * s), y, (1 / k - x) * std::sin(k * s)};
}

inline CenterlineResult centerline(double radius, double length, int nodes, double k, double w,
                                   double v) {
  CenterlineResult line;
  line.rest.resize(nodes, 3);
  line.current.resize(nodes, 3);
  line.lines.resize(1);
  for (int i = 0; i < nodes; ++i) {
    const Vec3 rest(0, 0, length * i / (nodes - 1));
    const Vec3 at = deformed(rest, k, w, v);
    line.rest.row(i) = rest.transpose();
    line.current.row(i) = at.transpose();
    line.abscissa.push_back(rest.z());
    line.radius.push_back(radius);
    Mat3 frame;
    frame.col(0) = deformed(rest + Vec3::UnitX(), k, w, v) - at;
    frame.col(1) = deformed(rest + Vec3::UnitY(), k, w, v) - at;
    frame.col(2) = frame.col(0).cross(frame.col(1));
    line.directors.push_back(frame);
    line.u.emplace_back(k * v * std::sin(w * rest.z()), k * v * std::cos(w * rest.z()), w);
    line.v.emplace_back(0, 0, v);
    line.u0.emplace_back(0, 0, 0);
    line.v0.emplace_back(0, 0, 1);
    line.lines[0].push_back(i);
  }
  return line;
}

inline VesselResult deformed_tube(int around, int along) {
  const double radius = 5, length = 60, k = 0.02, w = 0.01, v = 1.1;
  const TriangleSurface rest = tube(radius, length, around, along);
  VesselResult vessel;
  vessel.name = "svc";
  vessel.rest = rest.points;
  vessel.triangles = rest.triangles;
  vessel.current.resize(rest.points.rows(), 3);
  const auto n = rest.points.rows();
  vessel.axial_stretch.resize(n);
  vessel.twist_shear.resize(n);
  vessel.contact_pressure.resize(n);
  NamedArray face{"ModelFaceID", {}, true, {}};
  face.values.resize(rest.triangles.rows(), 1);
  for (Eigen::Index i = 0; i < face.values.rows(); ++i)
    face.values(i, 0) = static_cast<double>(i % 3);
  NamedArray thickness{"Thickness", {}, false, "Float32"};
  thickness.values.resize(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec3 p = rest.points.row(i).transpose();
    vessel.current.row(i) = deformed(p, k, w, v).transpose();
    vessel.axial_stretch[i] = v * (1 - k * p.x());
    vessel.twist_shear[i] = w * radius * p.z() / length;
    vessel.contact_pressure[i] = std::max(0.0, 1e-3 * (1 - (p - Vec3(5, 0, 30)).norm() / 10));
    thickness.values(i, 0) = 0.5;
  }
  vessel.cell_arrays = {face};
  vessel.point_arrays = {thickness};
  vessel.centerline = centerline(radius, length, 31, k, w, v);
  vessel.stump = tube(4, 3, 12, 1, Vec3(0, 0, -10));
  return vessel;
}

inline VesselResult obstacle(int around, int along) {
  const TriangleSurface rest = tube(8, 50, around, along, Vec3(-14, 3, 5));
  VesselResult vessel;
  vessel.name = "aorta";
  vessel.obstacle = true;
  vessel.rest = vessel.current = rest.points;
  vessel.triangles = rest.triangles;
  return vessel;
}

inline Result example_result(int around = 24, int along = 30) {
  Result r;
  r.scene = "example";
  r.program = "vasorod 0.1.0";
  r.fidelity = "skin";
  r.certificate = {1.0 / 3.0, std::nullopt, {"the surface's curvature was not asked for"}};
  r.validity = {.in_range = false,
                .brazier_ratio = 0.1,
                .wrinkling_ratio = 0.15,
                .twist_ratio = 0.2,
                .largest_strain = 0.3,
                .warnings = {"svc bends to 0.95 of the curvature where a tube kinks."}};
  r.energy = {1.1, 2.2, 3.3, 4.4, 5.5, 6.6};
  r.ends = {{"svc", "start", {0.1, 0.2, 0.3}, {1e-300, -0.0, 1e17}, {1, 2, 3}}};
  Balance balance{"svc", {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, 1e-9, {}, {}};
  balance.binding = Vec3(0.5, 0.25, 0.125);
  r.balance = {balance};
  r.contact = {{"svc", "aorta", {0.1, 0, 0}, 2.5, 1e-3, -0.02}};
  VesselMetrics metrics;
  metrics.vessel = "svc";
  metrics.flattening = 0.05;
  metrics.largest_twist_shear = 0.05;
  metrics.stretch = {0.99, 1.21};
  metrics.largest_curvature = 0.022;
  metrics.smallest_lumen_ratio = 0.9;
  metrics.largest_pressure = 1e-3;
  metrics.contact_area = 2.5;
  metrics.where["flattening"] = {1, 2, 3};
  r.metrics = {metrics};
  r.model = {31,
             744,
             1440,
             {"bending", "binding"},
             {{"contact of heart", "no vessel within reach"}},
             {{"svc", "2 points joined"}}};
  r.seconds = {{"read", 0.1}, {"fit", 0.2}, {"factor", 0.3}, {"solve", 0.4}, {"total", 1.0}};
  r.iterations = {{"rod", 7}, {"surface", 42}};
  r.counts = {3, 40, 50, 5, 6, 7000000000};
  r.environment = {"openblas", 1, {{"svc.vtp", "sha256:00ff"}}, {}};
  GlennReport glenn;
  glenn.svc = "svc";
  glenn.rpa = "rpa";
  glenn.cut.pick = {1.5, 2, 3};
  glenn.cut.fraction = 0.4;
  glenn.cut.perimeter = 31.4;
  glenn.cut.point = {1, 2, 3};
  glenn.cut.normal = {0, 0, 1};
  glenn.incision.pick = {0.5, 0.5, 0};
  glenn.incision.along = 0.25;
  glenn.incision.around_deg = -30;
  glenn.incision.length = 15.7;
  glenn.incision.ends = {Vec3(1, 0, 0), Vec3(0, 1, 0)};
  glenn.incision.opened_area = 3.5;
  glenn.join.pairs = 48;
  glenn.join.rotation_deg = -12.5;
  glenn.join.largest_gap = 0.01;
  glenn.join.rms_gap = 0.005;
  r.glenn = glenn;
  r.vessels = {deformed_tube(around, along), obstacle(2 * around, along)};
  for (const char* title : {"rest", "cut", "incision", "result"}) {
    Stage stage{title, {}, {}};
    for (const VesselResult& vessel : r.vessels) {
      const bool last = stage.title == "result";
      stage.surfaces.push_back({last ? vessel.current : vessel.rest, vessel.triangles});
      stage.names.push_back(vessel.name);
    }
    r.stages.push_back(stage);
  }
  return r;
}

/// A temporary folder for one test, removed with its contents.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "vasorod-test-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path path;
};

}  // namespace vasorod::test
