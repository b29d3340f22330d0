#include "surgery/meeting.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

using Vector = Eigen::VectorXd;

// The way is followed in steps of this size at most; smaller ones where Newton fails.
constexpr double largest_step = 0.25, smallest_step = 1.0 / 128;
// Newton on the pose: iterations per step, the largest turn of one iteration (radians), and the
// increment (radii, radians) below which it has converged. The increment's square is the error.
constexpr int most_iterations = 25;
constexpr double largest_turn = 0.4, converged = 1e-7;
// Of the differences that give the stiffness, radii and radians.
constexpr double difference = 1e-5;

// Where the seam is: the first rim's pose, and the second rim's rotation.
struct Place {
  Pose seam;
  double rotation = 0;
};

struct State {
  Place place;
  std::array<RodSolution, 2> rods;
  std::array<RodConditions, 2> conditions;
  bool solved = false;
};

class Seam {
 public:
  Seam(const std::array<RimRod, 2>& rims, std::optional<double> rotation, const RodOptions& options)
      : rims_(rims), rotation_(rotation), options_(options), unit_(rims[0].radius) {
    const Mat3 &first = rims[0].rim.rotation, &second = rims[1].rim.rotation;
    const Mat3 turn =
        Eigen::Quaterniond::FromTwoVectors(second.col(2), -first.col(2)).toRotationMatrix();
    gap_ = rims[0].rim.inverse() * rims[1].rim;
    const Mat3 closed = first.transpose() * turn * second;
    turn_ = log_rotation(nearest_rotation(gap_.rotation.transpose() * closed));
  }

  double axis_turn() const { return turn_.norm(); }

  // Follows the way until the rims meet.
  State run() const {
    State now = solve(0, Place{rims_[0].rim, 0}, nullptr);
    if (!newton(0, now)) now.solved = false;
    double t = 0;
    for (double step = largest_step; t < 1 && now.solved;) {
      const double next = std::min(1.0, t + step);
      State there = now;
      if (newton(next, there)) {
        now = std::move(there);
        t = next;
        step = std::min(largest_step, 2 * step);
      } else if (stopped() || (step /= 2) < smallest_step) {
        there.solved = false;
        now = std::move(there);
      }
    }
    return now;
  }

 private:
  bool stopped() const { return options_.stop && options_.stop(); }
  bool free_rotation() const { return !rotation_.has_value(); }
  Eigen::Index unknowns() const { return free_rotation() ? 7 : 6; }

  // The second rim's pose in the first's at time t.
  Pose gap(double t, double rotation) const {
    const double angle = free_rotation() ? rotation : t * *rotation_;
    Pose pose;
    pose.position = (1 - t) * gap_.position;
    pose.rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix() * gap_.rotation *
                    exp_rotation(t * turn_);
    return pose;
  }

  State solve(double t, const Place& place, const State* start) const {
    State state;
    state.place = place;
    state.solved = true;
    for (size_t k = 0; k < 2; ++k) {
      const RimRod& mine = rims_[k];
      const Pose rim = k == 0 ? place.seam : place.seam * gap(t, place.rotation);
      const Pose node = rim * (mine.rim.inverse() * mine.rod->rest[index(mine.node)]);
      state.conditions[k] = mine.held;
      state.conditions[k].supports.push_back(clamp_at(*mine.rod, mine.node, node));
      state.rods[k] = solve_rod(*mine.rod, state.conditions[k], options_,
                                start ? &start->rods[k].poses : nullptr);
      state.solved &= state.rods[k].summary.status == Status::converged;
    }
    return state;
  }

  // What the supports that stand for the seam do to both rods, in the seam's axes: force, moment
  // over the rim's radius, and the torque on the second rod about the normal over the radius.
  Vector unbalanced(const State& state) const {
    const Mat3 axes = state.place.seam.rotation.transpose();
    Vector out = Vector::Zero(unknowns());
    for (size_t k = 0; k < 2; ++k)
      for (const RodReaction& reaction : state.rods[k].reactions) {
        if (reaction.node != rims_[k].node) continue;
        const Vec3 arm = reaction.center - state.place.seam.position;
        const Vec3 moment = axes * (reaction.moment + arm.cross(reaction.force)) / unit_;
        out.segment<3>(0) += axes * reaction.force;
        out.segment<3>(3) += moment;
        if (!free_rotation() || k == 0) continue;
        // The second rim turns about its own centre.
        const Pose rim = state.rods[k].poses[index(rims_[k].node)] *
                         (rims_[k].rod->rest[index(rims_[k].node)].inverse() * rims_[k].rim);
        out[6] =
            (axes * (reaction.moment + (reaction.center - rim.position).cross(reaction.force)))[2] /
            unit_;
      }
    return out;
  }

  Place moved(const Place& place, const Vector& by) const {
    Vec6 twist = by.head<6>();
    twist.head<3>() *= unit_;
    Place out{place.seam * exp_motion(twist), place.rotation};
    out.seam.rotation = nearest_rotation(out.seam.rotation);
    if (free_rotation()) out.rotation += by[6];
    return out;
  }

  // Newton on the seam's place at time t. `state`: the start, and the solution if this is true.
  bool newton(double t, State& state) const {
    state = solve(t, state.place, &state);
    for (int iteration = 0; iteration < most_iterations && state.solved; ++iteration) {
      if (stopped()) return false;
      const Vector force = unbalanced(state);
      Eigen::MatrixXd stiffness(unknowns(), unknowns());
      for (Eigen::Index k = 0; k < unknowns(); ++k) {
        const State beside =
            solve(t, moved(state.place, difference * Vector::Unit(unknowns(), k)), &state);
        if (!beside.solved) return false;
        stiffness.col(k) = (unbalanced(beside) - force) / difference;
      }
      Vector step = -stiffness.colPivHouseholderQr().solve(force);
      if (!step.allFinite()) return false;
      const double turn = step.tail(unknowns() - 3).norm();
      if (turn > largest_turn) step *= largest_turn / turn;
      // The rods follow the step, in halves where they do not.
      State next = solve(t, moved(state.place, step), &state);
      for (int half = 0; half < 5 && !next.solved; ++half) {
        step /= 2;
        next = solve(t, moved(state.place, step), &state);
      }
      state = std::move(next);
      if (state.solved && step.norm() < converged) return true;
    }
    return false;
  }

  const std::array<RimRod, 2>& rims_;
  std::optional<double> rotation_;
  RodOptions options_;
  double unit_;  // radius of the first rim
  Pose gap_;     // the second rim in the first, at rest
  Vec3 turn_;    // of the second rim to face the first, in its own axes
};

}  // namespace

Meeting meet(const std::array<RimRod, 2>& rims, std::optional<double> rotation,
             const RodOptions& options) {
  const Seam seam(rims, rotation, options);
  State state = seam.run();
  if (!state.solved)
    for (RodSolution& rod : state.rods) {
      if (rod.summary.status != Status::converged) continue;
      rod.summary.status =
          options.stop && options.stop() ? Status::interrupted : Status::iteration_limit;
      rod.summary.message = "no equilibrium of both rods with their rims on each other was found";
    }
  return {std::move(state.rods), std::move(state.conditions),
          rotation.value_or(state.place.rotation), seam.axis_turn()};
}

}  // namespace vasorod
