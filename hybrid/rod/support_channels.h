// The reactions of supports as unknowns of the elimination.
//
// A support that fixes c directions N of a node (N^T zeta = rest) adds c channels: a force N lambda
// whose magnitude is determined at the root. Moved towards the root past a link, a channel becomes
//
//   force B lambda on the node,   B^T zeta - D lambda = d
//
// with D the compliance accumulated along the path. At most six channels continue from a node.
// Where several supported branches meet, the softest channels are eliminated at the node (largest D
// first), so that no large stiffness is ever added to a stiffness.
#pragma once

#include <vector>

#include "data/index.h"
#include "rod/link.h"

namespace vasorod {

/// All channels of a rod, kept between eliminations.
class SupportChannels {
 public:
  using Matrix6 = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
  /// The channels along a sequence of links between two nodes where the set of channels changes.
  struct Segment {
    int count = 0;
    /// B as a force and as a condition: equal unless the matrix is unsymmetric.
    Matrix6 force, row;
    Small compliance;       ///< D
    Column rest, reaction;  ///< d, lambda
  };

  void set_up(const std::vector<RodLink>& links, const std::vector<NodeCondition>& conditions);

  /// The segment of a link, -1 if nothing beyond the link is supported.
  int segment_of(std::size_t link) const { return segment_of_[link]; }
  Segment& segment(int s) { return segments_[index(s)]; }
  const Segment& segment(int s) const { return segments_[index(s)]; }
  /// Per link of a segment, for the sweep back: L^-1 K (T^-1 K for an unsymmetric matrix).
  std::vector<Matrix6>& gains() { return gains_; }
  const std::vector<Matrix6>& gains() const { return gains_; }
  int gain_of(std::size_t link) const { return gain_of_[link]; }

  /// Split of a node's twist by its support: orthonormal columns of fixed and free directions, and
  /// the step required in the fixed directions.
  struct Split {
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6> fixed, free;
    Vec6 step = Vec6::Zero();
  };
  static Split split(const NodeCondition& condition, const Pose& pose, bool homogeneous);

  /// Starts a segment at a node (not the root) with a support or several supported branches, before
  /// its link is eliminated. s and g are those of the node. `softness`: bending stiffness of its
  /// link, the scale of the spring added along the fixed directions (exact: it changes only the
  /// reactions).
  void begin(int node, const NodeCondition* support, const Pose& pose, double softness,
             bool homogeneous, Mat6& s, Vec6& g);
  /// Solves at the root; returns its twist. s and g are what remains there; the negative
  /// eigenvalues of the final system are added to `negative`, and `singular` is set if an
  /// eigenvalue is zero to round-off.
  Vec6 close(const NodeCondition* support, const Pose& pose, bool homogeneous, const Mat6& s,
             const Vec6& g, int& negative, bool& singular);
  /// In the sweep back: computes the reactions of all segments that end at this node.
  void spread(int node, const Vec6& twist);
  bool begins_at(int node) const { return join_of_[index(node)] >= 0; }

  /// Number of negative pivots of the reactions eliminated so far, and total number of conditions.
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
  /// A channel computed from the twist and the channels remaining at the time:
  ///
  /// ```
  /// lambda = (row.zeta - rest - coupling.lambda) / pivot
  /// ```
  struct Eliminated {
    Eigen::Index channel = 0;
    Vec6 row;
    Eigen::VectorXd coupling;
    double rest = 0, pivot = 0;
  };
  /// A node at which segments end and a new one begins.
  struct Join {
    std::vector<int> from;  // segments that end here
    // own: number of conditions of the node's own support. to: the segment that begins.
    int own = 0, to = -1;
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
