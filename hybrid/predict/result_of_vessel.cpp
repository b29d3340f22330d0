#include "predict/result_of_vessel.h"

#include "data/index.h"
#include "data/sentence.h"
#include "judge/lumen_pressure.h"
#include "judge/metrics.h"
#include "judge/mouth.h"
#include "judge/sections.h"
#include "judge/validity.h"
#include "rod/strain_change.h"
#include "vessel/fork_reach.h"

namespace vasorod {

CenterlineResult centerline_of(const RodTree& rod, const RodPoses& poses) {
  const auto n = static_cast<size_t>(rod.node_count());
  CenterlineResult line;
  line.rest.resize(rod.node_count(), 3);
  line.current.resize(rod.node_count(), 3);
  line.abscissa.assign(n, 0);
  line.radius = rod.radius;
  for (const RodBranch& branch : rod.branches) {
    line.lines.push_back(branch.nodes);
    for (const int e : branch.elements) {
      const RodElement& element = rod.elements[static_cast<size_t>(e)];
      line.abscissa[static_cast<size_t>(element.second)] =
          line.abscissa[static_cast<size_t>(element.first)] + element.length;
    }
  }
  const auto changes = node_changes(rod, element_changes(rod, poses));
  for (size_t i = 0; i < n; ++i) {
    line.rest.row(static_cast<Eigen::Index>(i)) = rod.rest[i].position;
    line.current.row(static_cast<Eigen::Index>(i)) = poses[i].position;
    line.directors.push_back(poses[i].rotation);
    const Vec6 rest = changes[i].strain - changes[i].change;
    line.v.emplace_back(changes[i].strain.head<3>());
    line.u.emplace_back(changes[i].strain.tail<3>());
    line.v0.emplace_back(rest.head<3>());
    line.u0.emplace_back(rest.tail<3>());
  }
  return line;
}

namespace {

VesselResult written(const Prediction& prediction, const PredictedVessel& vessel) {
  const PreparedVessel& prepared = vessel.prepared;
  VesselResult out;
  out.name = prepared.spec.name;
  out.obstacle = prepared.obstacle();
  out.space = prepared.loaded.space;
  if (vessel.positions.rows() > 0) {
    out.rest = prepared.vessel.surface.points;
    out.current = vessel.positions;
    out.triangles = prepared.vessel.surface.triangles;
    out.contact_pressure = vessel.pressure;
    out.point_arrays = prepared.loaded.point_arrays;
    out.cell_arrays = prepared.loaded.cell_arrays;
    if (prediction.operation)
      for (const OperatedVessel& joined : prediction.operation->vessels)
        if (joined.name == out.name) out.stump = joined.stump;
  }
  if (!out.obstacle) out.centerline = centerline_of(prepared.vessel.rod, vessel.rod.poses);
  return out;
}

// The rod elements over the incision; empty: the vessel has none.
std::vector<char> opened_in(const Prediction& prediction, const PreparedVessel& vessel) {
  const auto& operation = prediction.operation;
  if (!operation || !operation->glenn || operation->glenn->rpa != vessel.spec.name) return {};
  return opened_elements(vessel, operation->pairs);
}

// Names the branches whose kinks and wrinkles nobody judges.
void say_what_is_no_tube(const Vessel& vessel, const std::string& name, Result& result) {
  std::string places;
  for (const size_t b : branches_within_forks(vessel)) {
    const int end = vessel.rod.branches[b].nodes.back();
    places += (places.empty() ? "" : ", ") + place_text(vessel.rod.rest[index(end)].position, 3);
  }
  if (!places.empty())
    result.model.left_out["kinks and wrinkles of branches of " + name] =
        "those that end at " + places +
        " lie within the reach of a fork, where no section is a tube; only the strain is judged";
}

// Fields, extremes and validity of a deformable vessel.
void judge(const Prediction& prediction, const PredictedVessel& vessel, Result& result) {
  const PreparedVessel& prepared = vessel.prepared;
  VertexFields fields = vertex_fields(prepared, vessel.rod.poses);
  const Points current =
      vessel.positions.rows() > 0
          ? vessel.positions
          : carried_points(prepared.vessel.rod, vessel.rod.poses, prepared.vessel.carry);
  const bool walls_solved = prediction.surfaces && !prediction.surfaces->faces.empty();
  const JudgedState state{.rigid_nodes = rigid_nodes(prediction, vessel),
                          .opened = opened_in(prediction, prepared),
                          .walls = prediction.surfaces ? current : Points(),
                          .sections_flatten = walls_solved};
  std::vector<JudgedSection> sections;
  if (vessel.positions.rows() > 0) {
    sections = judged_sections(prepared, vessel.rod.poses, current);
    LumenAlong along = lumen_along(prepared.vessel.rod, sections);
    result.vessels.back().centerline->lumen_area = std::move(along.area);
    result.vessels.back().centerline->flattening = std::move(along.flattening);
  }
  result.metrics.push_back(vessel_metrics(prepared, vessel.rod.poses, fields, current,
                                          vessel.pressure, sections, state.opened));
  const std::size_t before = result.validity.warnings.size();
  add_validity(prepared, vessel.rod.poses, state, result.validity);
  say_what_is_no_tube(prepared.vessel, prepared.spec.name, result);
  if (walls_solved)
    warn_of_law(prepared.spec,
                prediction.surfaces->faces[vessel_named(prediction, prepared.spec.name)],
                result.validity);
  // Ratios of a state that is no solution give no warnings.
  if (!is_solution(result.status)) result.validity.warnings.resize(before);
  warn_of_units(prepared.spec, prediction.scene->units, result.validity);
  warn_of_collapse(prepared, prediction.scene->units, result.validity);
  if (prepared.spec.surface && prepared.spec.check)
    warn_of_radius(prepared.spec.name, prepared.vessel.mean_radius, prediction.scene->units,
                   result.validity);
  result.vessels.back().axial_stretch = std::move(fields.axial_stretch);
  result.vessels.back().twist_shear = std::move(fields.twist_shear);
}

}  // namespace

void add_vessels(const Prediction& prediction, Result& result) {
  Stage deformed{"result", {}, {}};
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (vessel.stump) continue;  // written with the vein
    result.vessels.push_back(written(prediction, vessel));
    if (!vessel.prepared.obstacle()) judge(prediction, vessel, result);
    if (vessel.positions.rows() == 0) continue;
    deformed.surfaces.push_back({vessel.positions, vessel.prepared.vessel.surface.triangles});
    deformed.names.push_back(vessel.prepared.spec.name);
  }
  result.stages = prediction.stages;
  if (!deformed.surfaces.empty()) result.stages.push_back(std::move(deformed));
}

}  // namespace vasorod
