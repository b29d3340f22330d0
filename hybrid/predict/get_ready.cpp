#include "predict/get_ready.h"

#include <algorithm>

#include <vasorod/error.h>

#include "bodies/reach.h"
#include "data/scene_place.h"
#include "geometry/closest_point.h"
#include "predict/prestress.h"
#include "surgery/end_to_end.h"
#include "surgery/glenn.h"

namespace vasorod {
namespace {

// Over the vein's radius: a vessel that reaches farther into the vein's stump was drawn there as in
// a sketch. Surfaces of scanned neighbours overlap by less.
constexpr double drawn_through = 0.5;

Stage rest_stage(const Prediction& prediction) {
  Stage rest{"rest", {}, {}};
  for (const PredictedVessel& vessel : prediction.vessels) {
    rest.surfaces.push_back(vessel.prepared.vessel.surface);
    rest.names.push_back(vessel.prepared.spec.name);
  }
  return rest;
}

// Cuts, opens, places and sews; solves the rods that the join moves.
void operate_on(Prediction& prediction, const SolveOptions& options,
                const std::function<void(const std::string&)>& begin) {
  const Scene& scene = *prediction.scene;
  const auto [first_name, second_name] = scene.joined().value();
  PredictedVessel& first = prediction.vessels[vessel_named(prediction, first_name)];
  PredictedVessel& second = prediction.vessels[vessel_named(prediction, second_name)];
  OperationOptions how;
  how.rod.stop = options.stop;
  how.progress = [&](const std::string& step) { begin("surgery: " + step); };
  Operation& operation = prediction.operation.emplace();
  if (scene.glenn)
    operation =
        operate(scene, *scene.glenn, first.prepared, second.prepared, first.conditions, how);
  else
    operation = join_end_to_end(scene, *scene.end_to_end,
                                {VesselToJoin{first.prepared, first.conditions},
                                 VesselToJoin{second.prepared, second.conditions}},
                                how);
  for (PredictedVessel* vessel : {&first, &second}) {
    auto& rod = operation.vessels[vessel == &first ? 0 : 1].rod;
    if (!rod) continue;
    vessel->rod = *rod;
    vessel->rod_solved = true;
  }
  for (Stage& stage : operation.stages) prediction.stages.push_back(std::move(stage));
}

// How far a vessel's surface reaches into a closed one at rest, length.
double reach_into(const TriangleSurface& closed, const Points& points) {
  const ClosestPoint finder(closed);
  const Box box = box_of(closed.points);
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
  for (Eigen::Index i = 0; i < axis.rows(); ++i)
    axis.row(i) = poses[static_cast<size_t>(i)].position;
  return axis;
}

// What is left of a Glenn's vein stays where it was, as rigid as other obstacles. Of vessels joined
// end to end the other part is taken out or tied off, and the joined one may lie there.
void add_stump(Prediction& prediction) {
  const OperatedVessel& joined = prediction.operation->vessels[0];
  if (!prediction.scene->glenn || !joined.stump) return;
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
  spec.name = stump_of(joined.name);
  spec.role = Role::obstacle;
  spec.pressure.reset();
  spec.axial_prestretch = 1;
  stump.prepared.vessel.surface = *joined.stump;
  prediction.vessels.push_back(std::move(stump));
}

void solve_rods(Prediction& prediction, const SolveOptions& options) {
  RodOptions rod_options;
  rod_options.stop = options.stop;
  for (PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle() || vessel.rod_solved) continue;
    vessel.rod.poses = vessel.prepared.vessel.rod.rest;
    if (!vessel.conditions.acts) {
      prediction.left_out["rod of " + vessel.prepared.spec.name] =
          "nothing moves or loads it: it stays as it is";
      continue;
    }
    options.progress("rod of " + vessel.prepared.spec.name);
    try {
      vessel.rod = solve_rod(vessel.prepared.vessel.rod, vessel.conditions.rod, rod_options);
    } catch (const InputError& error) {
      throw InputError(place_of(*prediction.scene, vessel.prepared.spec) + error.what());
    }
    vessel.rod_solved = true;
  }
}

}  // namespace

void get_ready(Prediction& prediction, LumenOf lumen, const SolveOptions& options,
               const std::function<void(const std::string&)>& begin) {
  prestress(prediction, lumen, begin);
  prediction.stages.push_back(rest_stage(prediction));
  if (prediction.scene->joined()) {
    operate_on(prediction, options, begin);
    add_stump(prediction);
  }
  prediction.watch.lap("surgery");
  solve_rods(prediction, options);
}

}  // namespace vasorod
