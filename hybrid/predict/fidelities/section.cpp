#include <algorithm>
#include <cmath>
#include <set>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/prestress_sentence.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "predict/fidelities/fidelities.h"
#include "predict/path_rule.h"
#include "predict/prestress.h"
#include "predict/surface_bodies.h"
#include "predict/vessel_wall.h"
#include "predict/walls_means.h"
#include "rod/binding.h"
#include "sections/section_solver.h"
#include "wall/shear_band.h"

namespace vasorod {
namespace {

// Share of the shear across the wall in its bending beside a rigid end (shear_band.h). The
// reactions of a tube moved sideways, t/R 0.1, are 0.2 % off the finite-element shell's at a share
// of 0.18, 1.4 % at 1.1 and 3.4 % at 4.5 (the sensitivity's offset, G x 0.25, 0.04 and 0.01).
constexpr double largest_shear_share = 0.2;

SectionProblem problem_of(const PredictedVessel& vessel, const VesselSections& sections,
                          const std::string& where) {
  const Vessel& v = vessel.prepared.vessel;
  const WallInput wall = wall_of(vessel.prepared);
  SectionProblem problem;
  problem.name = vessel.prepared.spec.name;
  problem.rest = v.surface.points;
  problem.at = section_parameters(v, where);
  problem.thickness = wall.thickness;
  problem.mid_offset = wall.mid_offset;
  problem.material = wall.material;
  problem.pressure = vessel.prepared.spec.pressure.value_or(LumenPressure{});
  problem.axial_prestretch = wall.axial_prestretch;
  problem.radius = v.mean_radius;
  problem.length = length_scale(v.rod);
  std::vector<std::pair<size_t, size_t>> held;  // side and node
  for (size_t k = 0; k < sections.nodes.size(); ++k) {
    const size_t side = v.ends[index(problem.at.end[0])].node == sections.nodes[k] ? 0 : 1;
    problem.ends[side] = sections.sections[k];
    held.emplace_back(side, index(sections.nodes[k]));
  }
  problem.start = [&v, &rod = vessel.rod.poses, held](double t) {
    const RodPoses poses = t == 1 ? rod : share_of_strain(v.rod, rod, t);
    SectionProblem::Start start{carried_points(v.rod, poses, v.carry), {}};
    for (const auto& [side, node] : held)
      start.poses[side] = {poses[node].rotation * v.rod.rest[node].rotation.transpose(),
                           poses[node].position};
    return start;
  };
  return problem;
}

// The steps of the motion and of the vessel's pressure.
std::vector<double> times_of(const Prediction& prediction, const PredictedVessel& vessel) {
  const std::vector<double> motion = path_times(share_of_limit(prediction)),
                            pressure = pressure_times(vessel.prepared);
  std::set<double> all(motion.begin(), motion.end());
  all.insert(pressure.begin(), pressure.end());
  return {all.begin(), all.end()};
}

// Whether anything moves or loads its wall.
bool acts(const PredictedVessel& vessel) {
  return vessel.rod_solved || vessel.prepared.spec.pressure ||
         vessel.prepared.spec.axial_prestretch != 1;
}

BodySolution resting(const PredictedVessel& vessel) {
  BodySolution body;
  body.positions = vessel.prepared.vessel.surface.points;
  return body;  // without a pressure: contact is not modelled
}

std::vector<SectionSolution> resting_ends(const VesselSections& sections) {
  std::vector<SectionSolution> ends;
  for (const HeldSection& section : sections.sections) {
    ends.emplace_back().label = section.label;
    ends.back().center = section.rest.position;
  }
  return ends;
}

// Adds a vessel's wall to the results of all.
void take(SolvedSections&& found, SolvedSurfaces& surfaces) {
  SurfaceSolution& all = surfaces.solution;
  BodySolution& body = all.bodies.back();
  body.modelled = true;
  body.positions = std::move(found.positions);
  body.lumen = found.lumen;
  body.residual = found.balance;
  all.status = worse(all.status, found.status);
  all.residual = std::max(all.residual, found.residual);
  all.stretching_energy += found.report.membrane;
  all.bending_energy += found.report.bending;
  all.iterations += found.iterations;
  all.work += found.work;
  *surfaces.smallest_curvature_positive &= found.smallest_curvature_positive;
  FaceExtremes& faces = surfaces.faces.back();
  static_cast<FaceStretches&>(faces) = found.report.faces;
  faces.least_place = found.report.least_place;
  faces.largest_place = found.report.largest_place;
  surfaces.notes.insert(surfaces.notes.end(), found.notes.begin(), found.notes.end());
}

// What the choice of harmonics and splines costs, by the solver's own estimate.
std::string resolution(const std::string& name, const SolvedSections& found) {
  std::string text = "the sections of " + name + ": " + std::to_string(found.harmonics) +
                     " harmonics around, " + std::to_string(found.spans) + " spans along";
  if (std::isfinite(found.error))
    text += "; estimated error of that choice " + number_text(found.error, 2) + " of the radius";
  if (found.fit_error > 1e-6)
    text += "; the given surface is " + number_text(found.fit_error, 2) +
            " of the radius off theirs (RMS) and carried along";
  return text;
}

// That the wall shears beside its rigid ends, where that matters.
std::optional<std::string> soft_in_shear(const PredictedVessel& vessel,
                                         const VesselSections& sections) {
  const auto is_rigid = [](const HeldSection& section) { return section.rigid; };
  if (std::none_of(sections.sections.begin(), sections.sections.end(), is_rigid))
    return std::nullopt;
  const Wall& wall = *vessel.prepared.spec.wall;
  const double share =
      shear_layer(wall.material, wall.thickness, vessel.prepared.vessel.mean_radius).share;
  if (share <= largest_shear_share) return std::nullopt;
  return "the wall of " + vessel.prepared.spec.name +
         " is thick or soft in shear: across its thickness it shears beside its rigid ends (" +
         number_text(share, 2) +
         " times what its bending there does), which fidelity section leaves out, so that forces "
         "may be too large by some percent; fidelity coupled models it";
}

// Whether a note begins like this: where `accuracy:` was to choose, the mesh had a prestress first.
bool is_noted(const Prediction& prediction, const std::string& beginning) {
  return std::any_of(
      prediction.notes.begin(), prediction.notes.end(),
      [&](const std::string& note) { return note.compare(0, beginning.size(), beginning) == 0; });
}

}  // namespace

void solve_section(Prediction& prediction, const SolveOptions& options) {
  SolvedSurfaces surfaces;
  surfaces.carry_everything = true;
  surfaces.terms = {"bending", "stretching"};
  surfaces.solution.status = Status::converged;
  surfaces.smallest_curvature_positive = true;
  std::vector<VesselSections> sections;
  std::vector<std::vector<SectionSolution>> ends;
  for (const PredictedVessel& vessel : prediction.vessels) {
    const std::string& name = vessel.prepared.spec.name;
    surfaces.solution.bodies.push_back(resting(vessel));
    surfaces.faces.emplace_back();
    Vec3& load = surfaces.load.emplace_back(Vec3::Zero());
    sections.emplace_back();
    ends.emplace_back();
    if (vessel.prepared.obstacle()) continue;
    sections.back() = sections_of(vessel.prepared.vessel, vessel.conditions, -1);
    ends.back() = resting_ends(sections.back());
    if (vessel.prepared.spec.pressure) surfaces.terms.emplace_back("pressure");
    if (acts(vessel)) {
      SectionProblem problem = problem_of(vessel, sections.back(), "vessel " + name + ": ");
      problem.times = times_of(prediction, vessel);
      SectionOptions how;
      how.stop = options.stop;
      how.linear_prestrain_up_to = linear_prestrain_up_to(*prediction.scene, vessel);
      options.progress("sections of " + name);
      SolvedSections found = solve_sections(problem, how);
      prediction.notes.push_back(resolution(name, found));
      if (auto soft = soft_in_shear(vessel, sections.back()))
        prediction.notes.push_back(std::move(*soft));
      const auto large = large_prestress(name, found.prestress_displacement, found.prestress_steps);
      if (large && !is_noted(prediction, "prestress of " + name))
        prediction.notes.push_back(*large);
      for (size_t k = 0; k < sections.back().nodes.size(); ++k) {
        const bool first =
            vessel.prepared.vessel.ends[index(problem.at.end[0])].node == sections.back().nodes[k];
        ends.back()[k] = *found.ends[first ? 0 : 1];
      }
      take(std::move(found), surfaces);
    }
    for (const SectionSolution& end : ends.back()) {
      load += end.load;
      surfaces.solution.bodies.back().support += end.force;
      if (!end.label.empty())
        surfaces.ends.push_back({name, end.label, end.force, end.moment, end.center});
    }
  }
  take_surfaces(std::move(surfaces), "wall", prediction);
  prediction.left_out["energy of the rods"] =
      "fidelity section: the walls carry all of it; the rods are start, frames and report";
  prediction.left_out["contact"] =
      "fidelity section: walls do not feel each other or themselves; those that pass through each "
      "other are named";
  give_rods_the_walls_means(prediction, sections, ends);
}

}  // namespace vasorod
