#include "rod/newton.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/rigid_motion.h"
#include "rod/carry.h"
#include "rod/elimination.h"
#include "rod/energy.h"

namespace vasorod {
namespace {

using Clock = std::chrono::steady_clock;
std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}
double since(Clock::time_point t) {
  return std::chrono::duration<double>(Clock::now() - t).count();
}

/// The rod in units of its own length and bending stiffness, nodes renumbered so that parents come first.
struct ScaledRod {
  double length = 1, moment = 1;  ///< units: L, and E I / L for moments and energies
  Vec3 origin = Vec3::Zero();
  std::vector<int> node_of, new_of;  ///< tree's node of ours, ours of the tree's
  std::vector<int> element_of;       ///< tree's element of each link
  std::vector<RodLink> links;
  double force() const { return moment / length; }
  Pose scaled(const Pose& p) const { return {p.rotation, (p.position - origin) / length}; }
  Pose original(const Pose& p) const { return {nearest_rotation(p.rotation), origin + length * p.position}; }
};

ScaledRod scale(const RodTree& tree) {
  ScaledRod rod;
  rod.length = length_scale(tree);
  rod.origin = tree.rest[0].position;
  double weight = 0, bending = 0;
  for (const RodElement& e : tree.elements) {
    bending += e.length * 0.5 * (e.stiffness(3, 3) + e.stiffness(4, 4));
    weight += e.length;
  }
  rod.moment = bending / weight / rod.length;
  const int n = tree.node_count();
  std::vector<std::vector<int>> leaving(index(n));
  for (std::size_t e = 0; e < tree.elements.size(); ++e)
    leaving[index(tree.elements[e].first)].push_back(static_cast<int>(e));
  rod.new_of.assign(index(n), -1);
  std::vector<int> waiting;  // elements whose first node is numbered; depth first keeps a branch together
  const auto number = [&](int node) {
    rod.new_of[index(node)] = static_cast<int>(rod.node_of.size());
    rod.node_of.push_back(node);
    waiting.insert(waiting.end(), leaving[index(node)].rbegin(), leaving[index(node)].rend());
  };
  number(0);
  Vec6 unit;  // strain energy per length in units of moment
  unit << Vec3::Constant(rod.length), Vec3::Ones();
  unit /= std::sqrt(rod.moment * rod.length);
  while (!waiting.empty()) {
    const int e = waiting.back();
    waiting.pop_back();
    const RodElement& element = tree.elements[index(e)];
    RodLink link;
    link.parent = rod.new_of[index(element.first)];
    link.length = element.length / rod.length;
    link.natural << link.length * element.natural_strain.head<3>(),
        element.length * element.natural_strain.tail<3>();
    link.stiffness = unit.asDiagonal() * element.stiffness * unit.asDiagonal();
    link.stiffness /= link.length;
    rod.links.push_back(link);
    rod.element_of.push_back(e);
    number(element.second);
  }
  return rod;
}

/// Wrench (space axes) a link's stress puts on its second node; on its first it puts minus that, moved there.
Vec6 link_wrench(const Pose& first, const Pose& second, const Vec6& stress) {
  const Vec6 xi = log_motion(first.inverse() * second);
  const Vec6 body = right_jacobian_inverse(xi).transpose() * stress;
  Vec6 w;
  w << second.rotation * body.head<3>(), second.rotation * body.tail<3>();
  return w;
}

Vec6 at_first(const Pose& first, const Pose& second, const Vec6& wrench) {
  Vec6 w = -wrench;
  w.tail<3>() -= (second.position - first.position).cross(wrench.head<3>());
  return w;
}

struct Interrupted {};

/// One problem: scaled rod, conditions, and the state that the stages hand on.
class Solver {
 public:
  Solver(const RodTree& tree, const RodConditions& conditions, const RodOptions& options)
      : tree_(tree),
        given_(conditions),
        options_(options),
        rod_(scale(tree)),
        elimination_(rod_.links, node_conditions()) {
    const std::size_t n = elimination_.conditions().size();
    links_at_.resize(n);
    for (std::size_t c = 0; c < n; ++c)
      for (std::size_t k = 0; k < rod_.links.size(); ++k) {
        const int node = elimination_.conditions()[c].node;
        if (rod_.links[k].parent == node || static_cast<int>(k) + 1 == node)
          links_at_[c].push_back(static_cast<int>(k));
      }
  }

  RodSolution solve(const RodPoses* start);

 private:
  std::vector<NodeCondition> node_conditions() const;
  void set_time(double t);
  void restore_stiffness();
  void soften(double cap);
  std::vector<Vec6> elastic_stress() const;
  double potential(const std::vector<Pose>& poses) const;
  void take(const std::vector<Vec6>& step, double fraction, std::vector<Pose>& poses) const;
  void update_reactions();
  void count_iteration();
  bool newton();
  bool descend(double cap, double tolerance);
  bool soft_start();
  bool jump(bool moved);
  bool follow_path(int steps);
  void certify();
  bool leave_saddle();
  void fill(RodSolution& solution);
  std::vector<Vec6> imbalance() const;

  const RodTree& tree_;
  const RodConditions& given_;
  const RodOptions& options_;
  ScaledRod rod_;
  RodElimination elimination_;
  std::vector<std::vector<int>> links_at_;  // links that meet a condition's node
  std::vector<Pose> poses_;
  std::vector<Vec6> stress_;
  RodSummary summary_;
  Clock::time_point began_ = Clock::now();
};

std::vector<NodeCondition> Solver::node_conditions() const {
  std::vector<NodeCondition> result;
  const auto at = [&](int node) -> NodeCondition& {
    const int mine = rod_.new_of[index(node)];
    for (NodeCondition& c : result)
      if (c.node == mine) return c;
    result.emplace_back();
    result.back().node = mine;
    result.back().target = rod_.scaled(tree_.rest[index(node)]);
    return result.back();
  };
  for (const RodSupport& s :
       given_.supports) {  // first, so that the conditions' order is the supports' order
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

void Solver::set_time(double t) {
  const std::vector<NodeCondition> full = node_conditions();
  for (std::size_t c = 0; c < full.size(); ++c) {
    NodeCondition& condition = elimination_.conditions()[c];
    if (c < given_.supports.size()) condition.target = rod_.scaled(target_pose(tree_, given_.supports[c], t));
    condition.force = t * full[c].force;
    condition.space_moment = t * full[c].space_moment;
    condition.body_moment = t * full[c].body_moment;
  }
}

void Solver::restore_stiffness() {
  for (std::size_t k = 0; k < rod_.links.size(); ++k)
    elimination_.links()[k].stiffness = rod_.links[k].stiffness;
}

/// Stretch and shear stiffness at most `cap` times the local bending stiffness over L^2.
void Solver::soften(double cap) {
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const Mat6& c = rod_.links[k].stiffness;
    const double limit = cap * std::min(c(3, 3), c(4, 4));
    Vec6 d = Vec6::Ones();
    for (int i = 0; i < 3; ++i) d[i] = std::min(1., std::sqrt(limit / c(i, i)));
    elimination_.links()[k].stiffness = d.asDiagonal() * c * d.asDiagonal();
  }
}

std::vector<Vec6> Solver::elastic_stress() const {
  std::vector<Vec6> stress(rod_.links.size());
  for (std::size_t k = 0; k < stress.size(); ++k) {
    const RodLink& link = elimination_.links()[k];
    const Vec6 xi = log_motion(poses_[index(link.parent)].inverse() * poses_[k + 1]);
    stress[k] = link.stiffness * (xi - link.natural);
  }
  return stress;
}

/// Elastic energy with the present stiffness minus the work of dead forces.
double Solver::potential(const std::vector<Pose>& poses) const {
  double energy = 0;
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const RodLink& link = elimination_.links()[k];
    const Vec6 eps = log_motion(poses[index(link.parent)].inverse() * poses[k + 1]) - link.natural;
    energy += 0.5 * eps.dot(link.stiffness * eps);
  }
  for (const NodeCondition& c : elimination_.conditions())
    energy -= c.force.dot(poses[index(c.node)].position);
  return energy;
}

void Solver::take(const std::vector<Vec6>& step, double fraction, std::vector<Pose>& poses) const {
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Vec3 v = fraction * step[k].head<3>(), u = fraction * step[k].tail<3>();
    const double z = u.squaredNorm();
    const ExpCoefficients e = exp_coefficients(z);
    const Mat3 h = hat(u);
    const Vec3 uv = u.cross(v);
    poses[k].position += v + e.b * uv + e.d * u.cross(uv);
    poses[k].rotation = Mat3((1 - z * e.b) * Mat3::Identity() + (1 - z * e.d) * h + e.b * u * u.transpose()) *
                        poses[k].rotation;
  }
  if (fraction == 1)
    for (const NodeCondition& c : elimination_.conditions())
      if (c.fixed_count() == 6) poses[index(c.node)] = c.target;
}

/// A support's reaction is what the links leave unbalanced at its node.
void Solver::update_reactions() {
  for (std::size_t c = 0; c < links_at_.size(); ++c) {
    NodeCondition& condition = elimination_.conditions()[c];
    if (!condition.supported()) continue;
    Vec6 sum = Vec6::Zero();
    for (const int k : links_at_[c]) {
      const Pose &first = poses_[index(rod_.links[index(k)].parent)], &second = poses_[index(k) + 1];
      const Vec6 w = link_wrench(first, second, stress_[index(k)]);
      sum += k + 1 == condition.node ? w : at_first(first, second, w);
    }
    sum.head<3>() -= condition.force;
    sum.tail<3>() -= condition.space_moment + poses_[index(condition.node)].rotation * condition.body_moment;
    condition.reaction = sum;
  }
}

void Solver::count_iteration() {
  ++summary_.iterations;
  if ((options_.stop && options_.stop()) || since(began_) > options_.time_limit) throw Interrupted{};
}

/// Mixed Newton with full steps from (poses_, stress_). True when the last step was below the tolerance.
bool Solver::newton() {
  std::vector<Vec6> step;
  for (int i = 0; i < options_.max_iterations; ++i) {
    count_iteration();
    const auto t = Clock::now();
    elimination_.factor(poses_, stress_);
    elimination_.solve(step, stress_);
    double size = 0;
    bool finite = true;
    for (const Vec6& s : step) {
      const double norm = std::max(s.head<3>().norm(), s.tail<3>().norm());
      finite = finite && std::isfinite(norm);
      size = std::max(size, norm);
    }
    if (!finite || size > 1e3) return false;
    take(step, 1, poses_);
    update_reactions();
    summary_.sweep_seconds += since(t);
    summary_.last_step = size;
    if (size < options_.tolerance) return true;
  }
  return false;
}

/// Goes down the energy with softened stretch and shear: Newton directions made to descend, steps halved
/// until they do.
bool Solver::descend(double cap, double tolerance) {
  soften(cap);
  std::vector<Vec6> step, unused;
  std::vector<Pose> trial;
  double energy = potential(poses_);
  bool calm = false;
  for (int i = 0; i < 3 * options_.max_iterations && !calm; ++i) {
    count_iteration();
    stress_ = elastic_stress();
    update_reactions();
    elimination_.factor(poses_, stress_, Pivots::made_positive);
    elimination_.solve(step, unused);
    double size = 0;
    for (const Vec6& s : step) size = std::max({size, s.head<3>().norm(), s.tail<3>().norm()});
    if (!std::isfinite(size)) break;
    double fraction = std::min(1., 1.5 / size);
    bool accepted = false;
    for (int half = 0; half < 30 && !accepted; ++half, fraction /= 2) {
      trial = poses_;
      take(step, fraction, trial);
      const double e = potential(trial);
      // near the minimum the decrease drowns in round-off; a full step is then as good as proved
      if (e < energy || (fraction == 1 && e <= energy + 1e-10 * std::abs(energy))) {
        accepted = true;
        energy = e;
        poses_.swap(trial);
        calm = fraction == 1 && size < tolerance;
      }
    }
    if (!accepted) break;
  }
  stress_ = elastic_stress();
  update_reactions();
  restore_stiffness();
  return calm;
}

/// Soft rod first, then the true one with the soft one's forces as stress; where that jump is too wide, in
/// tenfold steps.
bool Solver::soft_start() {
  descend(100, 1e-2);
  const std::vector<Pose> soft_poses = poses_;
  const std::vector<Vec6> soft_stress = stress_;
  if (newton()) return true;
  poses_ = soft_poses;
  stress_ = soft_stress;
  double stiffest = 0;
  for (const RodLink& link : rod_.links)
    for (int i = 0; i < 3; ++i)
      stiffest =
          std::max(stiffest, link.stiffness(i, i) / std::min(link.stiffness(3, 3), link.stiffness(4, 4)));
  for (double cap = 100; cap < stiffest; cap *= 10) {
    soften(cap);
    const bool ok = newton();
    restore_stiffness();
    if (!ok) return false;
  }
  return newton();
}

/// Straight to the end of the path.
bool Solver::jump(bool moved) {
  const std::vector<Pose> start = poses_;
  if (!moved) {
    stress_.assign(rod_.links.size(), Vec6::Zero());
    if (newton()) return true;
    poses_ = start;
  }
  return soft_start();
}

/// In steps along the path, halved where one fails.
bool Solver::follow_path(int steps) {
  double t = 0, dt = 1. / steps;
  for (const RodSupport& s : given_.supports) dt = std::min(dt, 0.5 / std::max(0.5, s.motion.rotate.norm()));
  std::vector<Pose> poses = poses_;
  std::vector<Vec6> stress(rod_.links.size(), Vec6::Zero());
  while (t < 1) {
    const double next = std::min(1., t + dt > 1 - 1e-12 ? 1. : t + dt);
    set_time(next);
    poses_ = poses;
    stress_ = stress;
    std::vector<Vec3> turn;
    for (const NodeCondition& c : elimination_.conditions())
      turn.push_back(c.supported()
                         ? log_rotation(c.target.rotation * poses_[index(c.node)].rotation.transpose())
                         : Vec3::Zero());
    poses_ = carry_along(rod_.links, elimination_.conditions(), turn, poses_);
    bool ok = newton();
    if (!ok) {
      poses_ = carry_along(rod_.links, elimination_.conditions(), turn, poses);
      ok = soft_start();
    }
    if (!ok) {
      dt /= 2;
      if (dt < 1e-3) {
        poses_ = poses;
        stress_ = stress;
        summary_.message = "the path could be followed only to the fraction " + std::to_string(t);
        return false;
      }
      continue;
    }
    certify();
    if (summary_.negative_directions > 0 && options_.leave_saddle) leave_saddle();
    poses = poses_;
    stress = stress_;
    t = next;
  }
  return true;
}

void Solver::certify() {
  elimination_.factor(poses_, stress_, Pivots::as_they_are, true);
  summary_.negative_directions = elimination_.negative_pivots();
}

/// Down a negative direction, both ways; keeps the lower minimum. True when a certified minimum was reached.
bool Solver::leave_saddle() {
  for (int round = 0; round < 8 && summary_.negative_directions > 0; ++round) {
    const std::vector<Pose> saddle = poses_;
    const std::vector<Vec6> saddle_stress = stress_;
    const double saddle_energy = potential(saddle);
    certify();
    const std::vector<Vec6> direction = elimination_.negative_direction();
    double size = 0;
    for (const Vec6& d : direction) size = std::max({size, d.head<3>().norm(), d.tail<3>().norm()});
    std::vector<Pose> best;
    std::vector<Vec6> best_stress;
    double best_energy = saddle_energy;
    int best_negative = 0;
    for (const double sign : {1., -1.}) {
      poses_ = saddle;
      stress_ = saddle_stress;
      take(direction, sign * 0.3 / size, poses_);
      descend(1e4, 1e-2);
      if (!newton()) continue;
      certify();
      const double energy = potential(poses_);
      if (energy < best_energy - 1e-12 * std::abs(saddle_energy)) {
        best_energy = energy;
        best = poses_;
        best_stress = stress_;
        best_negative = summary_.negative_directions;
      }
    }
    if (best.empty()) {
      poses_ = saddle;
      stress_ = saddle_stress;
      certify();
      return false;
    }
    poses_ = best;
    stress_ = best_stress;
    update_reactions();
    summary_.negative_directions = best_negative;
  }
  return summary_.negative_directions == 0;
}

std::vector<Vec6> Solver::imbalance() const {
  std::vector<Vec6> sum(poses_.size(), Vec6::Zero());
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const std::size_t parent = index(rod_.links[k].parent);
    const Vec6 w = link_wrench(poses_[parent], poses_[k + 1], stress_[k]);
    sum[k + 1] += w;
    sum[parent] += at_first(poses_[parent], poses_[k + 1], w);
  }
  for (const NodeCondition& c : elimination_.conditions()) {
    sum[index(c.node)].head<3>() -= c.force;
    sum[index(c.node)].tail<3>() -= c.space_moment + poses_[index(c.node)].rotation * c.body_moment;
  }
  return sum;
}

void Solver::fill(RodSolution& solution) {
  // largest force that acts anywhere, as the measure of imbalance
  double largest = 0, unbalanced = 0, misfit = 0, energy = 0;
  std::vector<Vec6> sum = imbalance();
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const Pose &first = poses_[index(rod_.links[k].parent)], &second = poses_[k + 1];
    largest = std::max(largest, link_wrench(first, second, stress_[k]).norm());
    const Vec6 y = rod_.links[k].stiffness.ldlt().solve(stress_[k]);
    energy += 0.5 * y.dot(stress_[k]);
    misfit = std::max(misfit, (log_motion(first.inverse() * second) - rod_.links[k].natural - y).norm());
  }
  for (const NodeCondition& c : elimination_.conditions()) {
    largest = std::max({largest, c.force.norm(), c.space_moment.norm(), c.body_moment.norm()});
    for (int i = 0; i < 6; ++i) {
      if (!c.fixed[index(i)]) continue;
      const Vec3 axis = c.frame.col(i % 3);
      auto part = i < 3 ? sum[index(c.node)].head<3>() : sum[index(c.node)].tail<3>();
      part -= axis * axis.dot(part);
    }
  }
  for (const Vec6& s : sum) unbalanced = std::max(unbalanced, s.norm());
  summary_.residual = std::max(largest > 0 ? unbalanced / largest : 0., misfit);
  summary_.energy = energy * rod_.moment;
  solution.poses.resize(poses_.size());
  for (std::size_t k = 0; k < poses_.size(); ++k)
    solution.poses[index(rod_.node_of[k])] = rod_.original(poses_[k]);
  solution.stress.resize(stress_.size());
  for (std::size_t k = 0; k < stress_.size(); ++k) {
    Vec6& s = solution.stress[index(rod_.element_of[k])];
    s << stress_[k].head<3>() * rod_.force(), stress_[k].tail<3>() * rod_.moment;
  }
  update_reactions();
  for (std::size_t c = 0; c < given_.supports.size(); ++c) {
    const NodeCondition& condition = elimination_.conditions()[c];
    const int node = given_.supports[c].node;
    solution.reactions.push_back({node, condition.reaction.head<3>() * rod_.force(),
                                  condition.reaction.tail<3>() * rod_.moment,
                                  solution.poses[index(node)].position});
  }
}

RodSolution Solver::solve(const RodPoses* start) {
  const std::vector<NodeCondition>& conditions = elimination_.conditions();
  poses_.resize(rod_.node_of.size());
  for (std::size_t k = 0; k < poses_.size(); ++k)
    poses_[k] = rod_.scaled((start ? *start : tree_.rest)[index(rod_.node_of[k])]);
  stress_.assign(rod_.links.size(), Vec6::Zero());
  const std::vector<Pose> initial = poses_;

  bool moved = false;
  std::vector<Vec3> turn(conditions.size(), Vec3::Zero());
  for (std::size_t c = 0; c < given_.supports.size(); ++c) {
    const Pose& pose = poses_[index(conditions[c].node)];
    turn[c] = start ? log_rotation(conditions[c].target.rotation * pose.rotation.transpose())
                    : given_.supports[c].motion.rotate;
    moved = moved || turn[c].norm() > 1e-12 || (conditions[c].target.position - pose.position).norm() > 1e-12;
  }
  bool found = false;
  RodSolution solution;
  try {
    if (options_.path_steps <= 1) {
      if (moved) poses_ = carry_along(rod_.links, conditions, turn, poses_);
      found = jump(moved);
    }
    if (!found) {
      poses_ = initial;
      if (start)
        for (std::size_t k = 0; k < poses_.size(); ++k)
          poses_[k] = rod_.scaled(tree_.rest[index(rod_.node_of[k])]);
      found = follow_path(std::max(options_.path_steps, 4));
    }
    if (found) {
      certify();
      if (summary_.negative_directions > 0 && options_.leave_saddle &&
          !elimination_.has_nonconservative_moment())
        leave_saddle();
      if (elimination_.has_nonconservative_moment()) {
        summary_.status = RodStatus::equilibrium_only;
        summary_.message =
            "a moment on a freely turning end has no energy, so the equilibrium is not a minimum of one";
      } else if (summary_.negative_directions > 0) {
        summary_.status = RodStatus::unstable;
        summary_.message =
            "the equilibrium is not a minimum: " + std::to_string(summary_.negative_directions) +
            " negative direction(s)";
      } else {
        summary_.status = elimination_.singular() ? RodStatus::equilibrium_only : RodStatus::converged;
        if (elimination_.singular())
          summary_.message = "the rod is free to move in a direction that costs nothing";
      }
    } else {
      summary_.status = RodStatus::iteration_limit;
    }
  } catch (const Interrupted&) {
    restore_stiffness();
    summary_.status = RodStatus::interrupted;
  }
  set_time(1);
  fill(solution);
  summary_.seconds = since(began_);
  solution.summary = summary_;
  return solution;
}

}  // namespace

std::string to_string(RodStatus status) {
  switch (status) {
    case RodStatus::converged:
      return "converged";
    case RodStatus::equilibrium_only:
      return "equilibrium_only";
    case RodStatus::unstable:
      return "unstable";
    case RodStatus::iteration_limit:
      return "iteration_limit";
    case RodStatus::interrupted:
      return "interrupted";
  }
  return "unknown";
}

RodSolution solve_rod(const RodTree& tree, const RodConditions& conditions, const RodOptions& options,
                      const RodPoses* start) {
  check_tree(tree);
  check_conditions(tree, conditions);
  if (start && start->size() != tree.rest.size())
    throw InputError("rod: the start has " + std::to_string(start->size()) + " poses, expected " +
                     std::to_string(tree.rest.size()));
  return Solver(tree, conditions, options).solve(start);
}

}  // namespace vasorod
