// Looks for the shape that a body has without stress from the one that it was seen in: the seen
// shape less a displacement x under which the body is in equilibrium there (Bols et al., J. Comput.
// Appl. Math. 246, 2013). A step is K^-1 times what x leaves out of balance: to first order, moving
// the shape without stress by -dx is deforming the body by dx. Steps are accelerated (anderson.h).
// K is the stiffness of the body without stress throughout: the stress acts on the seen shape,
// which does not move.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace vasorod {

/// The largest strain of a linear prestress, RMS over a wall: some 0.1 away from its held ends.
/// Beyond, the shape without stress is looked for.
inline constexpr double largest_linear_prestrain = 0.08;

/// The body. Its unknowns are those of a linear solve.
class StressFreeProblem {
 public:
  virtual ~StressFreeProblem() = default;
  /// Puts a share of the load and the shape without stress that x leads from. False: there is no
  /// such shape.
  virtual bool set(double share, const Eigen::VectorXd& x) = 0;
  /// The step from the x that is set: minus K^-1 times the forces.
  virtual Eigen::VectorXd step(const Eigen::VectorXd& x) = 0;
  /// The length of a displacement, of any norm; 1 is a large one.
  virtual double length(const Eigen::VectorXd& x) const = 0;
};

/// Takes x from the linear displacement to that from the shape without stress: at once, or on a way
/// of more and more shares of the load. Returns the number of steps; 0: not found, or `stop` says
/// so, and x is as it was.
int search_stress_free(StressFreeProblem& problem, Eigen::VectorXd& x,
                       const std::function<bool()>& stop = {});

}  // namespace vasorod
