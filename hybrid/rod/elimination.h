// The linear step of a rod: one sweep from the leaves to the root and one back, 6 x 6 blocks, O(n).
//
// Unknowns. The unknown of a node is its twist zeta = (v, omega) in space axes about the node
// itself:
//
//   R -> exp(omega) R,   r -> r + Jl(omega) v
//
// Each link (element) has its own stress s in addition to the strain given by its frames (mixed, or
// Hellinger-Reissner, formulation). Linearised:
//
//   y     = eps + Jr^-1 delta
//   eps   = log(g_i^-1 g_j) - L n
//   delta = zeta_j - A zeta_i
//   s_new = C y / L
//
// The geometric term uses the stress s of the last step (Magisano, Leonetti, Garcea 2017).
//
// Elimination. The part of the rod beyond a node responds with the force S zeta + g + B lambda,
// where lambda are the reactions of the supports there, B^T zeta - D lambda = d
// (support_channels.h). Per link, with P the bracket term w.[a, b]/2 of the wrench w = Jr^-T s,
// a = -A zeta_i:
//
//   T = C/L + Jr^T S Jr + G(s)
//   Q = Jr^T (S + P)
//   q = Jr^T g - (T - C/L) eps
//   K = Jr^T B
//   y = T^-1 (Q a - q - K lambda)
//
//   S -> S - Q^T T^-1 Q
//   g -> g - Q^T (eps + T^-1 q)      (moved to node i by A^T . A)
//   B -> B - Q^T T^-1 K
//   D -> D + K^T T^-1 K
//   d -> d + K^T (eps + T^-1 q)
//
// This form never subtracts two large stiffnesses: stretch and shear enter by their small
// compliance, in D and in T^-1. Therefore 1e5 elements and EA L^2/EI = 1e13 lose no digits, between
// clamps as well as on a free end. The signs of all pivots give the inertia of the Hessian.
#pragma once

#include <vector>

#include "data/index.h"
#include "rod/link.h"
#include "rod/support_channels.h"

namespace vasorod {

/// Purpose of a factorisation. Newton: the full tangent. Descent and certificate: the Hessian of
/// the energy, symmetric.
enum class Purpose { newton, descent, certificate };

/// A spring that acts on the step of one node, with stiffness along along^T.
struct GaugeSpring {
  int node = 0;
  Vec6 along = Vec6::Zero();
};

/// One linear step and its by-products. All quantities in scaled units (scaled_rod.h).
class RodElimination {
 public:
  /// Links ordered so that the parent of each node precedes it; conditions at distinct nodes.
  RodElimination(std::vector<RodLink> links, std::vector<NodeCondition> conditions);

  int node_count() const { return static_cast<int>(links_.size()) + 1; }
  std::vector<RodLink>& links() { return links_; }
  const std::vector<RodLink>& links() const { return links_; }
  std::vector<NodeCondition>& conditions() { return conditions_; }
  const std::vector<NodeCondition>& conditions() const { return conditions_; }
  /// Whether a moment acts on a node that may turn about more than one axis. Such a moment has no
  /// energy, and the tangent is not symmetric.
  bool has_nonconservative_moment() const { return unsymmetric_; }
  /// Half the length of the links at a node: the node's weight for the stiffness that `shift` adds.
  double weight(int node) const { return weight_[index(node)]; }

  /// Sweep from the leaves to the root. `strain` is log(g_i^-1 g_j), `stress` the stress in the
  /// geometric term, both per link. `shift` adds a stiffness of this value per length to every
  /// freedom of every node, so that the step is a short descent step.
  void factor(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
              const std::vector<Vec6>& stress, Purpose purpose = Purpose::newton, double shift = 0);
  /// Springs that act in Newton steps only; they suppress motions along symmetries.
  void set_gauge(std::vector<GaugeSpring> springs) { gauge_ = std::move(springs); }
  /// The same for (Hessian + shift) step = weight * pull, with all misfits and loads set to zero.
  void factor_mode(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
                   const std::vector<Vec6>& stress, double shift, const std::vector<Vec6>& pull);
  /// Sweep from the root to the leaves: the step of every node and the new stress of every link.
  /// `stretch` is the change of log(g_i^-1 g_j) of each link, which is linear in the step.
  void solve(std::vector<Vec6>& step, std::vector<Vec6>& stress, std::vector<Vec6>& stretch);

  int factorisations() const { return factorisations_; }  ///< sweeps to the root so far
  int solves() const { return solves_; }                  ///< sweeps to the leaves so far

  /// Number of negative directions of the last factorised matrix within the motions that the
  /// supports leave free.
  int negative_directions() const { return negative_; }
  /// Whether a pivot is zero to round-off: there is a zero-energy direction.
  bool singular() const { return singular_; }

 private:
  /// Per link, data for the sweep back. With T = L D L^T: w = L^-1 (Q, q), rows padded to 8.
  struct LinkWork {
    alignas(32) double w[6][8];
    double lower[15];  // below the diagonal, row by row: (r, c) at r (r - 1) / 2 + c
    double inverse_pivot[6];
    Mat3 j, b;  // Jr in space axes: (j, b; 0, j)
    Vec6 eps;
    Vec3 lever;  // r_j - r_i
  };
  void gather_node_terms(const std::vector<Pose>& poses, bool symmetric, bool from_links);
  /// Completes S and g of a node once everything beyond it has been added: applies the shift, and
  /// the pull in place of loads.
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
  std::vector<char> begun_;  // whether s_ and g_ have been initialised
  std::vector<LinkWork> work_;
  std::vector<GaugeSpring> gauge_;
  SupportChannels channels_;
  Vec6 root_step_ = Vec6::Zero();
  int negative_ = 0, factorisations_ = 0, solves_ = 0;
  bool singular_ = false;
};

}  // namespace vasorod
