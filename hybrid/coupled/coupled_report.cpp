#include "coupled/coupled_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/surface_report.h"
#include "data/index.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

// Whether the pressure on the lid over an end is the support's to carry: not where the end is free
// to move, where it acts as a load.
bool carries_lid(const CoupledWall& wall, int behind) {
  if (behind == WallLumen::seam) return true;
  if (behind == WallLumen::free_end) return false;
  const auto& fixed = wall.sections[index(behind)].section().fixed;
  return fixed[0] || fixed[1] || fixed[2];
}

// The pressure's force on each vertex through a lid that a support or a seam carries.
struct Lid {
  int behind = 0;  // WallLumen::behind_fan
  Points force;    // n x 3
};

std::vector<Lid> carried_lids(const CoupledWall& wall, const CoupledState& s) {
  std::vector<Lid> lids;
  if (!wall.lumen) return lids;
  const WallLumen& lumen = *wall.lumen;
  const Points x = s.positions.middleRows(wall.first_vertex, wall.energy->vertices());
  for (int fan = 0; fan < std::ssize(lumen.behind_fan); ++fan)
    if (const int behind = lumen.behind_fan[index(fan)]; carries_lid(wall, behind))
      lids.push_back({behind, lumen.now * lumen.volume.lid_force(x, fan)});
  return lids;
}

// The scaled wrench of each section on its wall: the gradient that it must balance, without what
// the lid over its end carries.
std::vector<SectionSolution> section_forces(const CoupledSystem& system, int w,
                                            const CoupledState& s, const CoupledForces& f) {
  const CoupledWall& wall = system.walls()[index(w)];
  const VectorXd total = system.total_force(index(w), f);
  std::vector<SectionSolution> sections(wall.sections.size());
  for (size_t k = 0; k < sections.size(); ++k) {
    SectionSolution& mine = sections[k];
    const SectionPlacement& at = s.placements[index(w)][k];
    mine.label = wall.sections[k].section().label;
    mine.center = at.position;
    mine.rotation = at.rotation;
    mine.load = wall.sections[k].time() * wall.sections[k].section().force;
    if (wall.ties[k])
      wall.ties[k]->reaction(at, s.positions.middleRows(wall.first_vertex, wall.energy->vertices()),
                             mine.force, mine.moment);
  }
  for (const CoupledWall::Carried& c : wall.carried) {
    SectionSolution& mine = sections[index(c.section)];
    const Vec3 force = total.segment<3>(c.entry);
    mine.moment += (mine.rotation * c.arm).cross(force);
    if (!c.normal) mine.force += force;
  }
  for (const Lid& lid : carried_lids(wall, s)) {
    if (lid.behind == WallLumen::seam) continue;
    SectionSolution& mine = sections[index(lid.behind)];
    for (const int v : wall.sections[index(lid.behind)].section().ring) {
      const Vec3 force = lid.force.row(v), x = s.positions.row(wall.first_vertex + v);
      mine.force += force;
      mine.moment += (x - mine.center).cross(force);
    }
  }
  return sections;
}

// Adds a note if a wall folds sharper than a right angle over one edge, which its mesh cannot
// resolve (degeneracy_barriers.h).
void name_fold(const std::string& name, const WallEnergy& wall, const WallReport& now,
               const ScaledBodies& scaled, CoupledSolution& solution) {
  constexpr double right_angle = std::numbers::pi / 2;
  if (now.sharpest_fold < right_angle || wall.report(wall.rest()).sharpest_fold > right_angle)
    return;
  const Vec3 place = now.fold_place * scaled.length + scaled.origin;
  solution.notes.push_back(joined_text("the wall of ", name, " is folded by ",
                                       std::lround(now.sharpest_fold * 180 / std::numbers::pi),
                                       " degrees over one edge at ", place_text(place, 4),
                                       ": its mesh is too coarse for what happens there"));
}

// `gap`: the smallest of the faces, mean edges.
std::string guard_note(const std::string& name, double gap) {
  return joined_text("the wall of ", name,
                     " is kept from passing through itself by a barrier, up to ",
                     number_text(CoupledProblem::guard_reach, 2),
                     " mean edges wide: contacts of walls that crumple find no end",
                     gap < 0 ? joined_text("; faces that met at an angle lie in each other by ",
                                           number_text(-gap, 2), " mean edges")
                             : std::string());
}

struct Sums {
  Vec3 support = Vec3::Zero(), load = Vec3::Zero(), joining = Vec3::Zero(), contact = Vec3::Zero(),
       pressure = Vec3::Zero();
  double residual = 0;
};

Sums sums_of(const CoupledSystem& system, int w, const CoupledState& s,
             const std::vector<SectionSolution>& sections, const CoupledForces& f) {
  const CoupledWall& wall = system.walls()[index(w)];
  const int vertices = wall.energy->vertices();
  Sums sums;
  double largest = 0;
  for (const SectionSolution& section : sections) {
    largest = std::max(largest, section.force.norm());
    sums.load += section.load;
    sums.support += section.force - section.load;
  }
  sums.joining = -f.joining.middleRows(wall.first_vertex, vertices).colwise().sum().transpose();
  sums.contact = -f.contact.middleRows(wall.first_vertex, vertices).colwise().sum().transpose();
  for (const Lid& lid : carried_lids(wall, s)) {
    const Vec3 force = lid.force.colwise().sum().transpose();
    sums.pressure -= force;
    if (lid.behind == WallLumen::seam) sums.joining += force;
  }
  // Seam and contact forces at a rigid ring are part of the force of its section. They occur in
  // both sums with opposite signs, and the wall's own forces sum to zero.
  const double net =
      (sums.support + sums.load + sums.joining + sums.contact + sums.pressure).norm();
  largest = std::max({largest, sums.support.norm(), sums.load.norm(), sums.joining.norm(),
                      sums.contact.norm(), sums.pressure.norm()});
  const double rounding =
      1e-12 *
          Eigen::Map<const Points>(f.wall[index(w)].data(), vertices, 3).rowwise().norm().sum() +
      1e-14 * vertices;
  sums.residual = net <= rounding ? 0 : net / largest;
  return sums;
}

}  // namespace

double worst_coupled_balance(const ScaledBodies& scaled, const CoupledSystem& system,
                             const std::vector<int>& first_wall, const VectorXd& z) {
  VectorXd g;
  CoupledForces f;
  system.gradient(z, g, &f);
  const CoupledState s = system.state(z);
  double worst = 0;
  for (size_t b = 0; b < scaled.bodies.size(); ++b)
    if (const int w = first_wall[b]; w >= 0)
      worst = std::max(worst, sums_of(system, w, s, section_forces(system, w, s, f), f).residual);
  return worst;
}

void report_coupled(const CoupledProblem& problem, const ScaledBodies& scaled,
                    const CoupledSystem* system, const std::vector<int>& first,
                    const std::vector<int>& first_wall, const VectorXd& z,
                    const StackedContacts& stacked, BodyContacts& contacts,
                    CoupledSolution& solution, bool final) {
  SurfaceSolution& surface = solution.surface;
  surface.bodies.resize(scaled.bodies.size());
  solution.sections.resize(scaled.bodies.size());
  solution.faces.assign(scaled.bodies.size(), {});
  CoupledForces f;
  CoupledState s;
  if (system) {
    VectorXd g;
    const CoupledTerms terms = system->gradient(z, g, &f);
    s = system->state(z);
    surface.joining_energy = terms.joining * scaled.energy();
    surface.contact_energy = terms.contact * scaled.energy();
  }
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    BodySolution& mine = surface.bodies[b];
    const Points& rest = problem.surfaces.bodies[b].rest.points;
    mine.pressure = VectorXd::Zero(rest.rows());
    mine.support_force = mine.binding_force = Points::Zero(rest.rows(), 3);
    const int w = system ? first_wall[b] : -1;
    if (w < 0) {
      mine.positions = rest;
      if (problem.vessels[b])
        for (const HeldSection& section : problem.vessels[b]->sections) {
          solution.sections[b].emplace_back();
          solution.sections[b].back().label = section.label;
          solution.sections[b].back().center = section.rest.position;
        }
      continue;
    }
    mine.modelled = true;
    if (system->walls()[index(w)].guard)
      mine.pressure =
          guard_pressure(scaled.bodies[b].rest, f.guard.middleRows(first[b], rest.rows())) *
          scaled.pressure();
    mine.positions = scaled.unscaled(s.positions.middleRows(first[b], rest.rows()));
    solution.sections[b] = section_forces(*system, w, s, f);
    const Sums sums = sums_of(*system, w, s, solution.sections[b], f);
    mine.support = (sums.support + sums.load) * scaled.force();
    mine.joining = sums.joining * scaled.force();
    mine.contact = sums.contact * scaled.force();
    mine.lumen = sums.pressure * scaled.force();
    mine.residual = sums.residual;
    for (SectionSolution& section : solution.sections[b]) {
      section.force *= scaled.force();
      section.load *= scaled.force();
      section.moment *= scaled.force() * scaled.length;
      section.center = section.center * scaled.length + scaled.origin;
    }
    const WallReport energies = system->walls()[index(w)].energy->report(s.q[index(w)]);
    solution.membrane_energy += energies.membrane * scaled.energy();
    solution.bending_energy += (energies.bending + energies.coupling) * scaled.energy();
    FaceExtremes& faces = solution.faces[b];
    faces = energies.faces;
    for (Vec3* place : {&faces.least_place, &faces.largest_place})
      *place = *place * scaled.length + scaled.origin;
    name_fold(problem.surfaces.bodies[b].name, *system->walls()[index(w)].energy, energies, scaled,
              solution);
  }
  surface.stretching_energy = solution.membrane_energy;
  surface.bending_energy = solution.bending_energy;
  const std::vector<ContactPoint> none;
  std::vector<VectorXd> guarded;  // before the other contacts' pressures are added
  for (const BodySolution& body : surface.bodies) guarded.push_back(body.pressure);
  report_contacts(problem.surfaces, scaled, system ? system->contacts : none, s.positions, stacked,
                  contacts, surface, final);
  for (ContactSolution& pair : surface.contacts)
    if (const int w = system ? first_wall[index(pair.a)] : -1; pair.a == pair.b && w >= 0)
      if (const auto& guard = system->walls()[index(w)].guard) {
        const auto rows = scaled.bodies[index(pair.a)].now.rows();
        const double gap = guard->smallest_gap(s.positions.middleRows(first[index(pair.a)], rows));
        report_guard(scaled, guarded[index(pair.a)], gap, pair);
        if (pair.within_reach)
          solution.notes.push_back(guard_note(problem.surfaces.bodies[index(pair.a)].name, gap));
      }
  if (system) report_seam(scaled, system->joins, s.positions, surface);
}

std::string CoupledSolution::brief_report() const {
  SurfaceSolution whole = surface;
  whole.status = status;
  return whole.brief_report();
}

}  // namespace vasorod
