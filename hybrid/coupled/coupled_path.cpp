#include "coupled/coupled_path.h"

#include <cmath>

#include "data/index.h"

namespace vasorod {
namespace {

// Of a motion to a start, in mean edges: what is shorter is blocked; and how many pieces it may
// have.
constexpr double shortest_piece = 1e-3;
constexpr int most_pieces = 200;

}  // namespace

void CoupledPath::restart() {
  blocked_ = false;
  for (const CoupledWall& wall : stack_.system->walls())
    if (wall.guard) wall.guard->remember({});
  carried_ = {};
  last_.reset();
}

CoupledPath::Carried CoupledPath::carried_at(double t) const {
  Carried all;
  const ScaledBodies& scaled = stack_.scaled;
  const std::vector<CarriedBody> given = stack_.problem.carried(t);
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    const CarriedBody& mine = given[b];
    const Points& rest = scaled.bodies[b].rest.points;
    all.points.push_back(mine.points.rows() > 0 ? stack_.scaled_points(mine.points) : rest);
    all.rotations.push_back(!mine.rotations.empty()
                                ? mine.rotations
                                : std::vector<Mat3>(index(rest.rows()), Mat3::Identity()));
    std::vector<Pose> poses = mine.sections;
    if (poses.empty() && stack_.problem.vessels[b])
      for (const HeldSection& section : stack_.problem.vessels[b]->sections)
        poses.push_back({Mat3::Identity(), section.rest.position});
    for (Pose& pose : poses) pose.position = (pose.position - scaled.origin) / scaled.length;
    all.sections.push_back(std::move(poses));
  }
  return all;
}

CoupledPath::Local CoupledPath::local_state() const {
  Local local;
  local.time = time_;
  local.z = stack_.z;
  const CoupledState state = stack_.system->state(stack_.z);
  for (size_t b = 0; b < stack_.first_wall.size(); ++b) {
    local.deviation.emplace_back();
    local.sections.emplace_back();
    if (stack_.first_wall[b] < 0) continue;
    Points& d = local.deviation.back();
    d = stack_.scaled.bodies[b].now - carried_.points[b];
    for (Eigen::Index i = 0; i < d.rows(); ++i)
      d.row(i) = (d.row(i) * carried_.rotations[b][index(i)]).eval();
    for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
      const Pose& rod = carried_.sections[b][k];
      const SectionPlacement& at = state.placements[index(stack_.first_wall[b])][k];
      local.sections.back().push_back({rod.rotation.transpose() * at.rotation,
                                       rod.rotation.transpose() * (at.position - rod.position)});
    }
  }
  return local;
}

// Passes the rotations of the rods' frames to the minimiser, for K0.
void CoupledPath::turn_minimiser(const std::vector<std::vector<Mat3>>& rotations) {
  std::vector<Mat3> frames(index(stack_.system->vertex_count()));
  std::vector<std::vector<Mat3>> section_frames;
  for (size_t b = 0; b < stack_.first_wall.size(); ++b) {
    if (stack_.first_wall[b] < 0) continue;
    std::copy(rotations[b].begin(), rotations[b].end(), frames.begin() + stack_.first[b]);
    section_frames.emplace_back();
    for (const Pose& pose : carried_.sections[b]) section_frames.back().push_back(pose.rotation);
  }
  stack_.minimiser->set_turns(stack_.system->turns(frames, section_frames));
  frames_ = rotations;
}

bool CoupledPath::advance(double t) {
  const bool first = carried_.points.empty();
  const std::optional<Local> before = std::move(last_);
  if (first)
    last_.reset();
  else
    last_ = local_state();
  const bool guarded = !first && stack_.system->guarded();
  const Points from = guarded ? stack_.system->state(stack_.z).positions : Points();
  time_ = t;
  carried_ = carried_at(t);
  for (size_t b = 0; b < carried_.points.size(); ++b)
    stack_.scaled.bodies[b].placed = carried_.points[b];
  stack_.system->set_time(t);
  const bool line =
      before && last_ && before->z.size() == last_->z.size() && last_->time > before->time;
  place(line ? &*before : nullptr);
  blocked_ = false;
  if (guarded && !leads_here(from)) {
    hold_back();
    blocked_ = !leads_here(from);
  }
  turn_minimiser(carried_.rotations);
  return !first;
}

void CoupledPath::hold_back() {
  stack_.z = last_->z;
  place(nullptr);
}

// Whether the motion from `last` (stacked positions) to the start takes no guarded wall through
// itself. It is looked at in pieces, as long as CrossingGuard takes at once.
bool CoupledPath::leads_here(const Points& last) const {
  const Points to = stack_.system->state(stack_.z).positions;
  Points at = last;
  for (int piece = 0; piece < most_pieces; ++piece) {
    const double share = stack_.system->longest_share(at, to);
    if (share == 1) return true;
    if (share * (to - at).rowwise().norm().maxCoeff() < shortest_piece) return false;
    at += share * (to - at);
  }
  return false;
}

// The start on the line from `before` through the last state, or where that is null, with the last
// state's deviation; without a last state, as the rods carry.
void CoupledPath::place(const Local* before) {
  CoupledSystem& system = *stack_.system;
  const double along = before ? (time_ - last_->time) / (last_->time - before->time) : 0;
  if (before) stack_.z = last_->z + along * (last_->z - before->z);
  for (size_t b = 0; b < stack_.first_wall.size(); ++b) {
    const int w = stack_.first_wall[b];
    if (w < 0) continue;
    Points x = carried_.points[b];
    for (Eigen::Index i = 0; last_ && i < x.rows(); ++i) {
      Vec3 deviation = last_->deviation[b].row(i);
      if (before)
        deviation += along * (last_->deviation[b].row(i) - before->deviation[b].row(i)).transpose();
      x.row(i) += (carried_.rotations[b][index(i)] * deviation).transpose();
    }
    system.put(w, x, last_.has_value(), stack_.z);
    for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
      Pose pose = carried_.sections[b][k];
      if (time_ < 1) system.set_target(w, static_cast<int>(k), pose);
      if (last_) pose = pose * last_->sections[b][k];
      system.put_pose(w, static_cast<int>(k), pose.rotation, pose.position, stack_.z);
    }
  }
  stack_.unstack();
}

void CoupledPath::start_at_given() {
  CoupledSystem& system = *stack_.system;
  for (size_t b = 0; b < stack_.first_wall.size(); ++b) {
    const CarriedBody& start = stack_.problem.start->bodies[b];
    const int w = stack_.first_wall[b];
    if (w < 0 || start.points.rows() == 0) continue;
    system.put(w, stack_.scaled_points(start.points), false, stack_.z);
    for (size_t k = 0; k < start.sections.size(); ++k)
      system.put_pose(w, static_cast<int>(k), start.sections[k].rotation,
                      (start.sections[k].position - stack_.scaled.origin) / stack_.scaled.length,
                      stack_.z);
  }
  std::vector<std::vector<Mat3>> rotations = carried_.rotations;
  for (size_t b = 0; b < rotations.size(); ++b)
    if (const auto& found = stack_.problem.start->bodies[b].rotations; !found.empty())
      rotations[b] = found;
  turn_minimiser(rotations);
  stack_.unstack();
}

CoupledPath::Kept CoupledPath::keep() const {
  Kept kept{time_, carried_, last_, stack_.first_wall, {}, stack_.system->state(stack_.z), {}};
  for (const CoupledWall& wall : stack_.system->walls())
    if (wall.guard) kept.guards.push_back(wall.guard->memory());
  for (const ScaledBody& body : stack_.scaled.bodies) kept.now.push_back(body.now);
  return kept;
}

void CoupledPath::restore(const Kept& kept) {
  time_ = kept.time;
  carried_ = kept.carried;
  last_ = kept.last;
  stack_.system->set_time(time_);
  for (size_t b = 0; b < kept.now.size(); ++b) {
    stack_.scaled.bodies[b].now = kept.now[b];
    stack_.scaled.bodies[b].placed = carried_.points[b];
  }
  put_bodies(kept.first_wall, kept.state);
  turn_minimiser(carried_.rotations);
  blocked_ = false;
  for (size_t b = 0; time_ < 1 && b < stack_.first_wall.size(); ++b)
    for (size_t k = 0; stack_.first_wall[b] >= 0 && k < carried_.sections[b].size(); ++k)
      stack_.system->set_target(stack_.first_wall[b], static_cast<int>(k), carried_.sections[b][k]);
  if (kept.first_wall != stack_.first_wall) return;  // the others' guards keep what they know
  auto memory = kept.guards.begin();
  for (const CoupledWall& wall : stack_.system->walls())
    if (wall.guard) wall.guard->remember(*memory++);
}

void CoupledPath::take_back(const Kept& kept) {
  restore(kept);
  stack_.contacts->forget();
  stack_.search_contacts();
}

bool CoupledPath::is_possible() const {
  Eigen::VectorXd g;
  return !stack_.system->guarded() ||
         (!blocked_ && std::isfinite(stack_.system->gradient(stack_.z, g).total()));
}

void CoupledPath::rebuild() {
  const std::vector<int> old_wall = stack_.first_wall;
  const CoupledState before = stack_.system->state(stack_.z);
  stack_.build();
  stack_.system->set_time(time_);
  put_bodies(old_wall, before);
  turn_minimiser(carried_.rotations);
}

bool CoupledPath::narrow(Patch patch) {
  if (!stack_.narrow(patch)) return false;
  turn_minimiser(frames_);
  return true;
}

void CoupledPath::widen() {
  if (!stack_.is_narrow()) return;
  stack_.unstack();
  const CoupledState before = stack_.system->state(stack_.z);
  stack_.widen();
  put_bodies(stack_.first_wall, before);
}

// The bodies where they are now, in z: what had a wall in `before` with its edges and sections,
// other sections where the rods carry them.
void CoupledPath::put_bodies(const std::vector<int>& wall_before, const CoupledState& before) {
  CoupledSystem& system = *stack_.system;
  for (size_t b = 0; b < stack_.first_wall.size(); ++b) {
    const int w = stack_.first_wall[b];
    if (w < 0) continue;
    const int old = wall_before[b];
    system.put(w, stack_.scaled.bodies[b].now, false, stack_.z);
    if (old >= 0) system.put_edges(w, before.q[index(old)], stack_.z);
    for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
      Pose pose = carried_.sections[b][k];
      if (old >= 0)
        pose = {before.placements[index(old)][k].rotation,
                before.placements[index(old)][k].position};
      system.put_pose(w, static_cast<int>(k), pose.rotation, pose.position, stack_.z);
    }
  }
}

}  // namespace vasorod
