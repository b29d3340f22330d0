#include "reference_fem/tube_result.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.h"

namespace vasorod::fem {
namespace {

/// The section's pose: the rotation that takes the rest ring closest to the current one.
Pose ring_pose(const Points& rest, const Points& current, const Pose& frame) {
  const Eigen::RowVector3d X0 = rest.colwise().mean(), c = current.colwise().mean();
  const Mat3 moment = (current.rowwise() - c).transpose() * (rest.rowwise() - X0);
  const Eigen::JacobiSVD<Mat3> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 sign = Vec3::Ones();
  sign[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0
                ? -1
                : 1;  // the ring is flat: third is free
  return {svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose() * frame.rotation,
          c.transpose()};
}

double lumen(const Points& ring, const Pose& pose, double thickness) {
  double area = 0, around = 0;
  const Eigen::Index n = ring.rows();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec3 a = pose.inverse() * Vec3(ring.row(i)),
               b = pose.inverse() * Vec3(ring.row((i + 1) % n));
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    around += (b - a).norm();
  }
  return area - around * thickness / 2 + std::numbers::pi * thickness * thickness / 4;
}

double station_fraction(const MidWall& wall, int station) {
  return static_cast<double>(station) / (wall.along - 1);
}

}  // namespace

VesselResult vessel_result(const TubeProblem& problem, const MidWall& wall) {
  const double unit = problem.length_unit;
  const int n = wall.around, m = wall.along;
  VesselResult vessel;
  vessel.name = problem.vessel;
  vessel.rest = unit * wall.rest;
  vessel.current = unit * wall.current;
  vessel.triangles.resize(2 * n * (m - 1), 3);
  for (int j = 0; j + 1 < m; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n;
      vessel.triangles.row(2 * a) << a, b, a + n;
      vessel.triangles.row(2 * a + 1) << b, b + n, a + n;
    }

  CenterlineResult line;
  line.rest.resize(m, 3);
  line.current.resize(m, 3);
  line.lines.emplace_back();
  std::vector<Pose> rest, current;
  for (int j = 0; j < m; ++j) {
    const double s = station_fraction(wall, j);
    rest.push_back(problem.shape.section(s));
    current.push_back(
        ring_pose(wall.rest.middleRows(j * n, n), wall.current.middleRows(j * n, n), rest.back()));
    line.rest.row(j) = unit * rest.back().position;
    line.current.row(j) = unit * current.back().position;
    line.directors.push_back(current.back().rotation);
    line.abscissa.push_back(unit * s * problem.shape.length);
    line.radius.push_back(unit * problem.shape.radius_at(s));
    line.lines.front().push_back(j);
  }
  const double step = problem.shape.length / (m - 1);
  const auto strains = [&](const std::vector<Pose>& pose, std::vector<Vec3>& u,
                           std::vector<Vec3>& v) {
    std::vector<Vec6> element;
    for (int j = 0; j + 1 < m; ++j) {
      const auto k = static_cast<std::size_t>(j);
      element.push_back(log_motion(pose[k].inverse() * pose[k + 1]) / step);
    }
    for (int j = 0; j < m; ++j) {
      const auto before = static_cast<std::size_t>(std::max(j - 1, 0)),
                 after = static_cast<std::size_t>(std::min(j, m - 2));
      const Vec6 mean = 0.5 * (element[before] + element[after]);
      v.push_back(mean.head<3>());
      u.push_back(mean.tail<3>() / unit);
    }
  };
  strains(rest, line.u0, line.v0);
  strains(current, line.u, line.v);

  vessel.axial_stretch.resize(n * m);
  vessel.twist_shear.resize(n * m);
  for (int j = 0; j < m; ++j) {
    const auto k = static_cast<std::size_t>(j);
    vessel.axial_stretch.segment(j * n, n).setConstant(line.v[k][2]);
    vessel.twist_shear.segment(j * n, n).setConstant((line.u[k][2] - line.u0[k][2]) *
                                                     line.radius[k]);
  }
  vessel.centerline = std::move(line);
  return vessel;
}

VesselMetrics vessel_metrics(const TubeProblem& problem, const MidWall& wall,
                             const VesselResult& vessel) {
  const CenterlineResult& line = *vessel.centerline;
  VesselMetrics metrics;
  metrics.vessel = problem.vessel;
  metrics.stretch = {1e300, -1e300};
  metrics.smallest_lumen_ratio = 1e300;
  const int n = wall.around;
  for (int j = 0; j < wall.along; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const Vec3 at = line.current.row(j);
    const auto record = [&](const char* name, double value, double& kept, bool better) {
      if (!better) return;
      kept = value;
      metrics.where[name] = at;
    };
    const Points ring = wall.current.middleRows(j * n, n), rest = wall.rest.middleRows(j * n, n);
    for (int i = 0; i < n / 2; ++i) {
      const double flat = 1 - (ring.row(i) - ring.row(i + n / 2)).norm() /
                                  (rest.row(i) - rest.row(i + n / 2)).norm();
      record("flattening", flat, metrics.flattening, flat > metrics.flattening);
    }
    const double twist = std::abs(line.u[k][2] - line.u0[k][2]) * line.radius[k];
    record("largest_twist_shear", twist, metrics.largest_twist_shear,
           twist > metrics.largest_twist_shear);
    const double bend = line.u[k].head<2>().norm();
    record("largest_curvature", bend, metrics.largest_curvature, bend > metrics.largest_curvature);
    metrics.stretch[0] = std::min(metrics.stretch[0], line.v[k][2]);
    metrics.stretch[1] = std::max(metrics.stretch[1], line.v[k][2]);
    const double s = station_fraction(wall, j), t = problem.shape.thickness_at(s);
    const Pose frame = problem.shape.section(s);
    const Pose pose{line.directors[k], line.current.row(j).transpose() / problem.length_unit};
    const double ratio = lumen(ring, pose, t) / lumen(rest, frame, t);
    record("smallest_lumen_ratio", ratio, metrics.smallest_lumen_ratio,
           ratio < metrics.smallest_lumen_ratio);
  }
  return metrics;
}

}  // namespace vasorod::fem
