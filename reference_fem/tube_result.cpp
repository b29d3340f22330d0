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
  const Mat3 turn = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  // a ring beside a hole does not have its mean on the axis
  const Vec3 off_mean = frame.position - X0.transpose();
  return {turn * frame.rotation, c.transpose() + turn * off_mean};
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

}  // namespace

VesselResult vessel_result(const std::string& name, const TubeShape& shape, double unit,
                           const MidWall& wall) {
  const int n = wall.around, m = wall.along;
  VesselResult vessel;
  vessel.name = name;
  const Eigen::Index grid = wall.rest.rows(), lips = wall.other_lip_rest.rows();
  vessel.rest.resize(grid + lips, 3);
  vessel.rest << unit * wall.rest, unit * wall.other_lip_rest;
  vessel.current.resize(grid + lips, 3);
  vessel.current << unit * wall.current, unit * wall.other_lip_current;
  std::vector<int> last;  // per station: the point after the last one
  for (int j = 0, lip = 0; j < m; ++j)
    last.push_back(wall.open_at(j) ? static_cast<int>(grid) + lip++ : j * n);
  vessel.triangles.resize(2 * n * (m - 1), 3);
  for (int j = 0; j + 1 < m; ++j)
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(j);
      const int a = j * n + i, b = i + 1 < n ? a + 1 : last[k],
                c = i + 1 < n ? a + 1 + n : last[k + 1];
      vessel.triangles.row(2 * a) << a, b, a + n;
      vessel.triangles.row(2 * a + 1) << b, c, a + n;
    }

  CenterlineResult line;
  line.rest.resize(m, 3);
  line.current.resize(m, 3);
  line.lines.emplace_back();
  std::vector<Pose> rest, current;
  for (int j = 0; j < m; ++j) {
    const double s = wall.fraction[static_cast<std::size_t>(j)];
    rest.push_back(shape.section(s));
    current.push_back(
        ring_pose(wall.rest.middleRows(j * n, n), wall.current.middleRows(j * n, n), rest.back()));
    line.rest.row(j) = unit * rest.back().position;
    line.current.row(j) = unit * current.back().position;
    line.directors.push_back(current.back().rotation);
    line.abscissa.push_back(unit * s * shape.length);
    line.radius.push_back(unit * shape.radius_at(s));
    line.lines.front().push_back(j);
  }
  const auto strains = [&](const std::vector<Pose>& pose, std::vector<Vec3>& u,
                           std::vector<Vec3>& v) {
    std::vector<Vec6> element;
    for (int j = 0; j + 1 < m; ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double step = shape.length * (wall.fraction[k + 1] - wall.fraction[k]);
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

  vessel.axial_stretch.resize(grid + lips);
  vessel.twist_shear.resize(grid + lips);
  for (int j = 0; j < m; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double twist = (line.u[k][2] - line.u0[k][2]) * line.radius[k];
    vessel.axial_stretch.segment(j * n, n).setConstant(line.v[k][2]);
    vessel.twist_shear.segment(j * n, n).setConstant(twist);
    if (!wall.open_at(j)) continue;
    vessel.axial_stretch[last[k]] = line.v[k][2];
    vessel.twist_shear[last[k]] = twist;
  }
  vessel.centerline = std::move(line);
  return vessel;
}

VesselMetrics vessel_metrics(const TubeShape& shape, double unit, const MidWall& wall,
                             const VesselResult& vessel) {
  const CenterlineResult& line = *vessel.centerline;
  VesselMetrics metrics;
  metrics.vessel = vessel.name;
  metrics.stretch = {1e300, -1e300};
  metrics.smallest_lumen_ratio = 1e300;
  const int n = wall.around;
  for (int j = 0; j < wall.along; ++j) {
    if (wall.open_at(j)) continue;
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
    const double s = wall.fraction[k], t = shape.thickness_at(s);
    const Pose frame = shape.section(s);
    const Pose pose{line.directors[k], line.current.row(j).transpose() / unit};
    const double ratio = lumen(ring, pose, t) / lumen(rest, frame, t);
    record("smallest_lumen_ratio", ratio, metrics.smallest_lumen_ratio,
           ratio < metrics.smallest_lumen_ratio);
  }
  return metrics;
}

}  // namespace vasorod::fem
