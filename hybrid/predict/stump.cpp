#include "predict/stump.h"

#include <algorithm>

#include "bodies/reach.h"
#include "data/index.h"
#include "data/part_names.h"
#include "geometry/closest_point.h"

namespace vasorod {
namespace {

constexpr double drawn_through = 0.5;  // over the vein's radius

// Length.
double reach_into(const TriangleSurface& stump, const Points& points) {
  const ClosestPoint finder(stump);
  const Box box = box_of(stump.points);
  double deepest = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 point = points.row(i);
    if (!box.contains(point)) continue;
    const ClosestPoint::Hit hit = finder.query(point);
    if (!hit.on_boundary) deepest = std::max(deepest, -hit.signed_distance);
  }
  return deepest;
}

Points axis_of(const RodPoses& poses) {
  Points axis(static_cast<Eigen::Index>(poses.size()), 3);
  for (Eigen::Index i = 0; i < axis.rows(); ++i) axis.row(i) = poses[index(i)].position;
  return axis;
}

}  // namespace

void add_stump(Prediction& prediction) {
  const OperatedVessel& joined = prediction.operation->vessels[0];
  if (!prediction.operation->glenn || !joined.stump) return;
  const PreparedVessel& vein = prediction.vessels[vessel_named(prediction, joined.name)].prepared;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle()) continue;
    const std::string& name = vessel.prepared.spec.name;
    const bool cut = name == joined.name;
    const double reach = reach_into(
        *joined.stump, cut ? axis_of(vessel.rod.poses) : vessel.prepared.vessel.surface.points);
    if (reach <= drawn_through * vein.vessel.mean_radius) continue;
    prediction.left_out["stump of " + joined.name] =
        name + (cut ? " goes through it to the incision" : " lies in it at rest") +
        ": it is taken as out of the way";
    return;
  }
  PredictedVessel stump;
  stump.stump = true;
  VesselSpec& spec = stump.prepared.spec;
  spec = vein.spec;
  spec.name = stump_name(spec.name);  // no vessel of a scene may have this name
  spec.role = Role::obstacle;
  spec.pressure.reset();
  spec.axial_prestretch = 1;
  stump.prepared.vessel.surface = *joined.stump;
  prediction.vessels.push_back(std::move(stump));
}

void touch_stump(const Prediction& prediction, BodyProblem& problem) {
  if (!prediction.vessels.back().stump) return;
  const auto vein =
      static_cast<int>(vessel_named(prediction, prediction.operation->vessels[0].name));
  const int stump = static_cast<int>(prediction.vessels.size()) - 1;
  const auto listed = problem.contacts;
  for (const auto& [a, b] : listed) {
    const int other = a == vein ? b : a;
    if ((a == vein || b == vein) && !problem.bodies[index(other)].obstacle)
      problem.contacts.emplace_back(other, stump);
  }
}

}  // namespace vasorod
