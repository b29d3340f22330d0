// The Hessian of a CoupledSystem: the walls' own entries in a fixed pattern, plus the contributions
// of poses, ties, seams and contacts.
#include <algorithm>

#include "coupled/coupled_system.h"
#include "data/index.h"
#include "numerics/sparse_sum.h"
#include "numerics/threads.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

Reach reach_of(const CoupledWall& wall, const std::vector<SectionPlacement>& placements,
               int entry) {
  Reach r;
  const int free = wall.unknown[index(entry)];
  if (free >= 0) {
    r.count = 1;
    r.unknown[0] = free;
    r.factor[0] = 1;
    return r;
  }
  const int at = wall.carried_at[index(entry)];
  if (at < 0) return r;
  const CoupledWall::Carried& c = wall.carried[index(at / 3)];
  const SectionPlacement& place = placements[index(c.section)];
  const int first = wall.pose_unknown[index(c.section)], component = at % 3;
  r.count = static_cast<int>(place.position_axes.cols());
  const Vec3 a = place.rotation * c.arm;
  for (int k = 0; k < r.count; ++k) {
    const Vec3 moved = Vec3(place.rotation_axes.col(k)).cross(a);
    r.unknown[index(k)] = first + k;
    r.factor[index(k)] = moved[component] + (c.normal ? 0 : place.position_axes(component, k));
  }
  return r;
}

const Matrix& hessian_of(const CoupledWall& wall, const VectorXd& q, SecondDerivatives second) {
  return wall.part ? wall.energy->hessian(q, *wall.part, second) : wall.energy->hessian(q, second);
}

}  // namespace

// The unknowns of a wall ascend with its own entries, those of its poses follow, and those of the
// next wall: the columns and their rows come in order.
void CoupledSystem::finish() {
  Eigen::Index entries = unknowns_;
  for (const CoupledWall& wall : walls_) entries += wall.energy->pattern().nonZeros();
  base_.resize(unknowns_, unknowns_);
  base_.reserve(entries);
  int next = 0;
  const auto append = [&](int row, int column) {
    base_.insertBack(row, column) = 0;
    return next++;
  };
  slot_.clear();
  for (const CoupledWall& wall : walls_) {
    const Matrix& own = wall.energy->pattern();
    std::vector<int>& slots = slot_.emplace_back();
    slots.reserve(index(own.nonZeros()));
    for (int c = 0; c < own.cols(); ++c) {
      const int column = wall.unknown[index(c)];
      if (column >= 0) base_.startVec(column);
      for (Matrix::InnerIterator it(own, c); it; ++it) {
        const int row = wall.unknown[index(it.row())];
        slots.push_back(row < 0 || column < 0 ? -1 : append(row, column));
      }
    }
    for (size_t s = 0; s < wall.sections.size(); ++s)
      for (int k = 0; k < wall.sections[s].unknowns(); ++k) {
        base_.startVec(wall.pose_unknown[s] + k);
        append(wall.pose_unknown[s] + k, wall.pose_unknown[s] + k);
      }
  }
  base_.finalize();
}

// Adds one entry of a symmetric matrix, given once for (p, q) and (q, p), in terms of the unknowns
// that p and q depend on.
void CoupledSystem::scatter(const Reach& p, const Reach& q, bool diagonal, double value,
                            Entries& extra) {
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < (diagonal ? i + 1 : q.count); ++j) {
      const int row = p.unknown[index(i)], column = q.unknown[index(j)];
      const double part = p.factor[index(i)] * q.factor[index(j)] * value;
      extra.emplace_back(std::max(row, column), std::min(row, column),
                         !diagonal && row == column ? 2 * part : part);
    }
}

void CoupledSystem::add_wall_hessian(size_t w, const Matrix& h, const CoupledState& s,
                                     Entries& extra) {
  const CoupledWall& wall = walls_[w];
  const bool poses_free = std::any_of(wall.sections.begin(), wall.sections.end(),
                                      [](const SectionPose& pose) { return pose.unknowns() > 0; });
  double* values = base_.valuePtr();
  size_t k = 0;
  for (int column = 0; column < h.cols(); ++column)
    for (Matrix::InnerIterator it(h, column); it; ++it, ++k) {
      const int slot = slot_[w][k];
      if (slot >= 0)
        values[slot] += it.value();
      else if (poses_free)
        scatter(reach_of(wall, s.placements[w], static_cast<int>(it.row())),
                reach_of(wall, s.placements[w], column), it.row() == column, it.value(), extra);
    }
}

void CoupledSystem::add_wall_hessians(const CoupledState& s, SecondDerivatives second,
                                      Entries& extra) {
  std::vector<const Matrix*> own(walls_.size());
  in_parallel(threads(), static_cast<int>(walls_.size()),
              [&](int w) { own[index(w)] = &hessian_of(walls_[index(w)], s.q[index(w)], second); });
  std::fill_n(base_.valuePtr(), base_.nonZeros(), 0.0);
  for (size_t w = 0; w < walls_.size(); ++w) add_wall_hessian(w, *own[w], s, extra);
}

// Adds the curvature due to rotating poses, from the forces on the vertices and normals that follow
// them.
void CoupledSystem::add_pose_curvature(const CoupledState& s, const CoupledForces& f,
                                       Entries& extra) const {
  for (size_t w = 0; w < walls_.size(); ++w) {
    const CoupledWall& wall = walls_[w];
    const VectorXd total = total_force(w, f);
    std::vector<Vec3> torque(wall.sections.size(), Vec3::Zero());
    std::vector<Mat3> spread(wall.sections.size(), Mat3::Zero());
    for (const CoupledWall::Carried& c : wall.carried) {
      const Vec3 a = s.placements[w][index(c.section)].rotation * c.arm,
                 g = total.segment<3>(c.entry);
      torque[index(c.section)] += a.cross(g);
      spread[index(c.section)] += a * g.transpose() - a.dot(g) * Mat3::Identity();
    }
    for (size_t k = 0; k < wall.sections.size(); ++k) {
      const SectionPose& pose = wall.sections[k];
      if (wall.ties[k] || pose.unknowns() == 0) continue;
      const Mat6 h = pose.curvature(s.placements[w][k], torque[k], spread[k]);
      for (int i = 0; i < pose.unknowns(); ++i)
        for (int j = 0; j <= i; ++j)
          extra.emplace_back(wall.pose_unknown[k] + i, wall.pose_unknown[k] + j, h(i, j));
    }
  }
}

void CoupledSystem::add_ties(const CoupledState& s, Entries& extra) const {
  for (size_t w = 0; w < walls_.size(); ++w) {
    const CoupledWall& wall = walls_[w];
    for (size_t k = 0; k < wall.ties.size(); ++k) {
      if (!wall.ties[k]) continue;
      const Eigen::MatrixXd h =
          wall.ties[k]->hessian(wall.sections[k], s.placements[w][k],
                                s.positions.middleRows(wall.first_vertex, wall.energy->vertices()));
      std::vector<int> unknown;
      for (const int v : wall.ties[k]->ring())
        for (int c = 0; c < 3; ++c) unknown.push_back(wall.unknown[index(3 * v + c)]);
      for (int c = 0; c < wall.sections[k].unknowns(); ++c)
        unknown.push_back(wall.pose_unknown[k] + c);
      for (size_t i = 0; i < unknown.size(); ++i)
        for (size_t j = 0; j < unknown.size(); ++j)
          if (unknown[i] >= unknown[j])
            extra.emplace_back(unknown[i], unknown[j],
                               h(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
}

void CoupledSystem::add_meetings(const CoupledState& s, double blend, Entries& extra) const {
  Entries stacked;
  contact_energy_hessian(contacts, s.positions, stacked);
  for (const CoupledWall& wall : walls_)
    if (wall.guard)
      wall.guard->hessian(s.positions.middleRows(wall.first_vertex, wall.energy->vertices()), blend,
                          wall.first_vertex, stacked);
  for (const Join& join : joins)
    for (int c = 0; c < 3; ++c) {
      stacked.emplace_back(3 * join.a + c, 3 * join.a + c, 2 * k_j);
      stacked.emplace_back(3 * join.b + c, 3 * join.b + c, 2 * k_j);
      stacked.emplace_back(3 * std::max(join.a, join.b) + c, 3 * std::min(join.a, join.b) + c,
                           -2 * k_j);
    }
  add_stacked(stacked, s, extra);
}

void CoupledSystem::add_lumens(const CoupledState& s, bool at_rest, Entries& extra) const {
  Entries stacked;
  for (const CoupledWall& wall : walls_) {
    if (!wall.lumen) continue;
    const double pressure = at_rest ? wall.lumen->scan : wall.lumen->now;
    // Where the one at rest has entries, this one has them too, as the minimiser adds them up.
    if (pressure == 0 && wall.lumen->scan == 0) continue;
    const int vertices = wall.energy->vertices();
    const Points x = at_rest ? wall.rest : s.positions.middleRows(wall.first_vertex, vertices);
    wall.lumen->volume.add_hessian(x, -pressure, 3 * wall.first_vertex, stacked);
  }
  add_stacked(stacked, s, extra);
}

// Adds the lower triangle of a matrix on the stacked positions.
void CoupledSystem::add_stacked(const Entries& stacked, const CoupledState& s,
                                Entries& extra) const {
  const auto reach = [&](int stacked_entry) {
    const auto w = index(wall_of_[index(stacked_entry / 3)]);
    return reach_of(walls_[w], s.placements[w], stacked_entry - 3 * walls_[w].first_vertex);
  };
  for (const auto& entry : stacked)
    if (entry.row() >= entry.col())
      scatter(reach(entry.row()), reach(entry.col()), entry.row() == entry.col(), entry.value(),
              extra);
}

Matrix CoupledSystem::with_extra(const Entries& extra) const {
  if (extra.empty()) return base_;
  Matrix more(unknowns_, unknowns_);
  more.setFromTriplets(extra.begin(), extra.end());
  return sparse_sum(base_, more);
}

Matrix CoupledSystem::hessian(const VectorXd& z, SecondDerivatives second) {
  const CoupledState s = state(z);
  Entries extra;
  add_wall_hessians(s, second, extra);
  add_ties(s, extra);
  if (second != SecondDerivatives::all) {
    add_meetings(s, 1, extra);
    return with_extra(extra);
  }
  const bool poses_free = std::any_of(walls_.begin(), walls_.end(), [](const CoupledWall& wall) {
    return std::any_of(wall.sections.begin(), wall.sections.end(),
                       [](const SectionPose& pose) { return pose.unknowns() > 0; });
  });
  if (poses_free) {
    CoupledForces f;
    CoupledTerms terms;
    evaluate(s, z, f, terms);
    add_pose_curvature(s, f, extra);
  }
  add_meetings(s, 0, extra);
  add_lumens(s, false, extra);
  return with_extra(extra);
}

Matrix CoupledSystem::meeting_hessian(const VectorXd& z) const {
  const CoupledState s = state(z);
  Entries extra;
  add_ties(s, extra);
  add_meetings(s, 1, extra);
  Matrix all(unknowns_, unknowns_);
  all.setFromTriplets(extra.begin(), extra.end());
  return all;
}

Matrix CoupledSystem::rest_hessian() {
  CoupledState s;
  for (const CoupledWall& wall : walls_) {
    s.q.push_back(wall.energy->rest());
    s.placements.emplace_back();
    for (const SectionPose& pose : wall.sections) s.placements.back().push_back(pose.at_rest());
  }
  Entries extra;
  add_wall_hessians(s, SecondDerivatives::all, extra);
  add_lumens(s, true, extra);
  return with_extra(extra);
}

}  // namespace vasorod
