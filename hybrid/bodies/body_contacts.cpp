#include "bodies/body_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bodies/contact_pair.h"
#include "bodies/held_overlap.h"
#include "bodies/reach.h"
#include "bodies/seam_band.h"
#include "bodies/self_contact.h"
#include "bodies/unmet_criteria.h"
#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "numerics/threads.h"

namespace vasorod {
namespace {

// Vertices with a gap below this many mean edges take part in a minimisation, whether they carry
// pressure or not.
constexpr double reach = 1.0;
// The same of a body and itself: its walls may come together far within one minimisation.
constexpr double self_reach = 3.0;
// A wall that has left the sections carried by its rod by less than this share of the radius of its
// narrowest end has not come together: a section is flat when its walls have moved by a radius.
constexpr double in_shape = 0.3;
// Walls that moved by less than this many mean edges have not come together since the last search.
constexpr double follow_from = 0.2;

// Width of the band around overlapping rigid ends in which contact is left out, in units of the
// overlap's depth.
constexpr double held_band = 2;

// Two changes of the multipliers are on one line where what the last one has beside that of the one
// before is below this share of it. A factor above the largest one is too uncertain to sum up.
constexpr double aside = 0.1, largest_factor = 0.95;

// The slave is the deformable body. If both deform, the slave is the body with the finer mesh,
// because its pressures resolve the contact patch better.
bool first_is_slave(const ScaledBody& a, const ScaledBody& b) {
  if (a.obstacle != b.obstacle) return b.obstacle;
  return a.mean_edge <= b.mean_edge;
}

void leave_out(const std::vector<char>& marked, std::vector<double>& share) {
  for (size_t i = 0; i < marked.size(); ++i)
    if (marked[i]) share[i] = 0;
}

// Root mean square radius of the narrowest open end, 0 where there is none.
double narrowest_end(const TriangleSurface& surface) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const std::vector<int>& loop : boundary_loops(surface.triangles)) {
    const Points ring = surface.points(loop, Eigen::all);
    narrowest = std::min(
        narrowest,
        std::sqrt((ring.rowwise() - ring.colwise().mean()).rowwise().squaredNorm().mean()));
  }
  return std::isfinite(narrowest) ? narrowest : 0;
}

}  // namespace

BodyContacts::BodyContacts(const BodyProblem& problem, const ScaledBodies& scaled, double stiffness)
    : problem_(problem), stiffness_(stiffness), walls_(scaled.bodies.size()) {
  for (const auto& [a, b] : problem.contacts) {
    const bool a_first = first_is_slave(scaled.bodies[static_cast<size_t>(a)],
                                        scaled.bodies[static_cast<size_t>(b)]);
    Pair pair;
    pair.entry = static_cast<int>(pairs_.size());
    pair.slave = a_first ? a : b;
    pair.master = a_first ? b : a;
    pairs_.push_back(std::move(pair));
  }
  // The stump of a vein begins at the vein's mouth: its vertices would seem to be deep in the wall.
  for (size_t p = 0; p < problem.contacts.size(); ++p)
    if (is_edged(pairs_[p]) && !problem.bodies[index(pairs_[p].slave)].open_mouth) exchange(p);
}

bool BodyContacts::is_edged(const Pair& pair) const {
  return problem_.bodies[index(pair.master)].edged;  // of an obstacle and a vessel the obstacle
}

void BodyContacts::exchange(size_t pair) {
  Pair exchanged;
  exchanged.entry = static_cast<int>(pair);
  exchanged.slave = pairs_[pair].master;
  exchanged.master = pairs_[pair].slave;
  exchanged.exchanged = true;
  pairs_.push_back(std::move(exchanged));
}

void BodyContacts::meet_up_to_seams() {
  if (up_to_seams_) return;
  up_to_seams_ = true;
  for (size_t p = 0; p < problem_.contacts.size(); ++p) {
    const bool own = pairs_[p].own();
    if (own ? !seam_of(pairs_[p].slave).empty() : joined(pairs_[p])) {
      pairs_[p].contact.reset();
      pairs_[p].pressed.clear();
      pairs_[p].searched.resize(0, 3);
    }
    if (!own && !seen_from_both(static_cast<int>(p))) exchange(p);
  }
  allowed_ = 1;
  for (Pair& pair : pairs_)
    if (pair.contact) pair.contact->start_parting();
}

void BodyContacts::allow(double share) {
  allowed_ = share;
  for (Pair& pair : pairs_)
    if (pair.contact) pair.contact->allow(share);
}

void BodyContacts::walls_are_parted() {
  parted_ = true;
  for (Pair& pair : pairs_)
    if (pair.contact) pair.contact->walls_are_parted();
}

void BodyContacts::forget() {
  expected_.clear();
  for (Pair& pair : pairs_) {
    pair.contact.reset();
    pair.pressed.clear();
    pair.searched.resize(0, 3);
  }
}

bool BodyContacts::joined(const Pair& pair) const {
  return std::any_of(problem_.seams.begin(), problem_.seams.end(), [&](const SeamPair& seam) {
    return std::minmax(seam.body_a, seam.body_b) == std::minmax(pair.slave, pair.master);
  });
}

std::vector<int> BodyContacts::seam_of(int body) const {
  std::vector<int> seam;
  for (const SeamPair& joined : problem_.seams) {
    if (joined.body_a == body) seam.push_back(joined.vertex_a);
    if (joined.body_b == body) seam.push_back(joined.vertex_b);
  }
  return seam;
}

double BodyContacts::stiffness_of(const Pair& pair, const ScaledBodies& scaled) const {
  double k = std::numeric_limits<double>::infinity();
  for (const int index : {pair.slave, pair.master}) {
    const ScaledBody& body = scaled.bodies[static_cast<size_t>(index)];
    if (!body.obstacle)
      k = std::min(k, stiffness_ * (body.k.bending + body.k.stretching) / body.mean_area);
  }
  return k;
}

// Left out are the seam, before walls meet up to it, and what a rigid section holds.
std::unique_ptr<FoundContacts> BodyContacts::within(const Pair& pair,
                                                    const ScaledBodies& scaled) const {
  const ScaledBody& body = scaled.bodies[static_cast<size_t>(pair.slave)];
  std::vector<int> seam = seam_of(pair.slave);
  std::vector<double> share(index(body.rest.points.rows()), 1);
  if (!up_to_seams_) leave_out(seam_band(body.rest, seam, body.thickness), share);
  leave_out(body.fixed, share);
  ContactSide side{
      wall_of(pair.slave, scaled), body.offset, std::move(share), !seam.empty(), up_to_seams_, {}};
  if (up_to_seams_) side.seam = std::move(seam);
  return std::make_unique<SelfContact>(std::move(side), body.thickness, stiffness_of(pair, scaled));
}

ContactWall BodyContacts::wall_of(int body, const ScaledBodies& scaled) const {
  const std::lock_guard lock(making_walls_);
  std::optional<ContactWall>& wall = walls_[index(body)];
  if (!wall) wall.emplace(scaled.bodies[index(body)].rest);
  return *wall;
}

bool BodyContacts::keeps_its_shape(Pair& pair, const ScaledBody& body) {
  if (pair.shape < 0) pair.shape = in_shape * narrowest_end(body.rest);
  return (body.now - body.placed).rowwise().squaredNorm().maxCoeff() < pair.shape * pair.shape;
}

std::unique_ptr<FoundContacts> BodyContacts::between(Pair& pair, const ScaledBodies& scaled) const {
  std::vector<int> slave_seam, master_seam;
  for (const SeamPair& seam : problem_.seams)
    for (const auto& [body_a, vertex_a, body_b, vertex_b] :
         {SeamPair{seam.body_a, seam.vertex_a, seam.body_b, seam.vertex_b},
          SeamPair{seam.body_b, seam.vertex_b, seam.body_a, seam.vertex_a}})
      if (body_a == pair.slave && body_b == pair.master) {
        slave_seam.push_back(vertex_a);
        master_seam.push_back(vertex_b);
      }
  const auto held = [&](int index) {
    const ScaledBody& body = scaled.bodies[static_cast<size_t>(index)];
    ContactWall wall = wall_of(index, scaled);
    return HeldBody{wall.at_rest(), wall.carried_to(body.carried), body.fixed, body.offset};
  };
  const HeldOverlap overlap = held_overlap(held(pair.slave), held(pair.master));
  pair.held_depth = overlap.depth;
  const auto side = [&](int index, const std::vector<int>& seam,
                        const std::vector<int>& overlapping) {
    const ScaledBody& body = scaled.bodies[static_cast<size_t>(index)];
    std::vector<double> share = seam_share(body.rest, seam, body.thickness, up_to_seams_ ? 0 : 1);
    // Two mean edges are subtracted because seam_band() adds them.
    leave_out(seam_band(body.rest, overlapping, held_band * overlap.depth - 2 * body.mean_edge),
              share);
    return ContactSide{wall_of(index, scaled),          body.offset,  std::move(share),
                       pair.exchanged || !seam.empty(), up_to_seams_, {}};
  };
  return std::make_unique<ContactPair>(side(pair.slave, slave_seam, overlap.in_a),
                                       side(pair.master, master_seam, overlap.in_b),
                                       stiffness_of(pair, scaled));
}

// What one pair adds to the state after a minimisation.
BodyContacts::Searched BodyContacts::search(Pair& pair, const ScaledBodies& scaled,
                                            Features features) const {
  Searched found;
  const ScaledBody &slave = scaled.bodies[static_cast<size_t>(pair.slave)],
                   &master = scaled.bodies[static_cast<size_t>(pair.master)];
  if (pair.own() && without_own_) return found;
  const bool live = slave.modelled || master.modelled;
  const double margin = reach + slave.offset + master.offset;
  if (!pair.contact && live) {
    if (pair.own() && !keeps_its_shape(pair, slave))
      pair.contact = within(pair, scaled);
    else if (!pair.own() && vasorod::within_reach(box_of(slave.now), box_of(master.now), margin))
      pair.contact = between(pair, scaled);
    if (pair.contact && !pair.own() && !pair.exchanged && !expected_.empty())
      pair.contact->expect(expected_[index(pair.slave)]);
    if (pair.contact && hold_) pair.contact->hold();
    if (pair.contact && parted_) pair.contact->walls_are_parted();
    if (pair.contact && allowed_ > 0) {
      pair.contact->start_parting();
      pair.contact->allow(allowed_);
    }
  }
  if (!pair.contact) return found;
  pair.in_reach |= !pair.own();
  for (const ContactPoint& c : pair.contact->contacts())
    if (c.stick > 0 && (pair.own() || master.modelled))
      found.state.slip = std::max(found.state.slip, FoundContacts::slip(c, slave.now, master.now));
  std::tie(found.change, found.sum) = pair.contact->update_multipliers(slave.now, master.now);
  if (features == Features::anew) {
    pair.contact->refresh(slave.now, master.now, pair.own() ? self_reach : reach);
    if (pair.own()) pair.searched = slave.now;
  } else {
    pair.contact->hold_here(slave.now, master.now);
  }
  std::vector<int> pressed;
  for (const ContactPoint& c : pair.contact->contacts()) {
    const double gap = FoundContacts::gap(c, slave.now, master.now);
    found.state.penetration = std::max(found.state.penetration, -gap);
    if (c.multiplier - c.stiffness * gap > 0) pressed.push_back(c.slave);
  }
  found.state.pressed_changed = pressed != pair.pressed;
  pair.pressed = std::move(pressed);
  if (!pair.pressed.empty()) {
    pair.in_reach = true;
    if (!slave.modelled && !slave.obstacle) found.state.touched.push_back(pair.slave);
    if (!master.modelled && !master.obstacle) found.state.touched.push_back(pair.master);
  }
  return found;
}

ContactState BodyContacts::refresh(const ScaledBodies& scaled) {
  return state(scaled, Features::anew);
}

ContactState BodyContacts::update(const ScaledBodies& scaled) {
  return state(scaled, Features::as_found);
}

ContactState BodyContacts::state(const ScaledBodies& scaled, Features features) {
  std::vector<Searched> found(pairs_.size());
  in_parallel(threads(), static_cast<int>(pairs_.size()),
              [&](int p) { found[index(p)] = search(pairs_[index(p)], scaled, features); });
  ContactState state;
  double change = 0, sum = 0;
  for (const Searched& one : found) {
    change += one.change;
    sum += one.sum;
    state.slip = std::max(state.slip, one.state.slip);
    state.penetration = std::max(state.penetration, one.state.penetration);
    state.pressed_changed |= one.state.pressed_changed;
    state.touched.insert(state.touched.end(), one.state.touched.begin(), one.state.touched.end());
  }
  state.force_change = change > 0 ? change / std::max(sum, 1e-300) : 0;
  return state;
}

bool BodyContacts::extrapolate() {
  FoundContacts::Changes all;
  for (const Pair& pair : pairs_) {
    if (!pair.contact) continue;
    const FoundContacts::Changes mine = pair.contact->changes();
    all.last += mine.last;
    all.before += mine.before;
    all.product += mine.product;
  }
  if (!(all.before > 0)) return false;
  const double factor = all.product / all.before;
  const double across = all.last - factor * all.product;  // to the change before, squared
  if (!(factor > 0) || factor > largest_factor || across > aside * aside * all.last) return false;
  for (Pair& pair : pairs_)
    if (pair.contact) pair.contact->go_on(factor / (1 - factor));
  return true;
}

bool BodyContacts::follow(const ScaledBodies& scaled) {
  bool searched = false;
  for (Pair& pair : pairs_) {
    const ScaledBody& body = scaled.bodies[static_cast<size_t>(pair.slave)];
    if (!pair.own() || without_own_ || !body.modelled) continue;
    if (pair.searched.rows() == body.now.rows() &&
        (body.now - pair.searched).rowwise().norm().maxCoeff() < follow_from)
      continue;
    if (!pair.contact && keeps_its_shape(pair, body)) continue;
    if (!pair.contact) pair.contact = within(pair, scaled);
    pair.contact->refresh(body.now, body.now, self_reach);
    pair.searched = body.now;
    searched = true;
  }
  return searched;
}

StackedContacts BodyContacts::stacked(const ScaledBodies& scaled,
                                      const std::vector<int>& first) const {
  StackedContacts all;
  for (size_t p = 0; p < pairs_.size(); ++p) {
    const Pair& pair = pairs_[p];
    const int slave = first[static_cast<size_t>(pair.slave)],
              master = first[static_cast<size_t>(pair.master)];
    if (!pair.contact || std::max(slave, master) < 0) continue;
    const Points &still_slave = scaled.bodies[static_cast<size_t>(pair.slave)].now,
                 &still = scaled.bodies[static_cast<size_t>(pair.master)].now;
    for (ContactPoint c : pair.contact->contacts()) {
      all.pair.push_back(pair.entry);
      all.bodies.push_back({pair.slave, pair.master});
      all.slave.push_back(c.slave);
      all.master.push_back(c.master);
      if (slave >= 0) {
        c.slave += slave;
      } else {
        c.slack -= c.normal.dot(still_slave.row(c.slave));
        c.held -= still_slave.row(c.slave);
        c.slave = -1;
      }
      if (master >= 0) {
        for (int& m : c.master) m += master;
      } else {
        for (size_t k = 0; k < 3; ++k)
          c.slack += c.weight[static_cast<int>(k)] * c.normal.dot(still.row(c.master[k]));
        c.master = {-1, -1, -1};
        c.stick = 0;
      }
      all.points.push_back(c);
    }
  }
  return all;
}

double BodyContacts::gap_from_itself(const ScaledBodies& scaled) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs_) {
    if (!pair.own() || !pair.contact) continue;
    const Points& now = scaled.bodies[static_cast<size_t>(pair.slave)].now;
    for (const ContactPoint& c : pair.contact->contacts())
      smallest = std::min(smallest, FoundContacts::gap(c, now, now));
  }
  return smallest;
}

void BodyContacts::hold() {
  hold_ = true;
  for (Pair& pair : pairs_)
    if (pair.contact) pair.contact->hold();
}

bool BodyContacts::pressing() const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [](const Pair& pair) { return !pair.pressed.empty(); });
}

bool BodyContacts::seen_from_both(int pair) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const Pair& other) { return other.exchanged && other.entry == pair; });
}

int BodyContacts::swallowed(int pair) const {
  const auto& contact = pairs_[static_cast<size_t>(pair)].contact;
  return contact ? contact->swallowed() : 0;
}

double BodyContacts::smallest_gap(int pair, const ScaledBodies& scaled, bool search) {
  Pair& mine = pairs_[static_cast<size_t>(pair)];
  double smallest = std::numeric_limits<double>::infinity();
  if (!mine.contact) return smallest;
  const Points &slave = scaled.bodies[static_cast<size_t>(mine.slave)].now,
               &master = scaled.bodies[static_cast<size_t>(mine.master)].now;
  if (search && !mine.own()) {
    // Growing, so that of two large walls only what is nearly nearest is looked at.
    const double farthest = box_of(slave).merged(box_of(master)).diagonal().norm();
    for (double far = reach; mine.contact->contacts().empty() && far < 2 * farthest; far *= 2)
      mine.contact->refresh(slave, master, far);
  }
  for (const ContactPoint& c : mine.contact->contacts())
    smallest = std::min(smallest, FoundContacts::gap(c, slave, master));
  return smallest;
}

bool is_settled(const ContactState& state, const SurfaceOptions& options, double slackness) {
  return state.touched.empty() && state.penetration <= slackness * options.contact_tolerance &&
         state.slip <= slackness * options.slip_tolerance &&
         state.force_change <= slackness * options.pressure_tolerance;
}

void require_contact(const ContactState& state, const SurfaceOptions& options,
                     UnmetCriteria& unmet) {
  unmet.require("penetration over the mean edge", state.penetration, options.contact_tolerance);
  unmet.require("change of the contact forces by the last update", state.force_change,
                options.pressure_tolerance);
  unmet.require("slip of walls in contact over the mean edge", state.slip, options.slip_tolerance);
  if (!state.touched.empty()) unmet.add("a vessel was touched only now");
}

}  // namespace vasorod
