#include "predict/joining_path.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "predict/vessel_wall.h"
#include "rod/binding.h"

namespace vasorod {
namespace {

// Over the vein's radius: how far the mouth is lifted off the incision, so that it comes down on
// the artery's wall from outside; and how far a vertex of its rim goes in one step.
constexpr double lift = 1, rim_step = 0.12;
constexpr int fewest_steps = 4;

// Unit, from the artery into the vein.
Vec3 into_vein(const RodTree& rod, const RodPoses& poses, int mouth) {
  const Pose& seat = poses[index(mouth)];
  for (const RodElement& element : rod.elements)
    if (element.first == mouth || element.second == mouth) {
      const int next = element.first == mouth ? element.second : element.first;
      const Vec3 along = poses[index(next)].position - seat.position;
      return (along.dot(seat.director(3)) < 0 ? -1 : 1) * seat.director(3);
    }
  return seat.director(3);
}

int steps_over(const Points& from, const Points& to, double radius) {
  const double way = (to - from).rowwise().norm().maxCoeff() / radius;
  return std::max(fewest_steps, static_cast<int>(std::ceil(way / rim_step)));
}

}  // namespace

JoiningPath::JoiningPath(const Prediction& prediction)
    : prediction_(prediction),
      vein_(vessel_named(prediction, prediction.operation->vessels[0].name)),
      artery_(vessel_named(prediction, prediction.operation->vessels[1].name)) {
  const PredictedVessel& vein = prediction.vessels[vein_];
  const RodTree& rod = vein.prepared.vessel.rod;
  const int mouth = prediction.operation->vessels[0].rim_node;
  const double radius = vein.prepared.vessel.mean_radius;
  Pose above = vein.rod.poses[index(mouth)];
  above.position += lift * radius * into_vein(rod, vein.rod.poses, mouth);
  RodConditions conditions = vein.conditions.rod;
  for (RodSupport& support : conditions.supports)
    if (support.node == mouth) support = clamp_at(rod, mouth, above);
  lifted_ = solve_rod(rod, conditions, {}, &vein.rod.poses).poses;
  const Points ready = rim(lifted_);
  const int approach = steps_over(rim(rod.rest), ready, radius),
            descent = steps_over(ready, incision(), radius);
  step_ = 1.0 / (approach + descent);
  lifted_at_ = approach * step_;
}

// The vertices of the mouth, and those that they are joined to, in the order of the pairs.
Points JoiningPath::rim(const RodPoses& poses) const {
  const Vessel& vein = prediction_.vessels[vein_].prepared.vessel;
  const Points carried = carried_points(vein.rod, poses, vein.carry);
  Points rim(static_cast<Eigen::Index>(prediction_.operation->pairs.size()), 3);
  for (Eigen::Index i = 0; i < rim.rows(); ++i)
    rim.row(i) = carried.row(prediction_.operation->pairs[index(i)][0]);
  return rim;
}

Points JoiningPath::incision() const {
  const Points& artery = prediction_.vessels[artery_].prepared.vessel.surface.points;
  Points edge(static_cast<Eigen::Index>(prediction_.operation->pairs.size()), 3);
  for (Eigen::Index i = 0; i < edge.rows(); ++i)
    edge.row(i) = artery.row(prediction_.operation->pairs[index(i)][1]);
  return edge;
}

RodPoses JoiningPath::vein(double t) const {
  const PredictedVessel& vein = prediction_.vessels[vein_];
  RodTree from = vein.prepared.vessel.rod;
  if (t <= lifted_at_) return share_of_strain(from, lifted_, t / lifted_at_);
  from.rest = lifted_;
  return share_of_strain(from, vein.rod.poses, (t - lifted_at_) / (1 - lifted_at_));
}

std::vector<Vec3> JoiningPath::offsets(double t) const {
  const double share = t <= lifted_at_ ? 1 : (1 - t) / (1 - lifted_at_);
  const Points apart = share * (rim(vein(t)) - incision());
  std::vector<Vec3> offsets;
  for (Eigen::Index i = 0; i < apart.rows(); ++i) offsets.emplace_back(apart.row(i));
  return offsets;
}

}  // namespace vasorod
