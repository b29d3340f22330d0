// The reactions of supports as unknowns of the elimination.
//
// A support that fixes c directions N of a node (N^T zeta = rest) adds c channels: a force N lambda
// whose size is found at the root. Carried towards the root past a link, a channel becomes
//   force B lambda on the node,   B^T zeta - D lambda = d,
// D the compliance gathered on the way. At most six of them go on from a node: where branches that
// are both held meet, the softest are eliminated there (largest D first), so that nothing stiff is
// ever added to a stiffness.
#pragma once

#include <vector>

#include "data/index.h"
#include "rod/link.h"

namespace vasorod {

class SupportChannels {
 public:
  using Matrix6 = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
  /// The channels along a run of links between two nodes where something changes.
  struct Segment {
    int count = 0;
    Matrix6 force,
        row;  ///< B as a force and as a condition: the same unless the matrix is unsymmetric
    Small compliance;       ///< D
    Column rest, reaction;  ///< d, lambda
  };

  void set_up(const std::vector<RodLink>& links, const std::vector<NodeCondition>& conditions);

  /// The segment a link belongs to, -1 if nothing beyond it is supported.
  int segment_of(std::size_t link) const { return segment_of_[link]; }
  Segment& segment(int s) { return segments_[index(s)]; }
  const Segment& segment(int s) const { return segments_[index(s)]; }
  /// Per link of a segment: L^-1 K (T^-1 K for an unsymmetric matrix), what the way back needs.
  std::vector<Matrix6>& gains() { return gains_; }
  const std::vector<Matrix6>& gains() const { return gains_; }
  int gain_of(std::size_t link) const { return gain_of_[link]; }

  /// What a support fixes of a node's twist: orthonormal columns, and the step that the fixed part
  /// needs.
  struct Split {
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6> fixed, free;
    Vec6 step = Vec6::Zero();
  };
  static Split split(const NodeCondition& condition, const Pose& pose, bool homogeneous);

  /// At a node (not the root) with a support or several held branches, before its link is
  /// eliminated: s and g are the node's. `softness`: bending stiffness of its link, the scale of
  /// the spring that a support adds along what it fixes (exact: it changes reactions only).
  void begin(int node, const NodeCondition* support, const Pose& pose, double softness,
             bool homogeneous, Mat6& s, Vec6& g);
  /// At the root: twist and reactions. `t` is the matrix of what is left there, for its inertia.
  Vec6 close(const NodeCondition* support, const Pose& pose, bool homogeneous, const Mat6& s,
             const Vec6& g, int& negative, bool& singular);
  /// On the way back: the reactions of all segments that begin at this node's children and of its
  /// own support.
  void spread(int node, const Vec6& twist);
  bool begins_at(int node) const { return join_of_[index(node)] >= 0; }

  /// Negative pivots of the reactions eliminated on the way, and how many conditions there are in
  /// all.
  int negative_pivots() const { return negative_pivots_; }
  int condition_count() const { return condition_count_; }
  void restart() { negative_pivots_ = 0; }

 private:
  /// All channels that arrive at a node.
  struct Arrivals {
    Eigen::Matrix<double, 6, Eigen::Dynamic> force, row;
    Eigen::MatrixXd compliance;
    Eigen::VectorXd rest;
  };
  /// A channel found from the twist and the channels that were still there:
  /// lambda = (row.zeta - rest - coupling.lambda) / pivot.
  struct Eliminated {
    Eigen::Index channel = 0;
    Vec6 row;
    Eigen::VectorXd coupling;
    double rest = 0, pivot = 0;
  };
  /// Where segments end and one begins.
  struct Join {
    std::vector<int> from;  // segments that end here
    int own = 0, to = -1;   // conditions of the node's own support; the segment that begins
    std::vector<Eliminated> eliminated;
    std::vector<Eigen::Index> kept;
  };
  Arrivals arrivals(const Join& join) const;
  void hand_out(const Join& join, const Eigen::VectorXd& reactions);

  std::vector<int> segment_of_, gain_of_, join_of_;
  std::vector<Segment> segments_;
  std::vector<Join> joins_;
  std::vector<Matrix6> gains_;
  int negative_pivots_ = 0, condition_count_ = 0;
};

}  // namespace vasorod
