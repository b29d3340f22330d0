// The patch of a CoupledStack: a system of what is near the seam or the contacts, in which all else
// is held.
#include <utility>

#include "coupled/coupled_stack.h"
#include "data/index.h"
#include "geometry/edge_paths.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

// How far a patch reaches, over the mouth's radius.
constexpr double reach(Patch patch) {
  return patch == Patch::seam ? 1 : 2;
}
// The largest share of all unknowns with which it is worth its own solve.
constexpr double largest_patch = 0.5;

}  // namespace

// Per vertex: whether it is near, on the surface at rest, one of the seam or, where contacts count,
// one that is pressed on or expected to be.
std::vector<char> CoupledStack::in_patch(size_t b, Patch patch) const {
  std::vector<int> middle;
  for (const SeamPair& pair : problem.surfaces.seams) {
    if (pair.body_a == static_cast<int>(b)) middle.push_back(pair.vertex_a);
    if (pair.body_b == static_cast<int>(b)) middle.push_back(pair.vertex_b);
  }
  if (patch == Patch::seam_and_contacts) {
    const std::vector<int> pressed = pressed_on(b);
    middle.insert(middle.end(), pressed.begin(), pressed.end());
  }
  std::vector<char> near(index(scaled.bodies[b].rest.points.rows()), 0);
  if (middle.empty()) return near;
  for (const auto& [v, way] :
       EdgePaths(scaled.bodies[b].rest).within(middle, reach(patch) * seam_radius))
    near[index(v)] = 1;
  return near;
}

std::vector<int> CoupledStack::pressed_on(size_t b) const {
  std::vector<int> pressed;
  const Eigen::VectorXd& pressure = problem.start->pressure[b];
  for (Eigen::Index v = 0; v < pressure.size(); ++v)
    if (pressure[v] > 0) pressed.push_back(static_cast<int>(v));
  for (size_t i = 0; i < stacked.points.size(); ++i) {
    if (stacked.points[i].multiplier <= 0) continue;
    if (stacked.bodies[i][0] == static_cast<int>(b)) pressed.push_back(stacked.slave[i]);
    if (stacked.bodies[i][1] == static_cast<int>(b))
      pressed.insert(pressed.end(), stacked.master[i].begin(), stacked.master[i].end());
  }
  return pressed;
}

bool CoupledStack::narrow(Patch around) {
  const CoupledState at = system->state(z);
  Wide wide{std::move(system), std::move(minimiser), std::move(z)};
  system = std::make_unique<CoupledSystem>();
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    if (first_wall[b] < 0) continue;
    const size_t mine = index(first_wall[b]);
    std::vector<HeldSection> sections = scaled_sections(b);
    for (size_t k = 0; k < sections.size(); ++k) {
      sections[k].fixed.fill(true);
      sections[k].motion.rotate = log_rotation(at.placements[mine][k].rotation);
      sections[k].motion.move = at.placements[mine][k].position - sections[k].rest.position;
    }
    const WallPatch patch{in_patch(b, around), at.q[mine]};
    add_wall(b, sections, &patch);
  }
  if (system->unknowns() > largest_patch * wide.system->unknowns()) {
    system = std::move(wide.system);
    minimiser = std::move(wide.minimiser);
    z = std::move(wide.z);
    return false;
  }
  wide_ = std::move(wide);
  system->set_inflation(inflation_);
  system->finish();
  join();
  minimiser = std::make_unique<CoupledMinimiser>(*system, work);
  system->set_time(1);
  z.setZero(system->unknowns());
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    if (first_wall[b] < 0) continue;
    system->put(first_wall[b], scaled.bodies[b].now, false, z);
    system->put_edges(first_wall[b], at.q[index(first_wall[b])], z);
  }
  return true;
}

void CoupledStack::widen() {
  if (!wide_) return;
  system = std::move(wide_->system);
  minimiser = std::move(wide_->minimiser);
  z = std::move(wide_->z);
  wide_.reset();
  join();
}

void CoupledStack::begin_again() {
  contacts = std::make_unique<BodyContacts>(problem.surfaces, scaled, options.contact_stiffness);
  seam_multipliers_.assign(problem.surfaces.seams.size(), Vec3::Zero());
  expect_pressures();
  join();
}

bool CoupledStack::passes_through() const {
  if (!options.passes_through) return false;
  std::vector<Points> now;
  for (const ScaledBody& body : scaled.bodies)
    now.emplace_back((body.now * scaled.length).rowwise() + scaled.origin.transpose());
  return options.passes_through(now);
}

}  // namespace vasorod
