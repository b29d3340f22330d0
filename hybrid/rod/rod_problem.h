// A rod with its conditions, in scaled units: its state, its energy, and how a step changes the
// state.
#pragma once

#include <vector>

#include "rod/conditions.h"
#include "rod/elimination.h"
#include "rod/scaled_rod.h"

namespace vasorod {

/// State of the mixed formulation: poses per node, strain and stress per link.
struct RodState {
  std::vector<Pose> poses;
  /// Per link: log(g_i^-1 g_j) of the poses.
  std::vector<Vec6> strain;
  std::vector<Vec6> stress;  ///< per link, an independent unknown
};

/// A linear step: twist of every node, stretch and new stress of every link.
struct RodStep {
  std::vector<Vec6> twist, stretch, stress;
  /// Largest rotation (radians) or translation (over the rod's length); infinite if an entry is
  /// NaN.
  double size() const;
};

/// A rod tree with its conditions, scaled, with the linear step of its elimination. `tree` and
/// `conditions` must outlive this.
class RodProblem {
 public:
  RodProblem(const RodTree& tree, const RodConditions& conditions);

  const RodTree& tree() const { return tree_; }
  const RodConditions& given() const { return given_; }
  const ScaledRod& rod() const { return rod_; }
  RodElimination& elimination() { return elimination_; }
  const std::vector<RodLink>& links() const { return elimination_.links(); }
  const std::vector<NodeCondition>& conditions() const { return elimination_.conditions(); }
  /// Whether a line search is possible: the poses of all nodes but the root follow from the strains
  /// of their links, and the loads have an energy.
  bool searchable() const { return searchable_; }
  bool has_energy() const { return !elimination_.has_nonconservative_moment(); }

  RodState state_at(const RodPoses& poses) const;  ///< unstressed
  void measure_strains(RodState& state) const;
  void take_elastic_stress(RodState& state) const;

  void set_time(double t);  ///< of motions and loads, 0 to 1
  /// Limits stretch and shear stiffness to `cap` times the local bending stiffness over L^2;
  /// harden() undoes this.
  void soften(double cap);
  void harden();
  /// Largest ratio of stretch or shear stiffness to bending stiffness over L^2.
  double stiffness_ratio() const;
  /// Bending stiffness of the weakest link over the mean.
  double weakest() const;

  /// Elastic energy with the present stiffness minus the work of the loads; the work of a moment is
  /// measured from `present`.
  double potential(const RodState& state, const RodState& present) const;
  /// Derivative of the potential along the step, where the stress is the elastic stress of the
  /// strain.
  double slope(const RodState& state, const RodStep& step) const;
  /// Moves `from` by a fraction of the step; the stress is left to the caller. A node with no
  /// support beyond it follows the strains, in which the step is linear, so stiff strains stay as
  /// small as in the step. Other nodes move by their own twists.
  void take(const RodState& from, const RodStep& step, double fraction, RodState& to) const;
  /// Updates NodeCondition::carried of all nodes with conditions; with `all` also of nodes that
  /// cannot move.
  void update_carried(const RodState& state, bool all);

 private:
  std::vector<NodeCondition> node_conditions() const;

  const RodTree& tree_;
  const RodConditions& given_;
  ScaledRod rod_;
  RodElimination elimination_;
  std::vector<std::vector<std::size_t>> links_at_;  // links that meet at the node of a condition
  std::vector<bool> follows_;                       // per node: no support beyond it
  bool searchable_ = false;
};

}  // namespace vasorod
