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
#include "rod/scaled_rod.h"

namespace vasorod {
namespace {

using Clock = std::chrono::steady_clock;
std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}
double since(Clock::time_point t) {
  return std::chrono::duration<double>(Clock::now() - t).count();
}

struct Interrupted {};

/// A linear step: twist of every node, stretch and new stress of every link.
struct Step {
  std::vector<Vec6> twist, stretch, stress;
  double size() const {  // largest rotation (radians) or translation (over the rod's length)
    double squared = 0;
    for (const Vec6& t : twist) {
      const double v = t.head<3>().squaredNorm(), u = t.tail<3>().squaredNorm();
      if (!std::isfinite(v + u)) return std::numeric_limits<double>::infinity();
      squared = std::max({squared, v, u});
    }
    return std::sqrt(squared);
  }
};

/// One problem and the state that the stages hand on.
class Solver {
 public:
  Solver(const RodTree& tree, const RodConditions& conditions, const RodOptions& options);
  RodSolution solve(const RodPoses* start);

 private:
  struct State {
    std::vector<Pose> poses;
    std::vector<Vec6> stress;
  };

  std::vector<NodeCondition> node_conditions() const;
  void set_time(double t);
  void soften(double cap);
  void harden();
  void take_elastic_stress();
  double potential(const std::vector<Pose>& poses) const;
  double slope() const;
  void take(double fraction, std::vector<Pose>& poses) const;
  void update_carried(bool all);
  void count_iteration();
  bool newton();
  void step_down(double& shift);
  double search();
  bool descend(double cap, double tolerance);
  bool soft_start();
  void carry(const std::vector<Vec3>& turn);
  bool jump(bool moved);
  bool follow_path(int steps);
  void certify();
  void leave_saddle();
  void judge();
  void fill(RodSolution& solution);

  const RodTree& tree_;
  const RodConditions& given_;
  const RodOptions& options_;
  ScaledRod rod_;
  RodElimination elimination_;
  std::vector<std::vector<std::size_t>> links_at_;  // links that meet a condition's node
  std::vector<bool> follows_;  // per node: nothing beyond it is held, so it follows its link's strain
  double floor_ = 0;           // what round-off in the stiffest strain makes of a step between two clamps
  bool searchable_ = false;    // all nodes but the root follow, and the loads have an energy
  State state_;
  Step step_;
  std::vector<Pose> trial_;
  RodSummary summary_;
  Clock::time_point began_ = Clock::now();
};

Solver::Solver(const RodTree& tree, const RodConditions& conditions, const RodOptions& options)
    : tree_(tree),
      given_(conditions),
      options_(options),
      rod_(scale(tree)),
      elimination_(rod_.links, node_conditions()) {
  const std::vector<NodeCondition>& all = elimination_.conditions();
  std::vector<int> condition_of(rod_.links.size() + 1, -1);
  for (std::size_t c = 0; c < all.size(); ++c) condition_of[index(all[c].node)] = static_cast<int>(c);
  links_at_.resize(all.size());
  follows_.assign(rod_.links.size() + 1, true);
  for (std::size_t k = rod_.links.size(); k-- > 0;) {
    const std::size_t parent = index(rod_.links[k].parent);
    for (const std::size_t node : {parent, k + 1})
      if (const int c = condition_of[node]; c >= 0) links_at_[index(c)].push_back(k);
    if (const int c = condition_of[k + 1]; c >= 0 && all[index(c)].supported()) follows_[k + 1] = false;
    if (!follows_[k + 1]) follows_[parent] = false;
  }
  searchable_ = !elimination_.has_nonconservative_moment() && follows_[0];
  if (!follows_[0])
    for (const RodLink& link : rod_.links)
      floor_ = std::max(floor_, std::numeric_limits<double>::epsilon() * link.length *
                                    link.stiffness.topLeftCorner<3, 3>().diagonal().maxCoeff());
}

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
  for (const RodSupport& s : given_.supports) {  // first, so that the conditions begin in the supports' order
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

void Solver::harden() {
  for (std::size_t k = 0; k < rod_.links.size(); ++k)
    elimination_.links()[k].stiffness = rod_.links[k].stiffness;
}

void Solver::take_elastic_stress() {
  state_.stress.resize(rod_.links.size());
  for (std::size_t k = 0; k < rod_.links.size(); ++k)
    state_.stress[k] = elimination_.links()[k].stiffness *
                       (link_strain(rod_.links, state_.poses, k) - rod_.links[k].natural);
}

/// Elastic energy with the present stiffness minus the work of the loads, a moment's counted from the present
/// state.
double Solver::potential(const std::vector<Pose>& poses) const {
  double energy = 0;
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const Vec6 eps = link_strain(rod_.links, poses, k) - rod_.links[k].natural;
    energy += 0.5 * eps.dot(elimination_.links()[k].stiffness * eps);
  }
  for (const NodeCondition& c : elimination_.conditions()) {
    const Pose &pose = poses[index(c.node)], &present = state_.poses[index(c.node)];
    energy -= c.force.dot(pose.position);
    if (const Vec3 moment = c.load(present).tail<3>(); !moment.isZero(0))
      energy -= moment.dot(log_rotation(pose.rotation * present.rotation.transpose()));
  }
  return energy;
}

/// Derivative of the potential along the step; the stress is the strain's where this is used.
double Solver::slope() const {
  double sum = 0;
  for (std::size_t k = 0; k < step_.stretch.size(); ++k) sum += state_.stress[k].dot(step_.stretch[k]);
  for (const NodeCondition& c : elimination_.conditions())
    sum -= c.load(state_.poses[index(c.node)]).dot(step_.twist[index(c.node)]);
  return sum;
}

/// Moves poses by a fraction of the step. Where nothing beyond a node is held it follows the strains, in
/// which the step is linear: stiff strains then stay as small as the step left them. Elsewhere nodes move by
/// their own twists.
void Solver::take(double fraction, std::vector<Pose>& poses) const {
  const auto move = [&](std::size_t node) {
    const Vec3 v = fraction * step_.twist[node].head<3>(), u = fraction * step_.twist[node].tail<3>();
    const double z = u.squaredNorm();
    const ExpCoefficients e = exp_coefficients(z);
    const Vec3 uv = u.cross(v);
    Mat3 turn = (1 - z * e.d) * hat(u) + e.b * u * u.transpose();
    turn.diagonal().array() += 1 - z * e.b;
    poses[node].position += v + e.b * uv + e.d * u.cross(uv);
    poses[node].rotation = turn * poses[node].rotation;
  };
  move(0);
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    if (follows_[k + 1])
      poses[k + 1] = link_start(rod_.links[k], poses[index(rod_.links[k].parent)]) *
                     exp_motion(elimination_.strain(k) + fraction * step_.stretch[k]);
    else
      move(k + 1);
  }
  if (fraction == 1)
    for (const NodeCondition& c : elimination_.conditions())
      if (c.fixed_count() == 6) poses[index(c.node)] = c.target;
}

/// /// What the links pass to the nodes with conditions. Inside the iteration nodes that cannot move need
/// none.
void Solver::update_carried(bool all) {
  for (std::size_t c = 0; c < links_at_.size(); ++c) {
    NodeCondition& condition = elimination_.conditions()[c];
    if (!all && condition.fixed_count() == 6) continue;
    Vec6 sum = Vec6::Zero();
    for (const std::size_t k : links_at_[c]) {
      const Vec6 w = wrench_on_second(rod_.links, state_.poses, k, state_.stress[k]);
      sum += k + 1 == index(condition.node) ? w : wrench_on_first(rod_.links, state_.poses, k, w);
    }
    condition.carried = sum;
  }
}

void Solver::count_iteration() {
  ++summary_.iterations;
  if ((options_.stop && options_.stop()) || since(began_) > options_.time_limit) throw Interrupted{};
}

/// The fraction of the step that goes down the energy enough; the trial poses are left in trial_. 0: none.
double Solver::search() {
  const double energy = potential(state_.poses), descent = slope();
  if (!(descent < 0) || !std::isfinite(step_.size())) return 0;
  double fraction = 1;
  for (int i = 0; i < 25; ++i) {
    trial_ = state_.poses;
    take(fraction, trial_);
    const double change = potential(trial_) - energy;
    if (change <= 1e-4 * fraction * descent + 1e-14 * std::abs(energy)) return fraction;
    // minimum of the parabola through both values and the slope
    const double bend = change - fraction * descent;
    const double best = bend > 0 ? -descent * fraction * fraction / (2 * bend) : 0;
    fraction = std::clamp(best, 0.1 * fraction, 0.5 * fraction);
  }
  return 0;
}

/// Mixed Newton. Full steps, except that where every node follows the strains the energy is no longer stiff
/// and can be searched along a large step. True when the last step was below the tolerance.
bool Solver::newton() {
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < options_.max_iterations; ++i) {
    count_iteration();
    const auto t = Clock::now();
    update_carried(false);
    elimination_.factor(state_.poses, state_.stress);
    elimination_.solve(step_.twist, step_.stress, step_.stretch);
    double size = step_.size(), fraction = 1;
    if (searchable_ && size > 0.3) {
      fraction = search();
      if (fraction < 0.05) {  // not the way down: make it so
        double shift = 0;
        step_down(shift);
        size = step_.size();
        fraction = search();
      }
      if (fraction == 0) return false;
      state_.poses.swap(trial_);
    } else if (!(size < 1e3)) {
      return false;
    } else {
      take(1, state_.poses);
    }
    if (fraction == 1)
      state_.stress.swap(step_.stress);
    else
      for (std::size_t k = 0; k < state_.stress.size(); ++k)
        state_.stress[k] += fraction * (step_.stress[k] - state_.stress[k]);
    summary_.sweep_seconds += since(t);
    summary_.last_step = size;
    if (size < options_.tolerance || (size < floor_ && size > 0.3 * before)) return true;
    before = size;
  }
  return false;
}

/// /// A step that goes down the energy: the Hessian shifted until it is positive definite. The shift is kept
/// for the next.
void Solver::step_down(double& shift) {
  elimination_.factor(state_.poses, state_.stress, Purpose::descent, shift);
  while (elimination_.negative_pivots() > 0 && shift < 1e12) {
    shift = std::max(1., 4 * shift);
    elimination_.factor(state_.poses, state_.stress, Purpose::descent, shift);
  }
  elimination_.solve(step_.twist, step_.stress, step_.stretch);
}

/// Goes down the energy with softened stretch and shear: steps halved until they do.
bool Solver::descend(double cap, double tolerance) {
  soften(cap);
  bool calm = false;
  double shift = 0;
  for (int i = 0; i < 3 * options_.max_iterations && !calm; ++i) {
    count_iteration();
    take_elastic_stress();
    update_carried(false);
    step_down(shift);
    const double size = step_.size();
    if (!std::isfinite(size)) break;
    const double energy = potential(state_.poses);
    double fraction = std::min(1., 1.5 / size);
    bool accepted = false;
    for (int half = 0; half < 30 && !accepted; ++half, fraction /= 2) {
      trial_ = state_.poses;
      take(fraction, trial_);
      // near the minimum the decrease drowns in round-off; a full step is then as good as proved
      const double e = potential(trial_);
      accepted = e < energy || (fraction == 1 && e <= energy + 1e-10 * std::abs(energy));
      if (accepted) {
        state_.poses.swap(trial_);
        calm = fraction == 1 && size < tolerance;
        shift = fraction == 1 ? (shift > 0.1 ? shift / 4 : 0) : std::max(1., 2 * shift);
      }
    }
    if (!accepted) break;
  }
  take_elastic_stress();
  harden();
  return calm;
}

/// Soft rod first, then the true one with the soft one's forces as stress; where that is too wide a jump,
/// tenfold steps.
bool Solver::soft_start() {
  descend(100, 1e-2);
  const State soft = state_;
  if (newton()) return true;
  state_ = soft;
  double stiffest = 0;
  for (const RodLink& link : rod_.links)
    for (int i = 0; i < 3; ++i)
      stiffest =
          std::max(stiffest, link.stiffness(i, i) / std::min(link.stiffness(3, 3), link.stiffness(4, 4)));
  for (double cap = 100; cap < stiffest; cap *= 10) {
    const State reached = state_;
    soften(cap);
    const bool ok = newton();
    harden();
    if (ok) continue;
    state_ = reached;
    descend(cap, 1e-2);
  }
  return newton();
}

void Solver::carry(const std::vector<Vec3>& turn) {
  double largest = 0;
  state_.poses = carry_along(rod_.links, elimination_.conditions(), turn, state_.poses, &largest);
  if (largest >= std::numbers::pi)
    throw InputError("rod: the prescribed motions turn one element by " +
                     std::to_string(largest * 180 / std::numbers::pi) +
                     " degrees, expected below 180: use more elements");
}

/// Straight to the end of the path.
bool Solver::jump(bool moved) {
  const State start = state_;
  if (!moved) {
    if (newton()) return true;
    state_ = start;
  }
  return soft_start();
}

/// In steps along the path, halved where one fails.
bool Solver::follow_path(int steps) {
  double t = 0, dt = 1. / steps;
  // no step turns a support by more than a third of a turn, so that the way round stays the meant one
  for (const RodSupport& s : given_.supports) dt = std::min(dt, 2 / std::max(2., s.motion.rotate.norm()));
  State reached = state_;
  while (t < 1) {
    const double next = t + dt > 1 - 1e-9 ? 1 : t + dt;
    set_time(next);
    bool ok = false;
    for (const bool soft : {false, true}) {
      state_ = reached;
      std::vector<Vec3> turn;
      for (const NodeCondition& c : elimination_.conditions())
        turn.push_back(
            c.supported() ? log_rotation(c.target.rotation * state_.poses[index(c.node)].rotation.transpose())
                          : Vec3::Zero());
      carry(turn);
      ok = soft ? soft_start() : newton();
      if (ok) break;
    }
    if (!ok) {
      dt /= 2;
      if (dt < 1e-3) {
        state_ = reached;
        summary_.message = "the path could be followed only to " + std::to_string(100 * t) + " % of it";
        return false;
      }
      continue;
    }
    certify();
    if (summary_.negative_directions > 0 && options_.leave_saddle) leave_saddle();
    reached = state_;
    t = next;
  }
  return true;
}

void Solver::certify() {
  update_carried(false);
  elimination_.factor(state_.poses, state_.stress, Purpose::certificate);
  summary_.negative_directions = elimination_.negative_pivots();
}

/// Down a negative direction, both ways; keeps the lower end. Repeats while that is a saddle again.
void Solver::leave_saddle() {
  for (int round = 0; round < 8 && summary_.negative_directions > 0; ++round) {
    const State saddle = state_;
    certify();
    Step away;
    elimination_.negative_direction(away.twist, away.stretch);
    const double size = away.size();
    State best;
    double lowest = 0;  // change of the potential
    int best_negative = summary_.negative_directions;
    for (const double sign : {1., -1.}) {
      state_ = saddle;
      certify();  // its strains are what the step starts from
      step_ = away;
      take(sign * 0.3 / size, state_.poses);
      if (searchable_)
        take_elastic_stress();
      else
        descend(1e4, 1e-2);
      if (!newton()) continue;
      certify();
      const State end = state_;
      state_ = saddle;  // potentials count a moment's work from here
      const double before = potential(saddle.poses), change = potential(end.poses) - before;
      if (change < lowest - 1e-12 * std::abs(before)) {
        lowest = change;
        best = end;
        best_negative = summary_.negative_directions;
      }
    }
    state_ = best.poses.empty() ? saddle : best;
    certify();
    summary_.negative_directions = best_negative;
    if (best.poses.empty()) return;
  }
}

void Solver::judge() {
  certify();
  const bool energy = !elimination_.has_nonconservative_moment();
  if (summary_.negative_directions > 0 && options_.leave_saddle && energy) leave_saddle();
  if (!energy) {
    summary_.status = RodStatus::equilibrium_only;
    summary_.message = "a moment on a freely turning end has no energy, so no minimum can be certified";
  } else if (summary_.negative_directions > 0) {
    summary_.status = RodStatus::unstable;
    summary_.message = "the equilibrium is not a minimum: its Hessian has " +
                       std::to_string(summary_.negative_directions) + " negative direction(s)";
  } else if (elimination_.singular()) {
    summary_.status = RodStatus::equilibrium_only;
    summary_.message = "a direction costs nothing, so the minimum is not a strict one";
  } else {
    summary_.status = RodStatus::converged;
  }
}

void Solver::fill(RodSolution& solution) {
  const std::vector<Pose>& poses = state_.poses;
  double largest = 0, unbalanced = 0, misfit = 0,
         energy = 0;  // the largest wrench anywhere measures the imbalance
  std::vector<Vec6> sum(poses.size(), Vec6::Zero());
  for (std::size_t k = 0; k < rod_.links.size(); ++k) {
    const Vec6 second = wrench_on_second(rod_.links, poses, k, state_.stress[k]);
    sum[k + 1] += second;
    sum[index(rod_.links[k].parent)] += wrench_on_first(rod_.links, poses, k, second);
    largest = std::max(largest, second.norm());
    const Vec6 strain = rod_.links[k].stiffness.ldlt().solve(state_.stress[k]);
    energy += 0.5 * strain.dot(state_.stress[k]);
    misfit = std::max(misfit, (link_strain(rod_.links, poses, k) - rod_.links[k].natural - strain).norm());
  }
  for (const NodeCondition& c : elimination_.conditions()) {
    Vec6& s = sum[index(c.node)];
    const Vec6 load = c.load(poses[index(c.node)]);
    s -= load;
    largest = std::max({largest, load.head<3>().norm(), load.tail<3>().norm()});
    for (int i = 0; i < 6; ++i) {
      if (!c.fixed[index(i)]) continue;
      const Vec3 axis = c.frame.col(i % 3);
      const int at = i < 3 ? 0 : 3;
      s.segment<3>(at) -= axis * axis.dot(s.segment<3>(at));
    }
  }
  for (const Vec6& s : sum) unbalanced = std::max(unbalanced, s.norm());
  summary_.residual = std::max(largest > 0 ? unbalanced / largest : 0., misfit);
  summary_.energy = energy * rod_.moment;

  solution.poses.resize(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k)
    solution.poses[index(rod_.node_of[k])] = rod_.original(poses[k]);
  solution.stress.resize(state_.stress.size());
  for (std::size_t k = 0; k < state_.stress.size(); ++k)
    solution.stress[index(rod_.element_of[k])] << state_.stress[k].head<3>() * rod_.force(),
        state_.stress[k].tail<3>() * rod_.moment;
  update_carried(true);
  for (std::size_t c = 0; c < given_.supports.size(); ++c) {
    const NodeCondition& condition = elimination_.conditions()[c];
    const Vec6 reaction = condition.carried - condition.load(poses[index(condition.node)]);
    const int node = given_.supports[c].node;
    solution.reactions.push_back({node, reaction.head<3>() * rod_.force(), reaction.tail<3>() * rod_.moment,
                                  solution.poses[index(node)].position});
  }
}

RodSolution Solver::solve(const RodPoses* start) {
  const auto poses_of = [&](const RodPoses& given) {
    std::vector<Pose> poses(rod_.node_of.size());
    for (std::size_t k = 0; k < poses.size(); ++k) poses[k] = rod_.scaled(given[index(rod_.node_of[k])]);
    return poses;
  };
  state_.poses = poses_of(start ? *start : tree_.rest);
  state_.stress.assign(rod_.links.size(), Vec6::Zero());

  bool moved = false;
  const std::vector<NodeCondition>& conditions = elimination_.conditions();
  std::vector<Vec3> turn(conditions.size(), Vec3::Zero());
  for (std::size_t c = 0; c < given_.supports.size(); ++c) {
    const Pose& pose = state_.poses[index(conditions[c].node)];
    turn[c] = start ? log_rotation(conditions[c].target.rotation * pose.rotation.transpose())
                    : given_.supports[c].motion.rotate;
    moved = moved || turn[c].norm() > 1e-12 || (conditions[c].target.position - pose.position).norm() > 1e-12;
  }
  RodSolution solution;
  try {
    bool found = false;
    if (options_.path_steps <= 1) {
      if (moved) carry(turn);
      if (start) {
        soften(100);
        take_elastic_stress();
        harden();
      }
      found = jump(moved);
    }
    if (!found) {
      state_.poses = poses_of(tree_.rest);
      state_.stress.assign(rod_.links.size(), Vec6::Zero());
      found = follow_path(std::max(options_.path_steps, 4));
    }
    if (found)
      judge();
    else
      summary_.status = RodStatus::iteration_limit;
  } catch (const Interrupted&) {
    harden();
    summary_.status = RodStatus::interrupted;
    summary_.message = "stopped before the end";
  }
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
