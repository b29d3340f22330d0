// The way of a CoupledStack along its path: where the rods carry the walls at a time, with what the
// walls had against their rods at the last times, extrapolated.
#pragma once

#include <optional>
#include <vector>

#include "coupled/coupled_stack.h"

namespace vasorod {

class CoupledPath {
 public:
  explicit CoupledPath(CoupledStack& stack) : stack_(stack) {}

  /// Back to before the first time.
  void restart();

  /// Puts the walls' start at time t into the stack. False at the first time, where there is
  /// nothing to extrapolate from.
  bool advance(double t);

  /// Builds the stack anew: new bodies join the unknowns, those there keep what they have.
  void rebuild();

 private:
  // Where the rods carry everything at a time, scaled, nothing empty. Per body.
  struct Carried {
    std::vector<Points> points;
    std::vector<std::vector<Mat3>> rotations;
    std::vector<std::vector<Pose>> sections;
  };
  // The walls' state at a time, in the rods' frames.
  struct Local {
    double time = 0;
    std::vector<Points> deviation;  // per body: of the vertices, turned back
    std::vector<std::vector<Pose>> sections;
    Eigen::VectorXd z;
  };
  Carried carried_at(double t) const;
  Local local_state() const;
  void turn_minimiser();

  CoupledStack& stack_;
  double time_ = 0;
  Carried carried_;            // at the present time
  std::optional<Local> last_;  // at the time before
};

}  // namespace vasorod
