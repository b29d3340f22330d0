// Moves a CoupledStack along its path: the start of the walls at a time is the position given by
// the rods plus the deviation of the walls from their rods, extrapolated from the previous times.
#pragma once

#include <optional>
#include <vector>

#include "coupled/coupled_stack.h"

namespace vasorod {

/// Start states of one CoupledStack along its path.
class CoupledPath {
 public:
  /// `stack` must outlive this.
  explicit CoupledPath(CoupledStack& stack) : stack_(stack) {}

  /// Resets to the state before the first time.
  void restart();

  /// Stores the start of the walls at time t in the stack. Returns false at the first time, where
  /// there is nothing to extrapolate from. Guarded walls that would pass through themselves on
  /// the way there start as they were at the previous time, or are not at a
  /// possible start.
  bool advance(double t);

  /// After advance() to a later time: starts from the walls as they were at the previous time, not
  /// from their extrapolation.
  void hold_back();

  /// Not where guarded walls would pass through themselves, on the way to the start or now: their
  /// energy is infinite then.
  bool is_possible() const;

  /// After advance(): starts where CoupledProblem::start has the walls.
  void start_at_given();

  /// Builds the stack again: new bodies join the unknowns, existing ones keep their state.
  void rebuild();
  /// CoupledStack::narrow() and widen(), with the state and the frames of the present walls.
  bool narrow(Patch patch);
  void widen();

  /// The state at a time, from which the path can go on again.
  struct Kept;
  Kept keep() const;
  /// Bodies that joined the unknowns since then are at rest.
  void restore(const Kept& kept);
  /// The same, and contacts begin anew.
  void take_back(const Kept& kept);

 private:
  bool leads_here(const Points& last) const;
  // Positions given by the rods at a time, in scaled units, per body; no entry is empty.
  struct Carried {
    std::vector<Points> points;
    std::vector<std::vector<Mat3>> rotations;
    std::vector<std::vector<Pose>> sections;
  };
  // State of the walls at a time, in the frames of the rods.
  struct Local {
    double time = 0;
    std::vector<Points> deviation;  // per body: of the vertices, in the rods' frames
    std::vector<std::vector<Pose>> sections;
    Eigen::VectorXd z;
  };
  Carried carried_at(double t) const;
  Local local_state() const;
  void place(const Local* before);
  void put_bodies(const std::vector<int>& wall_before, const CoupledState& before);
  void turn_minimiser(const std::vector<std::vector<Mat3>>& rotations);

  CoupledStack& stack_;
  double time_ = 0;
  bool blocked_ = false;
  Carried carried_;                        // at the present time
  std::vector<std::vector<Mat3>> frames_;  // of K0, per body
  std::optional<Local> last_;              // at the previous time
};

struct CoupledPath::Kept {
  double time = 0;
  Carried carried;
  std::optional<Local> last;
  std::vector<int> first_wall;  // per body
  std::vector<Points> now;      // per body
  CoupledState state;
  std::vector<CrossingGuard::Memory> guards;  // per wall of `first_wall` that has one
};

}  // namespace vasorod
