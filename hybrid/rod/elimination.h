// The linear step of a rod: one sweep from the leaves to the root and one back, 6 x 6 blocks, O(n).
//
// Unknown of a node is its twist zeta = (v, omega) in space axes about the node itself: R ->
// exp(omega) R, r -> r + Jl(omega) v. Each link (element) carries its own stress s beside the
// strain its frames have (mixed, or Hellinger-Reissner): linearised,
//   y = eps + Jr^-1 delta,  eps = log(g_i^-1 g_j) - L n,  delta = zeta_j - A zeta_i,  s_new = C y /
//   L,
// and the geometric term uses the stress s of the last step (Magisano, Leonetti, Garcea 2017). What
// lies beyond a node answers with the force S zeta + g + B lambda, where lambda are the reactions
// of the supports there, B^T zeta - D lambda = d (support_channels.h). Per link, with P the bracket
// term w.[a, b]/2 of the wrench w = Jr^-T s, a = -A zeta_i:
//   T = C/L + Jr^T S Jr + G(s),  Q = Jr^T (S + P),  q = Jr^T g - (T - C/L) eps,  K = Jr^T B,
//   y = T^-1 (Q a - q - K lambda)
//   S -> S - Q^T T^-1 Q,  g -> g - Q^T (eps + T^-1 q)      (moved to node i by A^T . A)
//   B -> B - Q^T T^-1 K,  D -> D + K^T T^-1 K,  d -> d + K^T (eps + T^-1 q)
// This form never subtracts two stiff numbers: stretch and shear enter by their small compliance,
// in D and in T^-1, so 1e5 elements and EA L^2/EI = 1e13 cost no digits, between clamps as on a
// free end. The signs of all pivots are the inertia of the Hessian.
#pragma once

#include <vector>

#include "data/index.h"
#include "rod/link.h"
#include "rod/support_channels.h"

namespace vasorod {

/// What a factorisation is for. Newton: the full tangent. Descent and certificate: the energy's
/// Hessian, symmetric.
enum class Purpose { newton, descent, certificate };

/// A spring against the step of one node, of stiffness along along^T.
struct GaugeSpring {
  int node = 0;
  Vec6 along = Vec6::Zero();
};

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
  /// A moment acts on a node that may turn about more than one axis: no energy, tangent not
  /// symmetric.
  bool has_nonconservative_moment() const { return unsymmetric_; }
  /// Half the length of the links at a node: the weight of the unit stiffness that `shift` adds.
  double weight(int node) const { return weight_[index(node)]; }

  /// Leaf to root. `strain` is log(g_i^-1 g_j), `stress` the stress in the geometric term, both per
  /// link. `shift` adds that stiffness per length to every freedom of every node, so that the step
  /// goes down and stays short.
  void factor(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
              const std::vector<Vec6>& stress, Purpose purpose = Purpose::newton, double shift = 0);
  /// Springs that Newton's steps feel, against motions along symmetries.
  void set_gauge(std::vector<GaugeSpring> springs) { gauge_ = std::move(springs); }
  /// The same for (Hessian + shift) step = weight * pull with all misfits and loads left out.
  void factor_mode(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
                   const std::vector<Vec6>& stress, double shift, const std::vector<Vec6>& pull);
  /// Root to leaf: the step of every node and the new stress of every link.
  /// `stretch` is each link's change of log(g_i^-1 g_j), in which the step is linear.
  void solve(std::vector<Vec6>& step, std::vector<Vec6>& stress, std::vector<Vec6>& stretch);

  /// Negative directions of the last factorisation's matrix on the motions that the supports leave.
  int negative_directions() const { return negative_; }
  /// A pivot is zero to round-off: a direction costs nothing.
  bool singular() const { return singular_; }

 private:
  /// What the way back needs, per link. Of T = L D L^T: w = L^-1 (Q, q), rows padded to 8.
  struct LinkWork {
    alignas(32) double w[6][8];
    double lower[15];  // below the diagonal, row by row: (r, c) at r (r - 1) / 2 + c
    double inverse_pivot[6];
    Mat3 j, b;  // Jr in space axes: (j, b; 0, j)
    Vec6 eps;
    Vec3 lever;  // r_j - r_i
  };
  void gather_node_terms(const std::vector<Pose>& poses, bool symmetric, bool from_links);
  /// S and g of a node when all beyond it is in: with the shift, and the pull in place of loads.
  void complete(std::size_t node, double shift, const std::vector<Vec6>* pull);
  void sweep(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
             const std::vector<Vec6>& stress, bool symmetric, double shift,
             const std::vector<Vec6>* pull);
  void eliminate(std::size_t k, const Pose& first, const Pose& second, const Vec6& strain,
                 const Vec6& stress, bool homogeneous);
  void eliminate_unsymmetric(std::size_t k, const Pose& first, const Pose& second,
                             const Vec6& strain, const Vec6& stress);
  void check_pivots(std::size_t k, const Mat6& t);
  void eliminate_root(const std::vector<Pose>& poses, bool homogeneous);

  std::vector<RodLink> links_;
  std::vector<NodeCondition> conditions_;
  std::vector<int> condition_of_;  // per node, -1: none
  std::vector<double> weight_;
  bool unsymmetric_ = false;
  bool general_ = false;  // the last factorisation was of an unsymmetric matrix
  std::vector<Mat6> s_;   // gathered per node
  std::vector<Vec6> g_;
  std::vector<char> begun_;  // whether something is in s_ and g_ already
  std::vector<LinkWork> work_;
  std::vector<GaugeSpring> gauge_;
  SupportChannels channels_;
  Vec6 root_step_ = Vec6::Zero();
  int negative_ = 0;
  bool singular_ = false;
};

}  // namespace vasorod
