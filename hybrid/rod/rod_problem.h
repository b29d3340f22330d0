// A rod under its conditions, in scaled units: what a state is, what it costs, and how a step
// changes it.
#pragma once

#include <vector>

#include "rod/conditions.h"
#include "rod/elimination.h"
#include "rod/scaled_rod.h"

namespace vasorod {

struct RodState {
  std::vector<Pose> poses;
  std::vector<Vec6> strain;  ///< log(g_i^-1 g_j) per link, what the poses have
  std::vector<Vec6> stress;  ///< per link, its own unknown
};

/// A linear step: twist of every node, stretch and new stress of every link.
struct RodStep {
  std::vector<Vec6> twist, stretch, stress;
  /// Largest rotation (radians) or translation (over the rod's length); infinite where not a
  /// number.
  double size() const;
};

class RodProblem {
 public:
  RodProblem(const RodTree& tree, const RodConditions& conditions);

  const RodTree& tree() const { return tree_; }
  const RodConditions& given() const { return given_; }
  const ScaledRod& rod() const { return rod_; }
  RodElimination& elimination() { return elimination_; }
  const std::vector<RodLink>& links() const { return elimination_.links(); }
  const std::vector<NodeCondition>& conditions() const { return elimination_.conditions(); }
  /// All nodes but the root follow their links' strains, and the loads have an energy that can be
  /// searched.
  bool searchable() const { return searchable_; }
  bool has_energy() const { return !elimination_.has_nonconservative_moment(); }

  RodState state_at(const RodPoses& poses) const;  ///< unstressed
  void measure_strains(RodState& state) const;
  void take_elastic_stress(RodState& state) const;

  void set_time(double t);  ///< of motions and loads, 0 to 1
  /// Stretch and shear stiffness at most `cap` times the local bending stiffness over L^2.
  void soften(double cap);
  void harden();
  /// Largest ratio of stretch or shear stiffness to bending stiffness over L^2.
  double stiffness_ratio() const;
  /// Bending stiffness of the weakest link, over the mean.
  double weakest() const;

  /// Elastic energy with the present stiffness minus the work of the loads, a moment's counted from
  /// `present`.
  double potential(const RodState& state, const RodState& present) const;
  /// Derivative of the potential along the step, where the stress is the strain's.
  double slope(const RodState& state, const RodStep& step) const;
  /// `from` moved by a fraction of the step; the stress is left to the caller. Where nothing beyond
  /// a node is held it follows the strains, in which the step is linear: stiff strains then stay as
  /// small as the step left them. Elsewhere nodes move by their own twists.
  void take(const RodState& from, const RodStep& step, double fraction, RodState& to) const;
  /// What the links pass to the nodes with conditions; with `all` also to those that cannot move.
  void update_carried(const RodState& state, bool all);

 private:
  std::vector<NodeCondition> node_conditions() const;

  const RodTree& tree_;
  const RodConditions& given_;
  ScaledRod rod_;
  RodElimination elimination_;
  std::vector<std::vector<std::size_t>> links_at_;  // links that meet a condition's node
  std::vector<bool> follows_;                       // per node: nothing beyond it is held
  bool searchable_ = false;
};

}  // namespace vasorod
