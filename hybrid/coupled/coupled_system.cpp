#include "coupled/coupled_system.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "numerics/threads.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

}  // namespace

int CoupledSystem::add_wall(WallEnergy& energy, const Points& rest,
                            const std::vector<HeldSection>& sections, double tie_stiffness,
                            const WallPatch* patch) {
  CoupledWall wall;
  if (patch) {
    wall.part = energy.part(patch->moves);
    wall.held = patch->held;
  }
  const auto moves = [&](int vertex) { return !patch || patch->moves[index(vertex)]; };
  wall.energy = &energy;
  wall.rest = rest;
  wall.first_vertex = vertices_;
  const VectorXd q0 = energy.rest();
  const int vertices = energy.vertices();
  std::vector<int> section_of(index(vertices), -1);
  for (size_t s = 0; s < sections.size(); ++s) {
    wall.sections.emplace_back(sections[s]);
    wall.ties.emplace_back();
    if (sections[s].rigid)
      for (const int v : sections[s].ring) section_of[index(v)] = static_cast<int>(s);
    else
      wall.ties.back().emplace(sections[s], rest, tie_stiffness);
  }
  wall.unknown.assign(index(q0.size()), -1);
  wall.carried_at.assign(index(q0.size()), -1);
  const auto carry = [&](int entry, int section, bool normal, const Vec3& arm) {
    for (int k = 0; k < 3; ++k)
      wall.carried_at[index(entry + k)] = 3 * static_cast<int>(wall.carried.size()) + k;
    wall.carried.push_back({entry, section, normal, arm});
  };
  for (int v = 0; v < vertices; ++v) {
    const int section = section_of[index(v)];
    if (section >= 0) {
      carry(3 * v, section, false, Vec3(rest.row(v)) - sections[index(section)].rest.position);
      continue;
    }
    if (!moves(v)) continue;
    groups_.push_back(unknowns_);
    for (int k = 0; k < 3; ++k) wall.unknown[index(3 * v + k)] = unknowns_++;
  }
  for (const WallEdge& edge : energy.edges()) {
    if (edge.glued) {
      carry(edge.unknown, section_of[index(edge.a)], true, q0.segment<3>(edge.unknown));
      continue;
    }
    if (!moves(edge.a) && !moves(edge.b)) continue;
    groups_.push_back(unknowns_);
    wall.unknown[index(edge.unknown)] = unknowns_++;
  }
  for (const WallLean& lean : energy.leans()) {
    if (!moves(lean.vertex)) continue;
    groups_.push_back(unknowns_);
    wall.unknown[index(lean.unknown)] = unknowns_++;
  }
  for (const SectionPose& pose : wall.sections) {
    wall.pose_unknown.push_back(unknowns_);
    if (pose.unknowns() > 0) groups_.push_back(unknowns_);
    unknowns_ += pose.unknowns();
  }
  wall_of_.insert(wall_of_.end(), index(vertices), static_cast<int>(walls_.size()));
  vertices_ += vertices;
  walls_.push_back(std::move(wall));
  return static_cast<int>(walls_.size()) - 1;
}

void CoupledSystem::set_lumen(int w, WallLumen lumen) {
  lumen.now = lumen.scan;
  walls_[index(w)].lumen = std::move(lumen);
}

void CoupledSystem::set_guard(int w, std::shared_ptr<CrossingGuard> guard) {
  walls_[index(w)].guard = std::move(guard);
}

bool CoupledSystem::guarded() const {
  return std::any_of(walls_.begin(), walls_.end(),
                     [](const CoupledWall& wall) { return wall.guard != nullptr; });
}

double CoupledSystem::longest_share(const VectorXd& z, const VectorXd& direction) const {
  return longest_share(state(z).positions, state(z + direction).positions);
}

double CoupledSystem::longest_share(const Points& from, const Points& to) const {
  double share = 1;
  for (const CoupledWall& wall : walls_)
    if (wall.guard) {
      const int vertices = wall.energy->vertices();
      share = std::min(share, wall.guard->longest_step(from.middleRows(wall.first_vertex, vertices),
                                                       to.middleRows(wall.first_vertex, vertices)));
    }
  return share;
}

void CoupledSystem::set_time(double t) {
  for (CoupledWall& wall : walls_)
    for (SectionPose& pose : wall.sections) pose.set_time(t);
  time_ = t;
  set_pressures();
}

void CoupledSystem::set_inflation(double share) {
  inflation_ = share;
  set_pressures();
}

void CoupledSystem::set_pressures() {
  for (CoupledWall& wall : walls_) {
    if (!wall.lumen) continue;
    WallLumen& lumen = *wall.lumen;
    lumen.now = lumen.scan + time_ * (lumen.after - lumen.scan) + inflation_ * lumen.inflation;
  }
}

void CoupledSystem::set_target(int w, int section, const Pose& pose) {
  walls_[index(w)].sections[index(section)].set_target(pose);
}

double CoupledSystem::recentre(VectorXd& z) {
  double change = 0;
  for (CoupledWall& wall : walls_)
    for (size_t s = 0; s < wall.sections.size(); ++s)
      change = std::max(change, wall.sections[s].recentre(z.data() + wall.pose_unknown[s]));
  return change;
}

bool CoupledSystem::has_ties() const {
  for (const CoupledWall& wall : walls_)
    for (const auto& tie : wall.ties)
      if (tie) return true;
  return false;
}

void CoupledSystem::update_ties(const VectorXd& z) {
  const CoupledState s = state(z);
  for (size_t w = 0; w < walls_.size(); ++w)
    for (size_t k = 0; k < walls_[w].ties.size(); ++k)
      if (walls_[w].ties[k])
        walls_[w].ties[k]->update_multipliers(
            s.placements[w][k],
            s.positions.middleRows(walls_[w].first_vertex, walls_[w].energy->vertices()));
}

double CoupledSystem::worst_tie(const VectorXd& z) const {
  const CoupledState s = state(z);
  double worst = 0;
  for (size_t w = 0; w < walls_.size(); ++w)
    for (size_t k = 0; k < walls_[w].ties.size(); ++k)
      if (walls_[w].ties[k])
        worst = std::max(
            worst, walls_[w].ties[k]->relative_misfit(
                       s.placements[w][k], s.positions.middleRows(walls_[w].first_vertex,
                                                                  walls_[w].energy->vertices())));
  return worst;
}

void CoupledSystem::put(int w, const Points& x, bool keep_edges, VectorXd& z) {
  if (z.size() != unknowns_) z.setZero(unknowns_);
  const CoupledWall& wall = walls_[index(w)];
  const int vertices = wall.energy->vertices();
  for (int v = 0; v < vertices; ++v)
    if (wall.unknown[index(3 * v)] >= 0) z.segment<3>(wall.unknown[index(3 * v)]) = x.row(v);
  if (keep_edges) return;
  const auto reset = [&](int entry) {
    if (wall.unknown[index(entry)] >= 0) z[wall.unknown[index(entry)]] = 0;
  };
  for (const WallEdge& edge : wall.energy->edges())
    if (!edge.glued) reset(edge.unknown);
  for (const WallLean& lean : wall.energy->leans()) reset(lean.unknown);
}

void CoupledSystem::put_pose(int w, int section, const Mat3& rotation, const Vec3& position,
                             VectorXd& z) {
  if (z.size() != unknowns_) z.setZero(unknowns_);
  CoupledWall& wall = walls_[index(w)];
  wall.sections[index(section)].unknowns_of(rotation, position,
                                            z.data() + wall.pose_unknown[index(section)]);
}

void CoupledSystem::put_edges(int w, const VectorXd& q, VectorXd& z) {
  const CoupledWall& wall = walls_[index(w)];
  for (size_t i = 3 * index(wall.energy->vertices()); i < wall.unknown.size(); ++i)
    if (wall.unknown[i] >= 0) z[wall.unknown[i]] = q[static_cast<Eigen::Index>(i)];
}

void CoupledSystem::set_sections(int w, const std::vector<HeldSection>& sections) {
  CoupledWall& wall = walls_[index(w)];
  for (size_t k = 0; k < sections.size(); ++k) wall.sections[k] = SectionPose(sections[k]);
}

void CoupledSystem::set_energy(int w, WallEnergy& energy) {
  walls_[index(w)].energy = &energy;
}

bool CoupledSystem::has_potential() const {
  return std::all_of(walls_.begin(), walls_.end(), [](const CoupledWall& wall) {
    return std::all_of(wall.sections.begin(), wall.sections.end(),
                       [](const SectionPose& pose) { return pose.has_potential(); });
  });
}

double CoupledSystem::largest_load() const {
  double largest = 0;
  for (const CoupledWall& wall : walls_)
    for (const SectionPose& pose : wall.sections)
      if (pose.unknowns() > 0)
        largest = std::max({largest, pose.time() * pose.section().force.norm(),
                            pose.time() * pose.section().moment.norm(),
                            pose.time() * pose.section().body_moment.norm()});
  return largest;
}

double CoupledSystem::largest_moment() const {
  double largest = 0;
  for (const CoupledWall& wall : walls_)
    for (const SectionPose& pose : wall.sections)
      largest =
          std::max({largest, pose.section().moment.norm(), pose.section().body_moment.norm()});
  return largest;
}

CoupledState CoupledSystem::state(const VectorXd& z) const {
  CoupledState s;
  s.positions.resize(vertices_, 3);
  for (const CoupledWall& wall : walls_) {
    VectorXd q(static_cast<Eigen::Index>(wall.unknown.size()));
    if (wall.part) q = wall.held;
    for (size_t i = 0; i < wall.unknown.size(); ++i)
      if (wall.unknown[i] >= 0) q[static_cast<Eigen::Index>(i)] = z[wall.unknown[i]];
    std::vector<SectionPlacement> placements;
    for (size_t k = 0; k < wall.sections.size(); ++k)
      placements.push_back(wall.sections[k].place(z.data() + wall.pose_unknown[k]));
    for (const CoupledWall::Carried& c : wall.carried) {
      const SectionPlacement& at = placements[index(c.section)];
      q.segment<3>(c.entry) = at.rotation * c.arm;
      if (!c.normal) q.segment<3>(c.entry) += at.position;
    }
    const int vertices = wall.energy->vertices();
    s.positions.middleRows(wall.first_vertex, vertices) =
        Eigen::Map<const Points>(q.data(), vertices, 3);
    s.q.push_back(std::move(q));
    s.placements.push_back(std::move(placements));
  }
  return s;
}

// Sum of all forces on the entries of q of a wall.
VectorXd CoupledSystem::total_force(size_t w, const CoupledForces& f) const {
  const CoupledWall& wall = walls_[w];
  const int vertices = wall.energy->vertices();
  VectorXd total = f.wall[w];
  Eigen::Map<Points>(total.data(), vertices, 3) +=
      f.joining.middleRows(wall.first_vertex, vertices) +
      f.contact.middleRows(wall.first_vertex, vertices) +
      f.guard.middleRows(wall.first_vertex, vertices) +
      f.ties.middleRows(wall.first_vertex, vertices) +
      f.pressure.middleRows(wall.first_vertex, vertices);
  return total;
}

CoupledTerms CoupledSystem::gradient(const VectorXd& z, VectorXd& g, CoupledForces* forces) const {
  const CoupledState s = state(z);
  CoupledForces own;
  CoupledForces& f = forces ? *forces : own;
  CoupledTerms terms;
  evaluate(s, z, f, terms);
  g.setZero(unknowns_);
  for (size_t w = 0; w < walls_.size(); ++w) {
    const CoupledWall& wall = walls_[w];
    const VectorXd total = total_force(w, f);
    for (size_t i = 0; i < wall.unknown.size(); ++i)
      if (wall.unknown[i] >= 0) g[wall.unknown[i]] += total[static_cast<Eigen::Index>(i)];
    for (const CoupledWall::Carried& c : wall.carried) {
      const SectionPlacement& at = s.placements[w][index(c.section)];
      const Eigen::Index m = at.position_axes.cols();
      if (m == 0) continue;
      const Vec3 force = total.segment<3>(c.entry), a = at.rotation * c.arm;
      auto pose = g.segment(wall.pose_unknown[index(c.section)], m);
      pose += at.rotation_axes.transpose() * a.cross(force);
      if (!c.normal) pose += at.position_axes.transpose() * force;
    }
    for (size_t k = 0; k < wall.sections.size(); ++k)
      g.segment(wall.pose_unknown[k], wall.sections[k].unknowns()) +=
          f.pose[w][k].head(wall.sections[k].unknowns());
  }
  return terms;
}

void CoupledSystem::evaluate(const CoupledState& s, const VectorXd& z, CoupledForces& f,
                             CoupledTerms& terms) const {
  f.wall.resize(walls_.size());
  f.pose.resize(walls_.size());
  f.joining = f.contact = f.guard = f.ties = f.pressure = Points::Zero(vertices_, 3);
  std::vector<CoupledTerms> of_wall(walls_.size());
  in_parallel(threads(), static_cast<int>(walls_.size()),
              [&](int w) { evaluate_wall(index(w), s, z, f, of_wall[index(w)]); });
  for (const CoupledTerms& own : of_wall) {
    terms.wall += own.wall;
    terms.pressure += own.pressure;
    terms.load += own.load;
    terms.ties += own.ties;
  }
  if (!joins.empty()) terms.joining = joining_energy_gradient(k_j, joins, s.positions, f.joining);
  if (!contacts.empty()) terms.contact = contact_energy_gradient(contacts, s.positions, f.contact);
  for (const CoupledWall& wall : walls_)
    if (wall.guard) {
      const int vertices = wall.energy->vertices();
      terms.contact += wall.guard->gradient(s.positions.middleRows(wall.first_vertex, vertices),
                                            f.guard.middleRows(wall.first_vertex, vertices));
    }
}

void CoupledSystem::evaluate_wall(size_t w, const CoupledState& s, const VectorXd& z,
                                  CoupledForces& f, CoupledTerms& terms) const {
  const CoupledWall& wall = walls_[w];
  terms.wall = wall.part ? wall.energy->gradient(s.q[w], f.wall[w], *wall.part)
                         : wall.energy->gradient(s.q[w], f.wall[w]);
  f.pose[w].assign(wall.sections.size(), Vec6::Zero());
  const int vertices = wall.energy->vertices();
  if (wall.lumen) {
    Points pressed = Points::Zero(vertices, 3);
    terms.pressure = -wall.lumen->now * wall.lumen->volume.add_gradient(
                                            s.positions.middleRows(wall.first_vertex, vertices),
                                            -wall.lumen->now, pressed);
    f.pressure.middleRows(wall.first_vertex, vertices) = pressed;
  }
  Points tied;
  for (size_t k = 0; k < wall.sections.size(); ++k) {
    const SectionPlacement& at = s.placements[w][k];
    terms.load += wall.sections[k].load(at, z.data() + wall.pose_unknown[k], f.pose[w][k]);
    if (!wall.ties[k]) continue;
    if (tied.rows() == 0) tied.setZero(vertices, 3);
    terms.ties += wall.ties[k]->gradient(at, s.positions.middleRows(wall.first_vertex, vertices),
                                         tied, f.pose[w][k]);
  }
  if (tied.rows() > 0) f.ties.middleRows(wall.first_vertex, vertices) = tied;
}

GroupTurns CoupledSystem::turns(const std::vector<Mat3>& frames,
                                const std::vector<std::vector<Mat3>>& section_frames) const {
  GroupTurns d(groups_, unknowns_);
  const auto group_at = [&](int unknown) {
    return index(std::lower_bound(groups_.begin(), groups_.end(), unknown) - groups_.begin());
  };
  for (size_t w = 0; w < walls_.size(); ++w) {
    const CoupledWall& wall = walls_[w];
    for (int v = 0; v < wall.energy->vertices(); ++v)
      if (wall.unknown[index(3 * v)] >= 0)
        d.set(group_at(wall.unknown[index(3 * v)]), frames[index(wall.first_vertex + v)]);
    for (size_t k = 0; k < wall.sections.size(); ++k)
      if (wall.sections[k].unknowns() > 0)
        d.set(group_at(wall.pose_unknown[k]), wall.sections[k].turned_axes(section_frames[w][k]));
  }
  return d;
}

}  // namespace vasorod
