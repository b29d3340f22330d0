#include "rod/elimination.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rigid_motion.h"
#include "rod/energy.h"

namespace vasorod {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Frames of one link in numbers: strain, right Jacobian, derivative of Jr^-T(xi) s.
struct LinkKinematics {
  Vec3 v, u;  // xi
  Mat3 j, b;  // right Jacobian (j, b; 0, j) in the second node's body axes
  LogCoefficients log;
};

LinkKinematics kinematics(const Pose& first, const Pose& second) {
  LinkKinematics k;
  const Vec3 t = first.rotation.transpose() * (second.position - first.position);
  k.u = log_rotation(first.rotation.transpose() * second.rotation);
  const double z = k.u.squaredNorm();
  k.log = log_coefficients(z);
  const Vec3 ut = k.u.cross(t);
  k.v = t - 0.5 * ut + k.log.c * k.u.cross(ut);
  const ExpCoefficients e = exp_coefficients(z);
  // (hat u)^2 = u u^T - z I and its derivative in the direction v
  const double uv = k.u.dot(k.v);
  const Mat3 hu = hat(k.u);
  k.j = e.d * k.u * k.u.transpose() - e.b * hu;
  k.j.diagonal().array() += 1 - e.d * z;
  const Mat3 cross = k.v * k.u.transpose();
  k.b = e.d * (cross + cross.transpose()) + uv * (e.d2 * k.u * k.u.transpose() - e.b2 * hu) - e.b * hat(k.v);
  k.b.diagonal().array() -= 2 * e.d * uv + uv * e.d2 * z;
  return k;
}

/// The bracket term's blocks (0, f; f, m) with f = -hat(force)/2, m = -hat(moment)/2.
struct Bracket {
  Mat3 f, m;
  explicit Bracket(const Vec6& wrench) : f(hat(-0.5 * wrench.head<3>())), m(hat(-0.5 * wrench.tail<3>())) {}
  Mat6 full() const {
    Mat6 p = Mat6::Zero();
    p.topRightCorner<3, 3>() = p.bottomLeftCorner<3, 3>() = f;
    p.bottomRightCorner<3, 3>() = m;
    return p;
  }
};

/// Jr^-T s in space axes: the wrench a link's stress puts on its second node.
Vec6 wrench_of(const LinkKinematics& k, const Mat3& rotation, const Vec6& s) {
  const Vec3 n = s.head<3>(), m = s.tail<3>();
  const Vec3 un = k.u.cross(n), um = k.u.cross(m), vn = k.v.cross(n);
  const Vec3 uun = k.u.cross(un);
  const Vec3 wn = n - 0.5 * un + k.log.c * uun;
  const Vec3 wm = m - 0.5 * (um + vn) + k.log.c * (k.u.cross(um) + k.u.cross(vn) + k.v.cross(un)) +
                  k.log.c2 * k.u.dot(k.v) * uun;
  Vec6 w;
  w << rotation * wn, rotation * wm;
  return w;
}

///

/// Number of negative eigenvalues of a symmetric matrix relative to `scale`, the direction of the lowest, and
/// whether one is neutral: within round-off of zero, a direction that costs nothing, neither up nor down.
int negative_eigenvalues(const Eigen::MatrixXd& t, const Eigen::VectorXd& scale, Eigen::VectorXd& lowest,
                         double neutral, bool& singular) {
  const Eigen::VectorXd s = scale.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(s.asDiagonal() * t * s.asDiagonal());
  lowest = s.asDiagonal() * eigen.eigenvectors().col(0);
  singular = singular || (eigen.eigenvalues().array().abs() <= neutral).any();
  return static_cast<int>((eigen.eigenvalues().array() < -neutral).count());
}

/// Orthonormal bases of what a node's support fixes (columns of n) and leaves (z), and the step the fixed
/// part needs.
struct FreedomSplit {
  Eigen::Matrix<double, 6, Eigen::Dynamic> fixed, free;
  Vec6 step = Vec6::Zero();
};

FreedomSplit split(const NodeCondition& condition, const Pose& pose) {
  const int count = condition.fixed_count();
  Eigen::Matrix<double, Eigen::Dynamic, 6> rows = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(count, 6);
  Eigen::VectorXd rest(count);
  const Vec3 gap = condition.target.position - pose.position;
  const Vec3 turn = log_rotation(pose.rotation * condition.target.rotation.transpose());
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
  FreedomSplit s;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows.transpose());
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(6, 6);
  s.fixed = q.leftCols(count);
  s.free = q.rightCols(6 - count);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  s.step = s.fixed * r.transpose().triangularView<Eigen::Lower>().solve(rest);
  return s;
}

}  // namespace

Vec6 NodeCondition::load(const Pose& pose) const {
  Vec6 sum;
  sum << force, space_moment + pose.rotation * body_moment;
  return sum;
}

int NodeCondition::fixed_count() const {
  return static_cast<int>(std::count(fixed.begin(), fixed.end(), true));
}

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
    // what eps of the stretch stiffness is to the link's own bending stiffness
    const Mat6& c = links_[k].stiffness;
    neutral_ = std::max(neutral_, 10 * std::numeric_limits<double>::epsilon() * links_[k].length *
                                      c.diagonal().head<3>().maxCoeff() / std::min(c(3, 3), c(4, 4)));
  }
  s_.resize(nodes);
  g_.resize(nodes);
  work_.resize(links_.size());
}

// // // Second-order terms of loads and reactions at a node. In its exponential coordinates a dead force F
// does the work F.(v + omega x v / 2); that form takes fewest steps. With the force that the links pass to
// the node in place of F
// (`from_links`; the same at equilibrium) the coordinates are r and omega instead, in which a dead load adds
// nothing: an unstressed rod's matrix is then positive. A moment without energy adds an antisymmetric part,
// -M/2 dead in space, +M/2 in the body.
void RodElimination::add_node_terms(const std::vector<Pose>& poses, bool symmetric, bool from_links) {
  for (std::size_t k = 0; k < s_.size(); ++k) {
    s_[k].setZero();
    g_[k].setZero();
  }
  for (const NodeCondition& c : conditions_) {
    const std::size_t k = index(c.node);
    const Pose& pose = poses[k];
    const Vec6 load = c.load(pose);
    g_[k] -= load;
    const int fixed = c.fixed_count();
    if (fixed == 6) continue;
    const Mat3 f = hat(0.5 * (from_links || fixed > 0 ? Vec3(c.carried.head<3>()) : c.force));
    s_[k].bottomLeftCorner<3, 3>() += f;
    s_[k].topRightCorner<3, 3>() -= f;
    if (!symmetric) s_[k].bottomRightCorner<3, 3>() += 0.5 * hat(load.tail<3>() - 2 * c.space_moment);
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

void RodElimination::factor(const std::vector<Pose>& poses, const std::vector<Vec6>& stress, Purpose purpose,
                            double shift) {
  const bool symmetric = purpose != Purpose::newton || !unsymmetric_;
  negative_ = 0;
  singular_ = false;
  negative_node_ = -1;
  add_node_terms(poses, symmetric, purpose == Purpose::descent);
  if (shift > 0)
    for (std::size_t k = 0; k < s_.size(); ++k) s_[k].diagonal().array() += shift * weight_[k];
  for (std::size_t k = links_.size(); k-- > 0;) {
    const Pose &first = poses[index(links_[k].parent)], &second = poses[k + 1];
    const int c = condition_of_[k + 1];
    if (c >= 0 && conditions_[index(c)].supported())
      eliminate_constrained(k, first, second, stress[k]);
    else if (symmetric)
      eliminate_free<true>(k, first, second, stress[k]);
    else
      eliminate_free<false>(k, first, second, stress[k]);
  }
  eliminate_root(poses);
}

template <bool symmetric>
void RodElimination::eliminate_free(std::size_t k, const Pose& first, const Pose& second,
                                    const Vec6& stress) {
  const RodLink& link = links_[k];
  LinkWork& work = work_[k];
  const LinkKinematics kin = kinematics(link_start(link, first), second);
  work.kind = symmetric ? LinkWork::Kind::symmetric : LinkWork::Kind::general;
  work.j = second.rotation * kin.j;
  work.b = second.rotation * kin.b;
  work.eps << kin.v, kin.u;
  work.lever = second.position - first.position;
  const Vec6 xi = work.eps;
  work.eps -= link.natural;
  const Bracket p(wrench_of(kin, second.rotation, stress));
  const Mat6& s = s_[k + 1];

  Mat6 js;  // Jr^T S
  js.topRows<3>().noalias() = work.j.transpose() * s.topRows<3>();
  js.bottomRows<3>().noalias() = work.b.transpose() * s.topRows<3>();
  js.bottomRows<3>().noalias() += work.j.transpose() * s.bottomRows<3>();
  Mat6 jp = Mat6::Zero();  // Jr^T P
  jp.topRightCorner<3, 3>().noalias() = work.j.transpose() * p.f;
  jp.bottomLeftCorner<3, 3>() = jp.topRightCorner<3, 3>();
  jp.bottomRightCorner<3, 3>().noalias() = work.b.transpose() * p.f;
  jp.bottomRightCorner<3, 3>().noalias() += work.j.transpose() * p.m;
  const Mat6 q_right = js + jp;

  Mat6 t = geometric_stiffness(xi, stress);  // T - C/L
  t.leftCols<3>().noalias() += js.leftCols<3>() * work.j;
  t.rightCols<3>().noalias() += js.leftCols<3>() * work.b;
  t.rightCols<3>().noalias() += js.rightCols<3>() * work.j;
  Vec6 jg;  // Jr^T g
  jg.head<3>().noalias() = work.j.transpose() * g_[k + 1].head<3>();
  jg.tail<3>().noalias() =
      work.b.transpose() * g_[k + 1].head<3>() + work.j.transpose() * g_[k + 1].tail<3>();
  Vec6 q = jg - t * work.eps;
  t += link.stiffness;

  if constexpr (!symmetric) {
    Mat6 jst;  // Jr^T S^T
    jst.topRows<3>().noalias() = work.j.transpose() * s.leftCols<3>().transpose();
    jst.bottomRows<3>().noalias() = work.b.transpose() * s.leftCols<3>().transpose();
    jst.bottomRows<3>().noalias() += work.j.transpose() * s.rightCols<3>().transpose();
    const Mat6 q_left = jst + jp;
    const Eigen::PartialPivLU<Mat6> lu(t);
    work.z = lu.solve(q_right);
    work.z0 = lu.solve(q);
    pass_to_parent(k, s - q_left.transpose() * work.z, g_[k + 1] - q_left.transpose() * (work.eps + work.z0));
    return;
  }

  // T = L D L^T; C leads with its stiff rows, so no pivoting is needed for accuracy
  const auto decompose = [&] {
    bool low = false;
    for (int c = 0; c < 6; ++c) {
      double d = t(c, c);
      for (int i = 0; i < c; ++i) d -= work.lower(c, i) * work.lower(c, i) * work.pivot[i];
      if (d == 0 || !std::isfinite(d)) {
        singular_ = true;
        d = 1e-300 + 1e-16 * std::abs(t(c, c));
      }
      work.pivot[c] = d;
      low = low || d < neutral_ * link.stiffness(c, c);
      for (int r = c + 1; r < 6; ++r) {
        double x = t(r, c);
        for (int i = 0; i < c; ++i) x -= work.lower(r, i) * work.lower(c, i) * work.pivot[i];
        work.lower(r, c) = x / d;
      }
    }
    return low;
  };
  if (decompose()) {
    Eigen::VectorXd lowest;
    const int negative = negative_eigenvalues(t, link.stiffness.diagonal(), lowest, neutral_, singular_);
    negative_ += negative;
    if (negative > 0) {
      negative_node_ = static_cast<int>(k) + 1;
      negative_stretch_ = lowest;
      negative_twist_ << work.j * lowest.head<3>() + work.b * lowest.tail<3>(), work.j * lowest.tail<3>();
    }
  }
  work.z = q_right;
  work.z0 = q;
  for (int c = 0; c < 5; ++c)
    for (int r = c + 1; r < 6; ++r) {
      work.z.row(r) -= work.lower(r, c) * work.z.row(c);
      work.z0[r] -= work.lower(r, c) * work.z0[c];
    }
  const Mat6 scaled = work.pivot.cwiseInverse().asDiagonal() * work.z;
  pass_to_parent(k, s - work.z.transpose() * scaled,
                 g_[k + 1] - q_right.transpose() * work.eps - scaled.transpose() * work.z0);
}

// delta = Z delta_z + u, u = E a + step, E = N N^T the projector on what is fixed (b = delta - a has b_n =
// step_n). What the node's side does along fixed directions is a constant and drops out of S and g first.
void RodElimination::eliminate_constrained(std::size_t k, const Pose& first, const Pose& second,
                                           const Vec6& stress) {
  const RodLink& link = links_[k];
  LinkWork& work = work_[k];
  const LinkKinematics kin = kinematics(link_start(link, first), second);
  const FreedomSplit freedom = split(conditions_[index(condition_of_[k + 1])], second);
  work.kind = LinkWork::Kind::constrained;
  work.lever = second.position - first.position;
  Vec6 xi;
  xi << kin.v, kin.u;
  work.eps = xi - link.natural;
  Mat6 turn = Mat6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = second.rotation.transpose();
  work.lower = right_jacobian_inverse(xi) * turn;
  const Mat6 p = Bracket(wrench_of(kin, second.rotation, stress)).full();
  const auto& z = freedom.free;
  const Mat6 fixed = freedom.fixed * freedom.fixed.transpose(), open = z * z.transpose();
  const Vec6 g = open * (g_[k + 1] + s_[k + 1] * freedom.step);
  const Mat6 s = open * s_[k + 1] * open;
  const Mat6 t = work.lower.transpose() * (link.stiffness + geometric_stiffness(xi, stress)) * work.lower + s;
  const Vec6 elastic = work.lower.transpose() * (link.stiffness * work.eps);
  work.z = fixed;
  work.z0 = freedom.step;
  Mat6 passed_s = fixed * t * fixed - fixed * p + p * fixed + s;
  Vec6 passed_g = fixed * (elastic + t * freedom.step) + p * freedom.step - g;
  if (z.cols() > 0) {
    const Eigen::MatrixXd tzz = z.transpose() * t * z;
    const Eigen::MatrixXd right = z.transpose() * (t * fixed - (s + p));
    const Eigen::MatrixXd left = (fixed * t - (s - p)) * z;
    const Eigen::VectorXd rhs = z.transpose() * (elastic + t * freedom.step + g);
    const Mat6 stiff = work.lower.transpose() * link.stiffness * work.lower;
    Eigen::VectorXd lowest;
    const int negative = negative_eigenvalues(
        0.5 * (tzz + tzz.transpose()), (z.transpose() * stiff * z).diagonal(), lowest, neutral_, singular_);
    if (negative > 0) {
      negative_ += negative;
      negative_node_ = static_cast<int>(k) + 1;
      negative_twist_ = z * lowest;
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(tzz);
    const Eigen::MatrixXd gain = lu.solve(right);
    const Eigen::VectorXd offset = lu.solve(rhs);
    work.z -= z * gain;
    work.z0 -= z * offset;
    passed_s -= left * gain;
    passed_g -= left * offset;
  }
  pass_to_parent(k, passed_s, -passed_g);
}

// From the second node's twist space to its parent's: A = (1, -lever; 0, 1), S_i += A^T S A, g_i += A^T g.
void RodElimination::pass_to_parent(std::size_t k, const Mat6& s, const Vec6& g) {
  const Vec3& t = work_[k].lever;
  const Mat3 h = hat(t);
  const std::size_t parent = index(links_[k].parent);
  Mat6& to = s_[parent];
  const Mat3 left = h * s.topLeftCorner<3, 3>() + s.bottomLeftCorner<3, 3>();
  to.topLeftCorner<3, 3>() += s.topLeftCorner<3, 3>();
  to.topRightCorner<3, 3>() += s.topRightCorner<3, 3>() - s.topLeftCorner<3, 3>() * h;
  to.bottomLeftCorner<3, 3>() += left;
  to.bottomRightCorner<3, 3>() += s.bottomRightCorner<3, 3>() + h * s.topRightCorner<3, 3>() - left * h;
  g_[parent].head<3>() += g.head<3>();
  g_[parent].tail<3>() += g.tail<3>() + t.cross(g.head<3>());
}

void RodElimination::eliminate_root(const std::vector<Pose>& poses) {
  const int c = condition_of_[0];
  FreedomSplit freedom;
  if (c >= 0 && conditions_[index(c)].supported())
    freedom = split(conditions_[index(c)], poses[0]);
  else
    freedom.free = Mat6::Identity();
  root_step_ = freedom.step;
  const auto& z = freedom.free;
  if (z.cols() == 0) return;
  const Eigen::MatrixXd t = z.transpose() * s_[0] * z;
  const Eigen::VectorXd rhs = z.transpose() * (g_[0] + s_[0] * freedom.step);
  Eigen::VectorXd lowest;
  const double size = std::max(t.diagonal().cwiseAbs().maxCoeff(), 1e-300);
  const int negative = negative_eigenvalues(
      0.5 * (t + t.transpose()), Eigen::VectorXd::Constant(z.cols(), size), lowest, neutral_, singular_);
  if (negative > 0) {
    negative_ += negative;
    negative_node_ = 0;
    negative_twist_ = z * lowest;
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(t);
  if (!lu.isInvertible()) singular_ = true;
  root_step_ -= z * lu.solve(rhs);
}

// Without `stress` the homogeneous problem: no misfit, no loads.
void RodElimination::walk_back(std::vector<Vec6>& step, std::vector<Vec6>& stretch, int from,
                               std::vector<Vec6>* stress) const {
  const bool homogeneous = stress == nullptr;
  for (std::size_t k = index(from); k < links_.size(); ++k) {
    const LinkWork& work = work_[k];
    const Vec6& parent = step[index(links_[k].parent)];
    Vec6 carried = parent;  // A zeta_i
    carried.head<3>() += parent.tail<3>().cross(work.lever);
    Vec6 y;  // stretch = y - eps = Jr^-1 delta
    if (work.kind == LinkWork::Kind::constrained) {
      Vec6 delta = -(work.z * carried);
      if (!homogeneous) delta += work.z0;
      step[k + 1] = delta + carried;
      stretch[k].noalias() = work.lower * delta;
      y = stretch[k] + work.eps;
    } else {
      y.noalias() = -(work.z * carried);
      if (!homogeneous) y -= work.z0;
      if (work.kind == LinkWork::Kind::symmetric) {
        y = y.cwiseQuotient(work.pivot);
        for (int r = 4; r >= 0; --r)
          for (int i = r + 1; i < 6; ++i) y[r] -= work.lower(i, r) * y[i];
      }
      stretch[k] = homogeneous ? y : Vec6(y - work.eps);
      const Vec3 v = stretch[k].head<3>(), u = stretch[k].tail<3>();
      step[k + 1].head<3>() = carried.head<3>() + work.j * v + work.b * u;
      step[k + 1].tail<3>() = carried.tail<3>() + work.j * u;
    }
    if (!homogeneous) (*stress)[k].noalias() = links_[k].stiffness * y;
  }
}

void RodElimination::solve(std::vector<Vec6>& step, std::vector<Vec6>& stress,
                           std::vector<Vec6>& stretch) const {
  step.resize(links_.size() + 1);
  stress.resize(links_.size());
  stretch.resize(links_.size());
  step[0] = root_step_;
  walk_back(step, stretch, 0, &stress);
}

void RodElimination::negative_direction(std::vector<Vec6>& step, std::vector<Vec6>& stretch) const {
  step.assign(links_.size() + 1, Vec6::Zero());
  stretch.assign(links_.size(), Vec6::Zero());
  if (negative_node_ < 0) return;
  const std::size_t node = index(negative_node_);
  step[node] = negative_twist_;
  if (node > 0) {
    const LinkWork& work = work_[node - 1];
    if (work.kind == LinkWork::Kind::constrained)
      stretch[node - 1] = work.lower * negative_twist_;
    else
      stretch[node - 1] = negative_stretch_;
  }
  // nodes nearer to the root, and other branches, stay where they are
  walk_back(step, stretch, negative_node_, nullptr);
}

}  // namespace vasorod
