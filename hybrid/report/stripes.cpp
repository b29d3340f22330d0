#include "report/stripes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "data/index.h"

namespace vasorod {

namespace {

// At each node of the centerline at rest the direction from which angles are counted, and the
// tangent.
struct Frame {
  Vec3 start = Vec3::Zero(), tangent = Vec3::UnitZ();
};

std::vector<Frame> frames_of(const CenterlineResult& line) {
  std::vector<Frame> frames(index(line.rest.rows()));
  for (const std::vector<int>& run : line.lines) {
    for (std::size_t k = 0; k < run.size(); ++k) {
      const int before = run[k > 0 ? k - 1 : 0], after = run[std::min(k + 1, run.size() - 1)];
      const Vec3 along = line.rest.row(after) - line.rest.row(before);
      Frame& frame = frames[index(run[k])];
      if (along.norm() > 0) frame.tangent = along.normalized();
      const Frame& former = frames[index(run[k > 0 ? k - 1 : 0])];
      frame.start = k == 0
                        ? frame.tangent.unitOrthogonal()
                        : Vec3(Eigen::Quaterniond::FromTwoVectors(former.tangent, frame.tangent) *
                               former.start);
    }
  }
  return frames;
}

}  // namespace

Eigen::VectorXd stripes(const VesselResult& vessel, int count) {
  if (!vessel.centerline || vessel.rest.rows() == 0) return {};
  const CenterlineResult& line = *vessel.centerline;
  const std::vector<Frame> frames = frames_of(line);
  Eigen::VectorXd values(vessel.rest.rows());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    Eigen::Index nearest = 0;
    (line.rest.rowwise() - vessel.rest.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
    const Frame& frame = frames[index(nearest)];
    const Vec3 spoke = (vessel.rest.row(i) - line.rest.row(nearest)).transpose();
    const double turn =
        std::atan2(spoke.dot(frame.tangent.cross(frame.start)), spoke.dot(frame.start)) /
        (2 * M_PI);
    values[i] = std::clamp(0.5 + std::sin(2 * M_PI * count * turn), 0.0, 1.0);
  }
  return values;
}

}  // namespace vasorod
