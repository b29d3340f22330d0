// The linear step of a rod: one sweep from the leaves to the root and one back, 6 x 6 blocks, O(n).
//
// Unknown of a node is its twist zeta = (v, omega) in space axes about the node itself: R -> exp(omega) R,
// r -> r + Jl(omega) v. Each link (element) carries its own stress s beside the strain its frames have
// (mixed, or Hellinger-Reissner): linearised,
//   y = eps + Jr^-1 delta,  eps = log(g_i^-1 g_j) - L n,  delta = zeta_j - A zeta_i,  s_new = C y / L,
// and the geometric term uses the stress s of the last step (Magisano, Leonetti, Garcea 2017). Per link, with
// S, g what the node's own side has gathered so far and P the bracket term w.[a, b]/2 of the wrench w = Jr^-T
// s, a = -A zeta_i:
//   T = C/L + Jr^T S Jr + G(s),  Q = Jr^T (S + P),  q = Jr^T g - (T - C/L) eps,   y = T^-1 (Q a - q)
//   S -> S - Q^T T^-1 Q,  g -> g - Q^T (eps + T^-1 q)      (moved to node i by A^T . A)
// This form never subtracts two stiff numbers: where nothing holds the leaf side, S and g pass through
// untouched, so 1e5 elements and EA L^2/EI = 1e13 cost no digits. The signs of the pivots of all T are the
// inertia of the Hessian.
#pragma once

#include <array>
#include <vector>

#include "rod/conditions.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// An element between scaled, renumbered nodes: node k + 1 hangs on `parent` by link k.
struct RodLink {
  int parent = 0;
  double length = 0;
  bool starts_at_node = true;  ///< false: `start` is the link's own frame at its parent
  Pose start;
  Vec6 natural = Vec6::Zero();    ///< length * natural strain
  Mat6 stiffness = Mat6::Zero();  ///< C / length
};

/// /// The frame a link starts from.
inline Pose link_start(const RodLink& link, const Pose& parent) {
  return link.starts_at_node ? parent : parent * link.start;
}

/// What acts on one node. Forces scaled.
struct NodeCondition {
  int node = 0;
  std::array<bool, 6> fixed{};
  Mat3 frame = Mat3::Identity();
  Pose target;  ///< at the present time of the motion's path
  Vec3 force = Vec3::Zero(), space_moment = Vec3::Zero(), body_moment = Vec3::Zero();
  /// Force and moment about the node that its links' stresses pass to it; in equilibrium the load and the
  /// reaction.
  Vec6 carried = Vec6::Zero();

  Vec6 load(const Pose& pose) const;  ///< force and moment in space axes
  int fixed_count() const;
  bool supported() const { return fixed_count() > 0; }
};

/// What a factorisation is for. Newton: the full tangent. Descent and certificate: the energy's Hessian,
/// symmetric.
enum class Purpose { newton, descent, certificate };

/// One linear step and its by-products.
class RodElimination {
 public:
  /// Links in an order in which a node's parent precedes it; conditions at distinct nodes.
  RodElimination(std::vector<RodLink> links, std::vector<NodeCondition> conditions);

  int node_count() const { return static_cast<int>(links_.size()) + 1; }
  std::vector<RodLink>& links() { return links_; }
  const std::vector<RodLink>& links() const { return links_; }
  std::vector<NodeCondition>& conditions() { return conditions_; }
  const std::vector<NodeCondition>& conditions() const { return conditions_; }
  /// A moment acts on a node that may turn about more than one axis: no energy, tangent not symmetric.
  bool has_nonconservative_moment() const { return unsymmetric_; }

  /// Leaf to root. `stress` is per link. With `certify`, the symmetric part alone: the energy's Hessian.
  ///  `shift` adds that stiffness per length to every freedom of every node, so that the step goes down and
  ///  stays short.
  void factor(const std::vector<Pose>& poses, const std::vector<Vec6>& stress,
              Purpose purpose = Purpose::newton, double shift = 0);
  /// Root to leaf: the step of every node and the new stress of every link.
  /// `stretch` is each link's change of log(g_i^-1 g_j), in which the step is linear.
  void solve(std::vector<Vec6>& step, std::vector<Vec6>& stress, std::vector<Vec6>& stretch) const;
  /// log(g_i^-1 g_j) of a link at the last factorisation.
  Vec6 strain(std::size_t link) const { return work_[link].eps + links_[link].natural; }

  /// Negative pivots of the last factorisation = negative directions of the (constrained) Hessian.
  int negative_pivots() const { return negative_; }
  bool singular() const { return singular_; }
  /// A direction of negative curvature, after a factorisation with at least one negative pivot.
  void negative_direction(std::vector<Vec6>& step, std::vector<Vec6>& stretch) const;

 private:
  /// What the way back needs, per link.
  struct LinkWork {
    enum class Kind { symmetric, general, constrained } kind = Kind::symmetric;
    Mat6 z;      ///< L^-1 Q; general: T^-1 Q; constrained: delta = z a + z0
    Vec6 z0;     ///< L^-1 q; general: T^-1 q
    Mat6 lower;  ///< unit lower factor of T; constrained: Jr^-1
    Vec6 pivot;  ///< D of T = L D L^T
    Mat3 j, b;   ///< Jr in space axes: (j, b; 0, j)
    Vec6 eps;
    Vec3 lever;  ///< r_j - r_i
  };
  void add_node_terms(const std::vector<Pose>& poses, bool symmetric, bool from_links);
  template <bool symmetric>
  void eliminate_free(std::size_t k, const Pose& first, const Pose& second, const Vec6& stress);
  void eliminate_constrained(std::size_t k, const Pose& first, const Pose& second, const Vec6& stress);
  void eliminate_root(const std::vector<Pose>& poses);
  void pass_to_parent(std::size_t k, const Mat6& s, const Vec6& g);
  void walk_back(std::vector<Vec6>& step, std::vector<Vec6>& stretch, int from,
                 std::vector<Vec6>* stress) const;

  std::vector<RodLink> links_;
  std::vector<NodeCondition> conditions_;
  std::vector<int> condition_of_;  // per node, -1: none
  std::vector<double> weight_;     // per node, half the length of its links
  bool unsymmetric_ = false;
  double neutral_ = 1e-10;  // pivots this small, relative to the link's own stiffness, are round-off
  std::vector<Mat6> s_;     // gathered per node
  std::vector<Vec6> g_;
  std::vector<LinkWork> work_;
  Vec6 root_step_ = Vec6::Zero();
  int negative_ = 0;
  bool singular_ = false;
  int negative_node_ = -1;  // nearest to the root of the nodes whose pivot block is indefinite
  Vec6 negative_twist_ = Vec6::Zero(), negative_stretch_ = Vec6::Zero();
};

}  // namespace vasorod
