#include "rod/rod_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rigid_motion.h"

namespace vasorod {

double RodStep::size() const {
  double squared = 0;
  for (const Vec6& t : twist) {
    const double v = t.head<3>().squaredNorm(), u = t.tail<3>().squaredNorm();
    if (!std::isfinite(v + u)) return std::numeric_limits<double>::infinity();
    squared = std::max({squared, v, u});
  }
  return std::sqrt(squared);
}

RodProblem::RodProblem(const RodTree& tree, const RodConditions& conditions)
    : tree_(tree),
      given_(conditions),
      rod_(scale(tree)),
      elimination_(scaled_links(tree, rod_), node_conditions()) {
  const std::vector<NodeCondition>& all = elimination_.conditions();
  std::vector<int> condition_of(links().size() + 1, -1);
  for (std::size_t c = 0; c < all.size(); ++c)
    condition_of[index(all[c].node)] = static_cast<int>(c);
  links_at_.resize(all.size());
  follows_.assign(links().size() + 1, true);
  for (std::size_t k = links().size(); k-- > 0;) {
    const std::size_t parent = index(links()[k].parent);
    for (const std::size_t node : {parent, k + 1})
      if (const int c = condition_of[node]; c >= 0) links_at_[index(c)].push_back(k);
    if (const int c = condition_of[k + 1]; c >= 0 && all[index(c)].supported())
      follows_[k + 1] = false;
    if (!follows_[k + 1]) follows_[parent] = false;
  }
  searchable_ = has_energy() && follows_[0];
}

std::vector<NodeCondition> RodProblem::node_conditions() const {
  std::vector<NodeCondition> result;
  std::vector<int> condition_of(rod_.new_of.size(), -1);
  const auto at = [&](int node) -> NodeCondition& {
    const int mine = rod_.new_of[index(node)];
    int& known = condition_of[index(mine)];
    if (known >= 0) return result[index(known)];
    known = static_cast<int>(result.size());
    result.emplace_back();
    result.back().node = mine;
    result.back().target = rod_.scaled(tree_.rest[index(node)]);
    return result.back();
  };
  // Supports first, so that the conditions are in the order of the supports.
  for (const RodSupport& s : given_.supports) {
    NodeCondition& c = at(s.node);
    c.fixed = s.fixed;
    c.frame = s.frame.value_or(tree_.rest[index(s.node)].rotation);
    c.target = rod_.scaled(target_pose(tree_, s));
  }
  for (const RodLoad& l : given_.loads) {
    NodeCondition& c = at(l.node);
    c.force += l.force / rod_.force();
    (l.moment_in_body ? c.body_moment : c.space_moment) += l.moment / rod_.moment;
  }
  return result;
}

RodState RodProblem::state_at(const RodPoses& poses) const {
  RodState state;
  state.poses.resize(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k)
    state.poses[k] = rod_.scaled(poses[index(rod_.node_of[k])]);
  measure_strains(state);
  state.stress.assign(links().size(), Vec6::Zero());
  return state;
}

void RodProblem::measure_strains(RodState& state) const {
  state.strain.resize(links().size());
  for (std::size_t k = 0; k < links().size(); ++k)
    state.strain[k] = link_strain(links(), state.poses, k);
}

void RodProblem::take_elastic_stress(RodState& state) const {
  state.stress.resize(links().size());
  for (std::size_t k = 0; k < links().size(); ++k)
    state.stress[k].noalias() =
        elimination_.links()[k].stiffness * (state.strain[k] - links()[k].natural);
}

void RodProblem::set_time(double t) {
  const std::vector<NodeCondition> full = node_conditions();
  for (std::size_t c = 0; c < full.size(); ++c) {
    NodeCondition& condition = elimination_.conditions()[c];
    if (c < given_.supports.size())
      condition.target = rod_.scaled(target_pose(tree_, given_.supports[c], t));
    condition.force = t * full[c].force;
    condition.space_moment = t * full[c].space_moment;
    condition.body_moment = t * full[c].body_moment;
  }
}

void RodProblem::soften(double cap) {
  for (std::size_t k = 0; k < links().size(); ++k) {
    const RodElement& element = tree_.elements[index(rod_.element_of[k])];
    const Mat6 c = rod_.stiffness(element);
    const double limit = cap * std::min(c(3, 3), c(4, 4));
    Vec6 d = Vec6::Ones();
    for (int i = 0; i < 3; ++i) d[i] = std::min(1., std::sqrt(limit / c(i, i)));
    rod_.set_stiffness(element, d.asDiagonal() * c * d.asDiagonal(), elimination_.links()[k]);
  }
}

void RodProblem::harden() {
  for (std::size_t k = 0; k < links().size(); ++k) {
    const RodElement& element = tree_.elements[index(rod_.element_of[k])];
    rod_.set_stiffness(element, rod_.stiffness(element), elimination_.links()[k]);
  }
}

double RodProblem::stiffness_ratio() const {
  double largest = 0;
  for (const RodLink& link : links())
    for (int i = 0; i < 3; ++i)
      largest = std::max(
          largest, link.stiffness(i, i) / std::min(link.stiffness(3, 3), link.stiffness(4, 4)));
  return largest;
}

double RodProblem::weakest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const RodLink& link : links())
    least = std::min(least, link.length * std::min(link.stiffness(3, 3), link.stiffness(4, 4)));
  return least;
}

double RodProblem::potential(const RodState& state, const RodState& present) const {
  double energy = 0;
  for (std::size_t k = 0; k < links().size(); ++k) {
    const Vec6 eps = state.strain[k] - links()[k].natural;
    energy += 0.5 * eps.dot(elimination_.links()[k].stiffness * eps);
  }
  for (const NodeCondition& c : elimination_.conditions()) {
    const Pose &pose = state.poses[index(c.node)], &before = present.poses[index(c.node)];
    energy -= c.force.dot(pose.position);
    if (const Vec3 moment = c.load(before).tail<3>(); !moment.isZero(0))
      energy -= moment.dot(log_rotation(pose.rotation * before.rotation.transpose()));
  }
  return energy;
}

double RodProblem::slope(const RodState& state, const RodStep& step) const {
  double sum = 0;
  for (std::size_t k = 0; k < step.stretch.size(); ++k) sum += state.stress[k].dot(step.stretch[k]);
  for (const NodeCondition& c : elimination_.conditions())
    sum -= c.load(state.poses[index(c.node)]).dot(step.twist[index(c.node)]);
  return sum;
}

void RodProblem::take(const RodState& from, const RodStep& step, double fraction,
                      RodState& to) const {
  to.poses.resize(from.poses.size());
  to.strain.resize(from.strain.size());
  const auto move = [&](std::size_t node) {
    const Vec3 v = fraction * step.twist[node].head<3>(), u = fraction * step.twist[node].tail<3>();
    const double z = u.squaredNorm();
    const ExpCoefficients e = exp_coefficients(z);
    const Vec3 uv = u.cross(v);
    Mat3 turn = (1 - z * e.d) * hat(u) + e.b * u * u.transpose();
    turn.diagonal().array() += 1 - z * e.b;
    to.poses[node].position = from.poses[node].position + v + e.b * uv + e.d * u.cross(uv);
    to.poses[node].rotation = turn * from.poses[node].rotation;
  };
  move(0);
  const auto put_on_target = [&](const NodeCondition& c) {
    if (fraction == 1 && c.fixed_count() == 6) to.poses[index(c.node)] = c.target;
  };
  for (const NodeCondition& c : elimination_.conditions())
    if (c.node == 0) put_on_target(c);
  for (std::size_t k = 0; k < links().size(); ++k) {
    if (follows_[k + 1]) {
      to.strain[k] = from.strain[k] + fraction * step.stretch[k];
      to.poses[k + 1] =
          link_start(links()[k], to.poses[index(links()[k].parent)]) * exp_motion(to.strain[k]);
    } else {
      move(k + 1);
    }
  }
  for (const NodeCondition& c : elimination_.conditions()) put_on_target(c);
  for (std::size_t k = 0; k < links().size(); ++k)
    if (!follows_[k + 1]) to.strain[k] = link_strain(links(), to.poses, k);
}

void RodProblem::update_carried(const RodState& state, bool all) {
  for (std::size_t c = 0; c < links_at_.size(); ++c) {
    NodeCondition& condition = elimination_.conditions()[c];
    if (!all && condition.fixed_count() == 6) continue;
    Vec6 sum = Vec6::Zero();
    for (const std::size_t k : links_at_[c]) {
      const Vec6 w = wrench_on_second(state.poses[k + 1], state.strain[k], state.stress[k]);
      sum += k + 1 == index(condition.node) ? w : wrench_on_first(links(), state.poses, k, w);
    }
    condition.carried = sum;
  }
}

}  // namespace vasorod
