#include "rod/elimination.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/rigid_motion.h"
#include "rod/energy.h"
#include "rod/link_geometry.h"
#include "rod/small_products.h"

namespace vasorod {
namespace {

/// Pivots below this value, relative to the link's own stiffness, are round-off.
constexpr double neutral_pivot = 1e-10;

// Transforms from the twist of the second node to that of its parent, A = (1, -hat(lever); 0, 1):
// S_i += A^T S A, g_i += A^T g.
void move_to_parent(const Vec3& lever, const Mat6& s, const Vec6& g, bool first, Mat6& to_s,
                    Vec6& to_g) {
  const auto vv = s.topLeftCorner<3, 3>(), vw = s.topRightCorner<3, 3>();
  const Mat3 left = s.bottomLeftCorner<3, 3>() + cross_columns(lever, vv);
  const Mat3 right = vw - cross_rows(vv, lever);
  const Mat3 turn =
      s.bottomRightCorner<3, 3>() + cross_columns(lever, vw) - cross_rows(left, lever);
  const Vec3 moment = g.tail<3>() + lever.cross(g.head<3>());
  if (first) {
    to_s.topLeftCorner<3, 3>() = vv;
    to_s.topRightCorner<3, 3>() = right;
    to_s.bottomLeftCorner<3, 3>() = left;
    to_s.bottomRightCorner<3, 3>() = turn;
    to_g << g.head<3>(), moment;
    return;
  }
  to_s.topLeftCorner<3, 3>() += vv;
  to_s.topRightCorner<3, 3>() += right;
  to_s.bottomLeftCorner<3, 3>() += left;
  to_s.bottomRightCorner<3, 3>() += turn;
  to_g.head<3>() += g.head<3>();
  to_g.tail<3>() += moment;
}

/// The same for the forces (or conditions) of reactions: A^T B.
template <class Columns>
void move_to_parent(const Vec3& lever, Columns& b) {
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    const Vec3 force = b.col(c).template head<3>();
    b.col(c).template tail<3>() += lever.cross(force);
  }
}

/// J^T b for J = (j, b; 0, j).
template <class Columns>
Columns pull_back(const Mat3& j, const Mat3& b, const Columns& columns) {
  Columns k(6, columns.cols());
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    const Vec3 v = columns.col(c).template head<3>(), w = columns.col(c).template tail<3>();
    k.col(c).template head<3>() = j.transpose() * v;
    k.col(c).template tail<3>() = b.transpose() * v + j.transpose() * w;
  }
  return k;
}

/// Calls f(0), f(1), ... f(N - 1) with the number as a compile-time constant, so that every loop
/// bound in f is a constant.
template <class F, int... I>
[[gnu::always_inline]] inline void unrolled(std::integer_sequence<int, I...>, F&& f) {
  (f(std::integral_constant<int, I>{}), ...);
}

/// to -= factor * from, entries Begin to End (even numbers).
template <int Begin, int End>
[[gnu::always_inline]] inline void subtract(double* to, double factor, const double* from) {
  for (int i = Begin; i < End; ++i) to[i] -= factor * from[i];
}

}  // namespace

RodElimination::RodElimination(std::vector<RodLink> links, std::vector<NodeCondition> conditions)
    : links_(std::move(links)), conditions_(std::move(conditions)) {
  const std::size_t nodes = links_.size() + 1;
  condition_of_.assign(nodes, -1);
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    const NodeCondition& condition = conditions_[c];
    condition_of_[index(condition.node)] = static_cast<int>(c);
    const auto free_turns = std::count(condition.fixed.begin() + 3, condition.fixed.end(), false);
    if (free_turns > 1 && (condition.space_moment.norm() > 0 || condition.body_moment.norm() > 0))
      unsymmetric_ = true;
  }
  weight_.assign(nodes, 0);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    weight_[k + 1] += 0.5 * links_[k].length;
    weight_[index(links_[k].parent)] += 0.5 * links_[k].length;
  }
  s_.resize(nodes);
  g_.resize(nodes);
  begun_.resize(nodes);
  work_.resize(links_.size());
  channels_.set_up(links_, conditions_);
}

// Second-order terms of loads and reactions at a node.
//
// In the exponential coordinates of the node, a dead force F does the work F.(v + omega x v / 2).
// This form takes the fewest Newton steps. With `from_links`, the force that the links pass to the
// node is used in place of F (the two are equal at equilibrium). This corresponds to the
// coordinates r and omega, in which a dead load adds no second-order term, so the matrix of an
// unstressed rod is positive definite.
//
// A moment without an energy adds an antisymmetric part: -M/2 if dead in space, +M/2 in body axes.
void RodElimination::gather_node_terms(const std::vector<Pose>& poses, bool symmetric,
                                       bool from_links) {
  std::fill(begun_.begin(), begun_.end(), 0);
  for (const NodeCondition& c : conditions_) {
    const std::size_t k = index(c.node);
    begun_[k] = 1;
    s_[k].setZero();
    g_[k].setZero();
    const Pose& pose = poses[k];
    const Vec6 load = c.load(pose);
    g_[k] -= load;
    const int fixed = c.fixed_count();
    if (fixed == 6) continue;
    const Mat3 f = hat(0.5 * (from_links || fixed > 0 ? Vec3(c.carried.head<3>()) : c.force));
    s_[k].bottomLeftCorner<3, 3>() += f;
    s_[k].topRightCorner<3, 3>() -= f;
    if (!symmetric)
      s_[k].bottomRightCorner<3, 3>() += 0.5 * hat(load.tail<3>() - 2 * c.space_moment);
    if (c.fixed[3] || c.fixed[4] || c.fixed[5]) {
      const Vec3 turn = log_rotation(pose.rotation * c.target.rotation.transpose());
      const Vec3 reaction = c.carried.tail<3>() - load.tail<3>();
      Vec3 multiplier = c.frame.transpose() * (left_jacobian(turn).transpose() * reaction);
      for (int i = 0; i < 3; ++i)
        if (!c.fixed[index(3 + i)]) multiplier[i] = 0;
      // multiplier . log(exp(omega) R): Jl(x) = Jr(-x)
      const Mat3 d = -right_jacobian_inverse_transposed_derivative(-turn, c.frame * multiplier) *
                     left_jacobian_inverse(turn);
      s_[k].bottomRightCorner<3, 3>() -= 0.5 * (d + d.transpose());
    }
  }
}

void RodElimination::factor(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
                            const std::vector<Vec6>& stress, Purpose purpose, double shift) {
  const bool symmetric = purpose != Purpose::newton || !unsymmetric_;
  gather_node_terms(poses, symmetric, purpose == Purpose::descent);
  if (purpose == Purpose::newton)
    for (const GaugeSpring& spring : gauge_) {
      const std::size_t k = index(spring.node);
      if (!begun_[k]) {
        begun_[k] = 1;
        s_[k].setZero();
        g_[k].setZero();
      }
      s_[k] += spring.along * spring.along.transpose();
    }
  sweep(poses, strain, stress, symmetric, shift, nullptr);
}

void RodElimination::factor_mode(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
                                 const std::vector<Vec6>& stress, double shift,
                                 const std::vector<Vec6>& pull) {
  gather_node_terms(poses, true, false);
  for (const NodeCondition& c : conditions_) g_[index(c.node)].setZero();
  sweep(poses, strain, stress, true, shift, &pull);
}

void RodElimination::complete(std::size_t node, double shift, const std::vector<Vec6>* pull) {
  if (!begun_[node]) {
    s_[node].setZero();
    g_[node].setZero();
  }
  if (shift != 0) s_[node].diagonal().array() += shift * weight_[node];
  if (pull) g_[node] -= weight_[node] * (*pull)[node];
}

void RodElimination::sweep(const std::vector<Pose>& poses, const std::vector<Vec6>& strain,
                           const std::vector<Vec6>& stress, bool symmetric, double shift,
                           const std::vector<Vec6>* pull) {
  ++factorisations_;
  negative_ = 0;
  singular_ = false;
  general_ = !symmetric;
  channels_.restart();
  const bool homogeneous = pull != nullptr;
  for (std::size_t k = links_.size(); k-- > 0;) {
    const Pose &first = poses[index(links_[k].parent)], &second = poses[k + 1];
    const int node = static_cast<int>(k) + 1;
    complete(k + 1, shift, pull);
    if (channels_.begins_at(node)) {
      const Mat6& c = links_[k].stiffness;
      const int condition = condition_of_[k + 1];
      channels_.begin(node, condition >= 0 ? &conditions_[index(condition)] : nullptr, second,
                      10 * links_[k].length * std::min(c(3, 3), c(4, 4)), homogeneous, s_[k + 1],
                      g_[k + 1]);
    }
    if (symmetric)
      eliminate(k, first, second, strain[k], stress[k], homogeneous);
    else
      eliminate_unsymmetric(k, first, second, strain[k], stress[k]);
  }
  complete(0, shift, pull);
  eliminate_root(poses, homogeneous);
}

VASOROD_VECTORIZED
void RodElimination::eliminate(std::size_t k, const Pose& first, const Pose& second,
                               const Vec6& strain, const Vec6& stress, bool homogeneous) {
  const RodLink& link = links_[k];
  LinkWork& work = work_[k];
  const LinkGeometry geometry = link_geometry(strain, stress);
  work.j = times(second.rotation, geometry.j);
  work.b = times(second.rotation, geometry.b);
  work.lever = second.position - first.position;
  if (homogeneous)
    work.eps.setZero();
  else
    work.eps = strain - link.natural;
  const Mat6& s = s_[k + 1];
  const Mat3 &j = work.j, &b = work.b;
  const auto vv = s.topLeftCorner<3, 3>(), vw = s.topRightCorner<3, 3>(),
             wv = s.bottomLeftCorner<3, 3>(), ww = s.bottomRightCorner<3, 3>();

  const Mat3 a11 = transposed_times(j, vv);  // Jr^T S
  Mat3 a12 = transposed_times(j, vw), a21 = transposed_times(b, vv, j, wv),
       a22 = transposed_times(b, vw, j, ww);
  const Mat3 t21 = times(a21, j) + geometry.g12;  // T - C/L; g12 is symmetric
  Mat6 t;
  t.topLeftCorner<3, 3>() = times(a11, j);
  t.bottomLeftCorner<3, 3>() = t21;
  t.topRightCorner<3, 3>() = t21.transpose();
  t.bottomRightCorner<3, 3>() = times(a21, b) + times(a22, j) + geometry.g22;

  // P has the blocks (0, f; f, m): f = -hat(force)/2, m = -hat(moment)/2
  const Vec3 f = second.rotation * (-0.5 * geometry.force),
             m = second.rotation * (-0.5 * geometry.moment);
  const Mat3 jf = transposed_cross(j, f);
  a12 += jf;
  a21 += jf;
  a22 += transposed_cross(b, f) + transposed_cross(j, m);

  const Vec6& g = g_[k + 1];
  Vec6 q;
  for (int r = 0; r < 3; ++r) {
    q[r] = j(0, r) * g[0] + j(1, r) * g[1] + j(2, r) * g[2];
    q[r + 3] = b(0, r) * g[0] + b(1, r) * g[1] + b(2, r) * g[2] + j(0, r) * g[3] + j(1, r) * g[4] +
               j(2, r) * g[5];
  }
  for (int c = 0; c < 6; ++c)
    for (int r = 0; r < 6; ++r) q[r] -= t(r, c) * work.eps[c];
  t += link.stiffness;

  auto& w = work.w;
  alignas(32) double next[6][8];  // S - Q^T T^-1 Q and g - Q^T (eps + T^-1 q)
  alignas(32) double l[6][6];     // rows of T, of which only the upper part is used
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      w[r][c] = a11(r, c);
      w[r][c + 3] = a12(r, c);
      w[r + 3][c] = a21(r, c);
      w[r + 3][c + 3] = a22(r, c);
    }
    w[r][6] = q[r];
    w[r + 3][6] = q[r + 3];
    w[r][7] = w[r + 3][7] = 0;
  }
  for (int r = 0; r < 6; ++r) {
    double pull = g[r];
    for (int c = 0; c < 6; ++c) {
      l[r][c] = t(c, r);
      next[r][c] = s(c, r);
      pull -= w[c][r] * work.eps[c];
    }
    next[r][6] = pull;
    next[r][7] = 0;
  }
  // T = L D L^T; C leads with its stiff rows, so no pivoting is needed for accuracy
  constexpr auto six = std::make_integer_sequence<int, 6>{};
  bool low = false;
  unrolled(six, [&](auto column) VASOROD_INLINE {
    constexpr int c = column, even = (c + 1) & ~1;
    double pivot = l[c][c];
    low = low || !(pivot > neutral_pivot * link.stiffness(c, c));
    if (pivot == 0) pivot = 1e-300;
    const double inverse = 1 / pivot;
    work.inverse_pivot[c] = inverse;
    unrolled(std::make_integer_sequence<int, 5 - c>{}, [&](auto below) VASOROD_INLINE {
      constexpr int r = c + 1 + below;
      const double factor = l[c][r] * inverse;
      work.lower[r * (r - 1) / 2 + c] = factor;
      subtract<even, 6>(l[r], factor, l[c]);
      subtract<0, 8>(w[r], factor, w[c]);
    });
  });
  unrolled(six, [&](auto row) VASOROD_INLINE {
    constexpr int r = row;
    for (int c = 0; c < 6; ++c)
      subtract<(r & ~1), 8>(next[r], w[c][r] * work.inverse_pivot[c], w[c]);
  });
  if (low) check_pivots(k, t);

  Mat6 passed_s;
  Vec6 passed_g;
  for (int r = 0; r < 6; ++r) {
    for (int c = r; c < 6; ++c) passed_s(r, c) = passed_s(c, r) = next[r][c];
    passed_g[r] = next[r][6];
  }
  if (const int at = channels_.segment_of(k); at >= 0) {
    SupportChannels::Segment& segment = channels_.segment(at);
    SupportChannels::Matrix6& gain = channels_.gains()[index(channels_.gain_of(k))];
    gain = pull_back(j, b, segment.force);
    segment.rest += gain.transpose() * work.eps;
    for (int c = 0; c < 5; ++c)
      for (int r = c + 1; r < 6; ++r) gain.row(r) -= work.lower[r * (r - 1) / 2 + c] * gain.row(c);
    for (int c = 0; c < 6; ++c) {
      const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 6> row = gain.row(c);
      const double inverse = work.inverse_pivot[c];
      segment.compliance += inverse * row.transpose() * row;
      segment.rest += (inverse * w[c][6]) * row.transpose();
      const Vec6 q_row = Eigen::Map<const Vec6>(w[c]);
      segment.force -= inverse * q_row * row;
    }
    move_to_parent(work.lever, segment.force);
    segment.row = segment.force;
  }
  const std::size_t parent = index(link.parent);
  move_to_parent(work.lever, passed_s, passed_g, !begun_[parent], s_[parent], g_[parent]);
  begun_[parent] = 1;
}

/// Determines the signs of the eigenvalues of T when its pivots do not.
void RodElimination::check_pivots(std::size_t k, const Mat6& t) {
  const Vec6 scale = links_[k].stiffness.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(scale.asDiagonal() * t * scale.asDiagonal(),
                                                  Eigen::EigenvaluesOnly);
  singular_ = singular_ || !(eigen.eigenvalues().array().abs() > neutral_pivot).all();
  negative_ += static_cast<int>((eigen.eigenvalues().array() < 0).count());
}

void RodElimination::eliminate_unsymmetric(std::size_t k, const Pose& first, const Pose& second,
                                           const Vec6& strain, const Vec6& stress) {
  const RodLink& link = links_[k];
  LinkWork& work = work_[k];
  const LinkGeometry geometry = link_geometry(strain, stress);
  work.j = second.rotation * geometry.j;
  work.b = second.rotation * geometry.b;
  work.lever = second.position - first.position;
  work.eps = strain - link.natural;
  const Mat6& s = s_[k + 1];
  const Vec6& g = g_[k + 1];
  Mat6 jacobian = Mat6::Zero(), p = Mat6::Zero(), t = Mat6::Zero();
  jacobian.topLeftCorner<3, 3>() = jacobian.bottomRightCorner<3, 3>() = work.j;
  jacobian.topRightCorner<3, 3>() = work.b;
  p.topRightCorner<3, 3>() = p.bottomLeftCorner<3, 3>() =
      hat(second.rotation * (-0.5 * geometry.force));
  p.bottomRightCorner<3, 3>() = hat(second.rotation * (-0.5 * geometry.moment));
  t.topRightCorner<3, 3>() = t.bottomLeftCorner<3, 3>() = geometry.g12;
  t.bottomRightCorner<3, 3>() = geometry.g22;
  t += jacobian.transpose() * s * jacobian;
  const Mat6 q_right = jacobian.transpose() * (s + p),
             q_left = jacobian.transpose() * (s.transpose() + p);
  const Vec6 q = jacobian.transpose() * g - t * work.eps;
  t += link.stiffness;
  const Eigen::PartialPivLU<Mat6> lu(t);
  const Mat6 z = lu.solve(q_right);
  const Vec6 z0 = lu.solve(q);
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) work.w[r][c] = z(r, c);
    work.w[r][6] = z0[r];
    work.w[r][7] = 0;
  }
  if (const int at = channels_.segment_of(k); at >= 0) {
    SupportChannels::Segment& segment = channels_.segment(at);
    SupportChannels::Matrix6& gain = channels_.gains()[index(channels_.gain_of(k))];
    const SupportChannels::Matrix6 row = pull_back(work.j, work.b, segment.row);
    gain = lu.solve(pull_back(work.j, work.b, segment.force));
    segment.force -= q_left.transpose() * gain;
    segment.row -= z.transpose() * row;
    segment.compliance += row.transpose() * gain;
    segment.rest += row.transpose() * (work.eps + z0);
    move_to_parent(work.lever, segment.force);
    move_to_parent(work.lever, segment.row);
  }
  const std::size_t parent = index(link.parent);
  move_to_parent(work.lever, s - q_left.transpose() * z, g - q_left.transpose() * (work.eps + z0),
                 !begun_[parent], s_[parent], g_[parent]);
  begun_[parent] = 1;
}

void RodElimination::eliminate_root(const std::vector<Pose>& poses, bool homogeneous) {
  const int c = condition_of_[0];
  root_step_ = channels_.close(c >= 0 ? &conditions_[index(c)] : nullptr, poses[0], homogeneous,
                               s_[0], g_[0], negative_, singular_);
  negative_ += channels_.negative_pivots() - channels_.condition_count();
}

void RodElimination::solve(std::vector<Vec6>& step, std::vector<Vec6>& stress,
                           std::vector<Vec6>& stretch) {
  ++solves_;
  step.resize(links_.size() + 1);
  stress.resize(links_.size());
  stretch.resize(links_.size());
  step[0] = root_step_;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const LinkWork& work = work_[k];
    const Vec6& parent = step[index(links_[k].parent)];
    Vec6 carried = parent;  // A zeta_i
    carried.head<3>() += parent.tail<3>().cross(work.lever);
    Vec6 y;
    for (int r = 0; r < 6; ++r) {
      double sum = work.w[r][6];
      for (int c = 0; c < 6; ++c) sum += work.w[r][c] * carried[c];
      y[r] = -sum;
    }
    const int segment = channels_.segment_of(k);
    if (segment >= 0)
      y -= channels_.gains()[index(channels_.gain_of(k))] * channels_.segment(segment).reaction;
    if (!general_) {
      for (int r = 0; r < 6; ++r) y[r] *= work.inverse_pivot[r];
      for (int r = 4; r >= 0; --r)
        for (int i = r + 1; i < 6; ++i) y[r] -= work.lower[i * (i - 1) / 2 + r] * y[i];
    }
    stretch[k] = y - work.eps;
    const Vec3 v = stretch[k].head<3>(), u = stretch[k].tail<3>();
    step[k + 1].head<3>() = carried.head<3>() + work.j * v + work.b * u;
    step[k + 1].tail<3>() = carried.tail<3>() + work.j * u;
    stress[k].noalias() = links_[k].stiffness * y;
    const int node = static_cast<int>(k) + 1;
    if (segment >= 0 && channels_.begins_at(node)) channels_.spread(node, step[k + 1]);
  }
}

}  // namespace vasorod
