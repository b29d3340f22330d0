#include "coupled/coupled_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <vasorod/error.h>

#include "bodies/seam.h"
#include "coupled/free_motions.h"
#include "coupled/stiffening.h"
#include "coupled/wall_lumen.h"
#include "data/index.h"
#include "numerics/threads.h"
#include "wall/shear_band.h"

namespace vasorod {
namespace {

// Of the barrier that keeps a wall from touching itself: its stiffness over that of the wall.
constexpr double guard_stiffness = 1;

bool acts(const HeldSection& section) {
  return section.force != Vec3::Zero() || section.moment != Vec3::Zero() ||
         section.body_moment != Vec3::Zero() || section.motion.move != Vec3::Zero() ||
         section.motion.rotate != Vec3::Zero();
}

}  // namespace

CoupledStack::CoupledStack(CoupledProblem given, const CoupledOptions& chosen)
    : problem(std::move(given)), options(chosen) {
  if (problem.vessels.size() != problem.surfaces.bodies.size())
    throw InputError("found " + std::to_string(problem.vessels.size()) + " walls for " +
                     std::to_string(problem.surfaces.bodies.size()) + " bodies, expected one each");
  // p' and rotations at the end of the path, as required by scale_bodies()
  const std::vector<CarriedBody> carried = problem.carried(1);
  for (size_t b = 0; b < carried.size(); ++b) {
    problem.surfaces.bodies[b].carried = carried[b].points;
    problem.surfaces.bodies[b].rotations = carried[b].rotations;
  }
  scaled = scale_bodies(problem.surfaces);
  check_seams(problem.surfaces.seams, scaled);
  contacts = std::make_unique<BodyContacts>(problem.surfaces, scaled, options.contact_stiffness);
  guards_.resize(scaled.bodies.size());
  if (problem.guarded) guard_walls();
  energies_.resize(problem.vessels.size());
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    ScaledBody& body = scaled.bodies[b];
    body.modelled = body.moved;
    if (!problem.vessels[b]) continue;
    // Stress as it was seen is part of the result even where nothing moves.
    body.modelled |= problem.vessels[b]->pressure || problem.vessels[b]->wall.axial_prestretch != 1;
    body.modelled |= problem.vessels[b]->inflation > 0;
    for (const HeldSection& section : problem.vessels[b]->sections) body.modelled |= acts(section);
  }
  for (const SeamPair& seam : problem.surfaces.seams)
    for (const int b : {seam.body_a, seam.body_b})
      scaled.bodies[index(b)].modelled = !scaled.bodies[index(b)].obstacle;
  for (const ScaledBody& body : scaled.bodies) moved_.push_back(body.modelled);
  if (problem.start) take_start();
  seam_multipliers_.assign(problem.surfaces.seams.size(), Vec3::Zero());
  seam_radius = mouth_radius(problem.surfaces.seams, scaled);
  check_free_motions(problem, scaled);
}

// The system is built again with others.
void CoupledStack::take_part(size_t b, bool does) {
  if (std::exchange(scaled.bodies[b].modelled, does) != does) system.reset();
}

void CoupledStack::take_start() {
  expected_.clear();
  for (size_t b = 0; b < scaled.bodies.size(); ++b)
    take_part(b, moved_[b] || problem.start->bodies[b].points.rows() > 0);
  expect_pressures();
}

void CoupledStack::expect_pressures() {
  std::vector<Eigen::VectorXd> pressure = problem.start->pressure;
  for (Eigen::VectorXd& mine : pressure) mine /= scaled.pressure();
  contacts->expect(std::move(pressure));
}

void CoupledStack::set_start(CoupledStart start) {
  problem.start = std::move(start);
  starts_later_ = true;
  take_start();
  if (!system) prepared_ = {};  // it was for nothing
  check_free_motions(problem, scaled);
}

void CoupledStack::prepare(const std::function<bool()>& abandoned) {
  starts_later_ = true;
  work = {};
  expect_touched();
  if (abandoned()) return;
  if (!system) build();
  prepared_ = work.counts;
  if (!abandoned()) minimiser->find_order();
}

void CoupledStack::begin_solve() {
  if (!problem.start)
    for (const int b : std::exchange(expected_, {})) take_part(index(b), false);
  if (!system) prepared_ = {};
  work = {};
  work.counts = std::exchange(prepared_, {});
  begin_stage();
}

// Models the bodies on which others press where their rods carry them at the end of the path.
void CoupledStack::expect_touched() {
  ScaledBodies carried = scaled;
  for (ScaledBody& body : carried.bodies) body.now = body.carried;
  BodyContacts found(problem.surfaces, carried, options.contact_stiffness);
  for (const int b : found.refresh(carried).touched) {
    expected_.push_back(b);
    take_part(index(b), true);
  }
}

void CoupledStack::guard_walls() {
  contacts->leave_out_own();
  for (const auto& [a, b] : problem.surfaces.contacts) {
    const ScaledBody& body = scaled.bodies[index(a)];
    if (a != b || body.obstacle) continue;
    guards_[index(a)] = std::make_shared<CrossingGuard>(
        body.rest, CoupledProblem::guard_reach * body.mean_edge,
        guard_stiffness * (body.k.bending + body.k.stretching), guarded_wall(body));
    guards_[index(a)]->search_all();
  }
}

HeldSection CoupledStack::scale(const HeldSection& section) const {
  return vasorod::scaled(section, scaled.length, scaled.force(), scaled.origin);
}

std::vector<HeldSection> CoupledStack::scaled_sections(size_t body) const {
  std::vector<HeldSection> sections;
  for (const HeldSection& section : problem.vessels[body]->sections)
    sections.push_back(scale(section));
  return sections;
}

void CoupledStack::set_sections(int b, const std::vector<HeldSection>& sections) {
  problem.vessels[index(b)]->sections = sections;
  if (system && first_wall[index(b)] >= 0)
    system->set_sections(first_wall[index(b)], scaled_sections(index(b)));
}

void CoupledStack::set_material(int b, const Material& material) {
  if (put_material(index(b), material)) minimiser->renew_rest();
}

// Returns whether the system has the body's wall, with the unknowns that it had. Where the material
// is refused nothing changes.
bool CoupledStack::put_material(size_t b, const Material& material) {
  Material& own = problem.vessels[b]->wall.material;
  const Material before = std::exchange(own, material);
  std::unique_ptr<WallEnergy> energy;
  try {
    energy = std::make_unique<WallEnergy>(scaled_wall(b));
  } catch (...) {
    own = before;
    throw;
  }
  std::swap(energies_[b], energy);
  if (!system || first_wall[b] < 0) return false;
  if (energies_[b]->leans() != energy->leans()) {
    system.reset();
    return false;
  }
  system->set_energy(first_wall[b], *energies_[b]);
  return true;
}

void CoupledStack::ease() {
  own_.assign(problem.vessels.size(), std::nullopt);
  if (problem.start || !problem.surfaces.seams.empty()) return;
  for (size_t b = 0; b < own_.size(); ++b) {
    if (!problem.vessels[b] || !scaled.bodies[b].modelled) continue;
    const Material own = problem.vessels[b]->wall.material, softer = eased(own);
    if (softer.shear_axial == own.shear_axial) continue;
    own_[b] = own;
    set_material(static_cast<int>(b), softer);
  }
}

bool CoupledStack::is_eased() const {
  return std::any_of(own_.begin(), own_.end(), [](const auto& own) { return own.has_value(); });
}

void CoupledStack::stiffen() {
  double growth = 1;
  for (size_t b = 0; b < own_.size(); ++b) {
    if (!own_[b]) continue;
    const Material now = problem.vessels[b]->wall.material, next = stiffened(now, *own_[b]);
    growth = std::max(growth, next.shear_axial / now.shear_axial);
    put_material(b, next);  // a wall so stiff in shear has no leans, eased or not
    if (next.shear_axial == own_[b]->shear_axial) own_[b].reset();
  }
  minimiser->follow_stiffer(z, growth);
}

void CoupledStack::end_easing() noexcept {
  for (size_t b = 0; b < own_.size(); ++b) {
    if (!own_[b]) continue;
    problem.vessels[b]->wall.material = *own_[b];
    system.reset();
    energies_[b].reset();
  }
  own_.clear();
}

WallInput CoupledStack::scaled_wall(size_t b) const {
  WallInput wall = vasorod::scaled(problem.vessels[b]->wall, scaled.bodies[b].rest, scaled.length,
                                   scaled.pressure());
  wall.name = "vessel " + problem.surfaces.bodies[b].name;
  wall.glued = glued_marks(problem.vessels[b]->sections, wall.rest.points.rows());
  wall.lean = shear_band(wall);
  return wall;
}

WallEnergy& CoupledStack::energy_of(size_t b) {
  if (!energies_[b]) energies_[b] = std::make_unique<WallEnergy>(scaled_wall(b));
  return *energies_[b];
}

WallLumen CoupledStack::lumen_of(size_t b) const {
  std::vector<int> seam;
  for (const SeamPair& pair : problem.surfaces.seams) {
    if (pair.body_a == static_cast<int>(b)) seam.push_back(pair.vertex_a);
    if (pair.body_b == static_cast<int>(b)) seam.push_back(pair.vertex_b);
  }
  LumenPressure pressure = problem.vessels[b]->pressure.value_or(LumenPressure{});
  pressure.scan /= scaled.pressure();
  pressure.after /= scaled.pressure();
  WallLumen lumen = wall_lumen(scaled_wall(b), problem.vessels[b]->sections, seam, pressure);
  lumen.inflation = problem.vessels[b]->inflation / scaled.pressure();
  return lumen;
}

int CoupledStack::add_wall(size_t b, const std::vector<HeldSection>& sections,
                           const WallPatch* patch) {
  const ScaledBody& body = scaled.bodies[b];
  const int wall = system->add_wall(energy_of(b), body.rest.points, sections,
                                    options.tie_stiffness * body.k.stretching, patch);
  if (problem.vessels[b]->pressure || problem.vessels[b]->inflation > 0)
    system->set_lumen(wall, lumen_of(b));
  system->set_guard(wall, guards_[b]);
  return wall;
}

void CoupledStack::build() {
  wide_.reset();
  system = std::make_unique<CoupledSystem>();
  first.assign(scaled.bodies.size(), -1);
  first_wall.assign(scaled.bodies.size(), -1);
  in_parallel(threads(), static_cast<int>(scaled.bodies.size()), [&](int b) {
    if (scaled.bodies[index(b)].modelled) energy_of(index(b));
  });
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    const ScaledBody& body = scaled.bodies[b];
    if (!body.modelled) continue;
    first[b] = system->vertex_count();
    first_wall[b] = add_wall(b, scaled_sections(b), nullptr);
  }
  system->set_inflation(inflation_);
  system->finish();
  join();
  minimiser = std::make_unique<CoupledMinimiser>(*system, work);
  if (starts_later_) minimiser->order_without_contacts();
  z.setZero(system->unknowns());
}

// What is between the walls of the system.
void CoupledStack::join() {
  const std::vector<SeamPair>& seams = problem.surfaces.seams;
  system->k_j = joining_stiffness(seams, scaled, options.seam_stiffness);
  system->joins = stacked_joins(seams, first, seam_multipliers_);
  place_seams();
  stack_contacts();
}

void CoupledStack::stack_contacts() {
  stacked = contacts->stacked(scaled, first);
  system->contacts = stacked.points;
}

void CoupledStack::search_contacts() {
  contacts->refresh(scaled);
  stack_contacts();
}

double CoupledStack::follow(const Eigen::VectorXd& at) {
  unstack(at);
  if (contacts->follow(scaled)) stack_contacts();
  return contacts->gap_from_itself(scaled);
}

bool CoupledStack::goes_on_in_shorter_steps() const {
  if (spent()) return false;
  if (system->guarded()) return true;
  if (contacts->pressing()) return false;
  for (int p = 0; p < std::ssize(problem.surfaces.contacts); ++p) {
    const auto& [a, b] = problem.surfaces.contacts[index(p)];
    if (a == b && contacts->within_reach(p)) return false;
  }
  return true;
}

bool CoupledStack::feels_itself() const {
  return !problem.guarded &&
         std::any_of(problem.surfaces.contacts.begin(), problem.surfaces.contacts.end(),
                     [](const std::pair<int, int>& pair) { return pair.first == pair.second; });
}

void CoupledStack::unstack(const Eigen::VectorXd& at) {
  const Points positions = system->state(at).positions;
  for (size_t b = 0; b < scaled.bodies.size(); ++b)
    if (first[b] >= 0)
      scaled.bodies[b].now = positions.middleRows(first[b], scaled.bodies[b].now.rows());
}

void CoupledStack::set_inflation(double share) {
  inflation_ = share;
  system->set_inflation(share);
}

bool CoupledStack::is_inflated() const {
  return inflation_ > 0 &&
         std::any_of(problem.vessels.begin(), problem.vessels.end(),
                     [](const auto& vessel) { return vessel && vessel->inflation > 0; });
}

bool CoupledStack::spent() const {
  return options.most_per_stage > 0 &&
         work.counts.factorisations - before_stage_ >= options.most_per_stage;
}

void CoupledStack::set_seam_offsets(double time) {
  seam_offsets_ = problem.seam_way->offsets(time);
  for (Vec3& offset : seam_offsets_) offset /= scaled.length;
  place_seams();
}

void CoupledStack::place_seams() {
  for (size_t i = 0; i < seam_offsets_.size(); ++i) system->joins[i].offset = seam_offsets_[i];
}

void CoupledStack::update_seams() {
  update_join_multipliers(system->k_j, system->joins, system->state(z).positions);
  for (size_t i = 0; i < system->joins.size(); ++i)
    seam_multipliers_[i] = system->joins[i].multiplier;
}

bool CoupledStack::hides_forces(size_t b) const {
  return first_wall[b] >= 0 &&
         vasorod::hides_forces(own_[b].value_or(problem.vessels[b]->wall.material));
}

bool CoupledStack::hides_forces() const {
  for (size_t b = 0; b < problem.vessels.size(); ++b)
    if (hides_forces(b)) return true;
  return false;
}

std::vector<std::string> CoupledStack::hidden_by_rounding() const {
  std::vector<std::string> hidden;
  if (minimiser->load_is_hidden(z))
    hidden.emplace_back(
        "the loads are smaller than what rounding leaves of the walls' forces: the result is not "
        "theirs");
  for (size_t b = 0; b < problem.vessels.size(); ++b)
    if (hides_forces(b))
      hidden.push_back("vessel " + problem.surfaces.bodies[b].name +
                       ": its shear modulus lies more than 1e10 times from that of an isotropic "
                       "wall: rounding of the larger stresses hides the smaller forces");
  return hidden;
}

CoupledStack::Placed CoupledStack::placed() const {
  return {z, system->state(z).placements};
}

void CoupledStack::place(const Placed& state) {
  z = state.z;
  for (size_t w = 0; w < state.placements.size(); ++w)
    for (size_t k = 0; k < state.placements[w].size(); ++k)
      system->put_pose(static_cast<int>(w), static_cast<int>(k), state.placements[w][k].rotation,
                       state.placements[w][k].position, z);
}

bool CoupledStack::any_modelled() const {
  return std::any_of(scaled.bodies.begin(), scaled.bodies.end(),
                     [](const ScaledBody& body) { return body.modelled; });
}

double CoupledStack::largest_seam_gap() const {
  return system->joins.empty() ? 0 : largest_gap(system->joins, system->state(z).positions);
}

double CoupledStack::ring_radius() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const CoupledWall& wall : system->walls())
    for (const SectionPose& pose : wall.sections) {
      const std::vector<int>& ring = pose.section().ring;
      Points points(static_cast<Eigen::Index>(ring.size()), 3);
      for (size_t i = 0; i < ring.size(); ++i)
        points.row(static_cast<Eigen::Index>(i)) = wall.rest.row(ring[i]);
      smallest = std::min(
          smallest,
          std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean()));
    }
  return smallest;
}

}  // namespace vasorod
