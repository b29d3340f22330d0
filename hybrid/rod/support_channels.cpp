#include "rod/support_channels.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

/// Scaling factors that bring the largest entry of every row and column close to one; the signs of
/// the eigenvalues do not change.
Eigen::VectorXd balance(const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(matrix.rows());
  for (int round = 0; round < 8; ++round)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const double largest =
          std::max((scale[i] * matrix.row(i).transpose().cwiseProduct(scale)).cwiseAbs().maxCoeff(),
                   (scale[i] * matrix.col(i).cwiseProduct(scale)).cwiseAbs().maxCoeff());
      if (largest > 0 && std::isfinite(largest)) scale[i] /= std::sqrt(largest);
    }
  return scale;
}

}  // namespace

void SupportChannels::set_up(const std::vector<RodLink>& links,
                             const std::vector<NodeCondition>& conditions) {
  const std::size_t nodes = links.size() + 1;
  segment_of_.assign(links.size(), -1);
  gain_of_.assign(links.size(), -1);
  join_of_.assign(nodes, -1);
  std::vector<int> own(nodes, 0),
      passing(nodes, -1);  // `passing`: the one segment that arrives, -2: several
  for (const NodeCondition& c : conditions) own[index(c.node)] = c.fixed_count();
  std::vector<std::vector<int>> arriving;  // of the nodes with several
  std::vector<int> several(nodes, -1);
  const auto arrive = [&](std::size_t node, int segment) {
    if (passing[node] == -1) {
      passing[node] = segment;
      return;
    }
    if (several[node] < 0) {
      several[node] = static_cast<int>(arriving.size());
      arriving.push_back({passing[node]});
      passing[node] = -2;
    }
    arriving[index(several[node])].push_back(segment);
  };
  const auto join_at = [&](std::size_t node) -> Join& {
    join_of_[node] = static_cast<int>(joins_.size());
    joins_.emplace_back();
    if (several[node] >= 0)
      joins_.back().from = arriving[index(several[node])];
    else if (passing[node] >= 0)
      joins_.back().from = {passing[node]};
    return joins_.back();
  };
  int gains = 0;
  for (std::size_t k = links.size(); k-- > 0;) {
    const std::size_t node = k + 1;
    int segment = passing[node];
    if (own[node] > 0 || several[node] >= 0) {
      Join& join = join_at(node);
      join.own = own[node];
      condition_count_ += join.own;
      int arrive_count = 0;
      for (const int s : join.from) arrive_count += segments_[index(s)].count;
      segment = join.to = static_cast<int>(segments_.size());
      segments_.emplace_back();
      segments_.back().count = join.own + std::min(arrive_count, 6 - join.own);
    }
    if (segment < 0) continue;
    segment_of_[k] = segment;
    gain_of_[k] = gains++;
    arrive(index(links[k].parent), segment);
  }
  join_at(0);
  gains_.resize(index(gains));
}

SupportChannels::Split SupportChannels::split(const NodeCondition& condition, const Pose& pose,
                                              bool homogeneous) {
  Split s;
  const int count = condition.fixed_count();
  const Vec3 gap = condition.target.position - pose.position;
  const Vec3 turn = log_rotation(pose.rotation * condition.target.rotation.transpose());
  if (count == 6) {
    s.fixed = Mat6::Identity();
    s.free.resize(6, 0);
    if (!homogeneous) s.step << gap, -turn;
    return s;
  }
  Eigen::Matrix<double, Eigen::Dynamic, 6> rows =
      Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(count, 6);
  Eigen::VectorXd rest(count);
  const Mat3 inverse = left_jacobian_inverse(turn);
  int row = 0;
  for (int k = 0; k < 6; ++k) {
    if (!condition.fixed[index(k)]) continue;
    const Vec3 axis = condition.frame.col(k % 3);
    if (k < 3) {
      rows.row(row).head<3>() = axis;
      rest[row] = axis.dot(gap);
    } else {
      rows.row(row).tail<3>() = axis.transpose() * inverse;
      rest[row] = -axis.dot(turn);
    }
    ++row;
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows.transpose());
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(6, 6);
  s.fixed = q.leftCols(count);
  s.free = q.rightCols(6 - count);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  if (!homogeneous) s.step = s.fixed * r.transpose().triangularView<Eigen::Lower>().solve(rest);
  return s;
}

SupportChannels::Arrivals SupportChannels::arrivals(const Join& join) const {
  Eigen::Index count = 0;
  for (const int s : join.from) count += segments_[index(s)].count;
  Arrivals all;
  all.force.resize(6, count);
  all.row.resize(6, count);
  all.compliance = Eigen::MatrixXd::Zero(count, count);
  all.rest.resize(count);
  Eigen::Index at = 0;
  for (const int s : join.from) {
    const Segment& segment = segments_[index(s)];
    const Eigen::Index n = segment.count;
    all.force.middleCols(at, n) = segment.force;
    all.row.middleCols(at, n) = segment.row;
    all.compliance.block(at, at, n, n) = segment.compliance;
    all.rest.segment(at, n) = segment.rest;
    at += n;
  }
  return all;
}

void SupportChannels::hand_out(const Join& join, const Eigen::VectorXd& reactions) {
  Eigen::Index at = 0;
  for (const int s : join.from) {
    Segment& segment = segments_[index(s)];
    segment.reaction = reactions.segment(at, segment.count);
    at += segment.count;
  }
}

void SupportChannels::begin(int node, const NodeCondition* support, const Pose& pose,
                            double softness, bool homogeneous, Mat6& s, Vec6& g) {
  Join& join = joins_[index(join_of_[index(node)])];
  Segment& segment = segments_[index(join.to)];
  Arrivals all = arrivals(join);
  Split held;
  if (join.own > 0) {
    held = split(*support, pose, homogeneous);
    // motion along fixed directions is prescribed: zeta = open zeta + step
    const Mat6 open = held.free * held.free.transpose();
    g = open * (g + s * held.step).eval();
    s = open * s * open;
    all.rest -= all.row.transpose() * held.step;
    all.force = (open * all.force).eval();
    all.row = (open * all.row).eval();
    // a spring along fixed directions changes only the reactions, and prevents the branch from
    // buckling as if it were free
    s += softness * held.fixed * held.fixed.transpose();
    g -= softness * held.step;
  }
  join.eliminated.clear();
  join.kept.resize(static_cast<std::size_t>(all.rest.size()));
  std::iota(join.kept.begin(), join.kept.end(), 0);
  while (static_cast<int>(join.kept.size()) > segment.count - join.own) {
    const auto softest =
        std::max_element(join.kept.begin(), join.kept.end(), [&](Eigen::Index a, Eigen::Index b) {
          return std::abs(all.compliance(a, a)) < std::abs(all.compliance(b, b));
        });
    const Eigen::Index e = *softest;
    join.kept.erase(softest);
    Eliminated out{e, all.row.col(e), all.compliance.row(e).transpose(), all.rest[e],
                   all.compliance(e, e)};
    if (out.pivot == 0) out.pivot = 1e-300;
    negative_pivots_ += out.pivot > 0;
    const Vec6 force = all.force.col(e) / out.pivot;
    const Eigen::VectorXd column = all.compliance.col(e) / out.pivot;
    s += force * out.row.transpose();
    g -= force * out.rest;
    all.force -= force * out.coupling.transpose();
    all.row -= out.row * column.transpose();
    all.rest -= column * out.rest;
    all.compliance -= column * out.coupling.transpose();
    for (std::size_t i = 0; i < static_cast<std::size_t>(out.coupling.size()); ++i)
      if (std::find(join.kept.begin(), join.kept.end(), static_cast<Eigen::Index>(i)) ==
          join.kept.end())
        out.coupling[static_cast<Eigen::Index>(i)] = 0;
    join.eliminated.push_back(std::move(out));
  }
  const auto kept = static_cast<Eigen::Index>(join.kept.size());
  segment.force.resize(6, segment.count);
  segment.row.resize(6, segment.count);
  segment.compliance.setZero(segment.count, segment.count);
  segment.rest.resize(segment.count);
  segment.reaction.resize(segment.count);
  for (Eigen::Index i = 0; i < kept; ++i) {
    const Eigen::Index from = join.kept[static_cast<std::size_t>(i)];
    segment.force.col(i) = all.force.col(from);
    segment.row.col(i) = all.row.col(from);
    segment.rest[i] = all.rest[from];
    for (Eigen::Index j = 0; j < kept; ++j)
      segment.compliance(i, j) = all.compliance(from, join.kept[static_cast<std::size_t>(j)]);
  }
  if (join.own > 0) {
    segment.force.rightCols(join.own) = segment.row.rightCols(join.own) = held.fixed;
    segment.rest.tail(join.own) = held.fixed.transpose() * held.step;
  }
}

void SupportChannels::spread(int node, const Vec6& twist) {
  const Join& join = joins_[index(join_of_[index(node)])];
  if (join.from.empty()) return;
  Eigen::VectorXd reactions =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(join.kept.size() + join.eliminated.size()));
  const Segment& segment = segments_[index(join.to)];
  for (std::size_t i = 0; i < join.kept.size(); ++i)
    reactions[join.kept[i]] = segment.reaction[static_cast<Eigen::Index>(i)];
  for (auto e = join.eliminated.rbegin(); e != join.eliminated.rend(); ++e)
    reactions[e->channel] = (e->row.dot(twist) - e->rest - e->coupling.dot(reactions)) / e->pivot;
  hand_out(join, reactions);
}

Vec6 SupportChannels::close(const NodeCondition* support, const Pose& pose, bool homogeneous,
                            const Mat6& s, const Vec6& g, int& negative, bool& singular) {
  const Join& join = joins_[index(join_of_[0])];
  Split held;
  if (support && support->supported())
    held = split(*support, pose, homogeneous);
  else
    held.free = Mat6::Identity();
  const Arrivals all = arrivals(join);
  const Eigen::Index open = held.free.cols(), n = open + all.rest.size();
  if (n == 0) return held.step;
  Eigen::MatrixXd matrix(n, n);
  matrix.topLeftCorner(open, open) = held.free.transpose() * s * held.free;
  matrix.topRightCorner(open, n - open) = held.free.transpose() * all.force;
  matrix.bottomLeftCorner(n - open, open) = all.row.transpose() * held.free;
  matrix.bottomRightCorner(n - open, n - open) = -all.compliance;
  Eigen::VectorXd rhs(n);
  rhs.head(open) = -held.free.transpose() * (g + s * held.step);
  rhs.tail(n - open) = all.rest - all.row.transpose() * held.step;
  const Eigen::VectorXd scale = balance(matrix);
  matrix = (scale.asDiagonal() * matrix * scale.asDiagonal()).eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (matrix + matrix.transpose()),
                                                             Eigen::EigenvaluesOnly);
  constexpr double neutral = 1e-11;  // of a balanced matrix: round-off of the sweep
  negative += static_cast<int>((eigen.eigenvalues().array() < 0).count());
  if ((eigen.eigenvalues().array().abs() <= neutral).any()) singular = true;
  const Eigen::VectorXd x = scale.asDiagonal() * Eigen::FullPivLU<Eigen::MatrixXd>(matrix).solve(
                                                     (scale.asDiagonal() * rhs).eval());
  hand_out(join, x.tail(n - open));
  return held.step + held.free * x.head(open);
}

}  // namespace vasorod
