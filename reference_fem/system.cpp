#include "reference_fem/system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"

namespace vasorod::fem {

using std::size_t;

namespace {

/// Change of a member's value under the pose increment (translation, spin) in the section's axes.
Eigen::Matrix<double, 3, 6> member_columns(const Section& section, const Member& member,
                                           const Mat3& R) {
  Eigen::Matrix<double, 3, 6> columns;
  columns.leftCols<3>() = member.follows_center ? section.axes : Mat3(Mat3::Zero());
  columns.rightCols<3>() = -hat(R * member.arm) * section.axes;
  return columns;
}

/// Moves the members of a rigid section to its pose; those of a soft section are free.
void place_members(const Section& section, const Pose& pose, Eigen::VectorXd& u) {
  if (section.soft) return;
  for (const Member& member : section.members) {
    Vec3 value = pose.rotation * member.arm - member.arm;
    if (member.follows_center) value += pose.position - section.center;
    u.segment<3>(member.first_dof) = value;
  }
}

}  // namespace

System::System(const Model& model, Supports supports, const Processes& processes)
    : model_(model), supports_(std::move(supports)), processes_(processes) {
  for (int c = 0; c < model_.cell_count(); ++c) cell_dofs_.push_back(model_.dofs(c));
  build_numbering();
  build_pattern();
}

void System::build_numbering() {
  index_.assign(static_cast<size_t>(model_.dof_count()), 0);
  member_.assign(index_.size(), {-1, -1});
  tied_.assign(index_.size(), 0);
  for (const auto& [dof, value] : supports_.prescribed) index_[static_cast<size_t>(dof)] = -1;
  for (const Tie& tie : supports_.ties) {
    tied_[static_cast<size_t>(tie.slave)] = 1;
    index_[static_cast<size_t>(tie.slave)] = -1;
  }
  symmetric_ = conservative_ = model_.symmetric();
  for (size_t s = 0; s < supports_.sections.size(); ++s) {
    const Section& section = supports_.sections[s];
    // Spins of a free rotation do not commute: symmetric only in equilibrium, and not under a dead
    // moment.
    if (!section.rotation_fixed()) symmetric_ = false;
    if (!section.rotation_fixed() && section.moment.squaredNorm() > 0) conservative_ = false;
    if (section.soft) continue;
    for (size_t m = 0; m < section.members.size(); ++m)
      for (int k = 0; k < 3; ++k) {
        const auto dof = static_cast<size_t>(section.members[m].first_dof + k);
        index_[dof] = -1;
        member_[dof] = {static_cast<int>(s), static_cast<int>(m)};
      }
  }
  size_ = 0;
  for (int& i : index_)
    if (i == 0) i = size_++;
  for (const Tie& tie : supports_.ties)
    index_[static_cast<size_t>(tie.slave)] = index_[static_cast<size_t>(tie.master)];
  for (const Section& section : supports_.sections) {
    std::array<int, 6> pose{};
    for (size_t k = 0; k < 6; ++k) pose[k] = section.fixed[k] ? -1 : size_++;
    pose_index_.push_back(pose);
  }
  for (const Section& section : supports_.sections) {
    std::array<int, 6> multiplier{};
    for (size_t k = 0; k < 6; ++k) multiplier[k] = section.soft ? size_++ : -1;
    multiplier_index_.push_back(multiplier);
  }
}

// Unknowns of a cell: its own free values, then the poses of the rigid sections of its nodes.
void System::reduced_columns(int cell, std::vector<int>& dofs, std::vector<int>& columns,
                             std::vector<int>& sections) const {
  dofs = cell_dofs_[static_cast<size_t>(cell)];
  columns.clear();
  sections.clear();
  for (const int dof : dofs) {
    columns.push_back(index_[static_cast<size_t>(dof)]);
    const int s = member_[static_cast<size_t>(dof)].first;
    if (s >= 0 && std::find(sections.begin(), sections.end(), s) == sections.end())
      sections.push_back(s);
  }
  for (const int s : sections)
    for (const int i : pose_index_[static_cast<size_t>(s)]) columns.push_back(i);
}

void System::build_pattern() {
  std::vector<std::vector<int>> rows(static_cast<size_t>(size_));
  const auto couple = [&](const std::vector<int>& unknowns) {
    for (const int j : unknowns)
      if (j >= 0)
        for (const int i : unknowns)
          if (i >= 0) rows[static_cast<size_t>(j)].push_back(i);
  };
  const auto tidy = [](std::vector<int>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  };
  std::vector<int> dofs, columns, sections;
  for (int c = 0; c < model_.cell_count(); ++c) {
    if (model_.owner(c) != processes_.rank()) continue;
    reduced_columns(c, dofs, columns, sections);
    couple(columns);
    for (const int j : columns)
      if (j >= 0 && rows[static_cast<size_t>(j)].size() > 4000) tidy(rows[static_cast<size_t>(j)]);
  }
  for (size_t s = 0; s < supports_.sections.size() && processes_.first(); ++s) {
    std::vector<int> own;
    for (const auto* set : {&pose_index_[s], &multiplier_index_[s]})
      for (const int i : *set)
        if (i >= 0) own.push_back(i);
    couple(own);
    if (!supports_.sections[s].soft) continue;
    for (const Member& member : supports_.sections[s].members)
      for (int k = 0; k < 3 && member.weight != 0; ++k) {
        const int dof = index_[static_cast<size_t>(member.first_dof + k)];
        for (const int i : own) {
          rows[static_cast<size_t>(i)].push_back(dof);
          rows[static_cast<size_t>(dof)].push_back(i);
        }
      }
  }
  Eigen::VectorXi counts(size_);
  for (int j = 0; j < size_; ++j) {
    tidy(rows[static_cast<size_t>(j)]);
    counts[j] = static_cast<int>(rows[static_cast<size_t>(j)].size());
  }
  pattern_.resize(size_, size_);
  pattern_.reserve(counts);
  for (int j = 0; j < size_; ++j)
    for (const int i : rows[static_cast<size_t>(j)]) pattern_.insert(i, j) = 0;
  pattern_.makeCompressed();
}

int System::multipliers() const {
  int count = 0;
  for (const Section& section : supports_.sections)
    if (section.soft) count += 6;
  return count;
}

State System::rest() const {
  State state;
  state.u = Eigen::VectorXd::Zero(model_.dof_count());
  for (const Section& section : supports_.sections) {
    state.pose.push_back({Mat3::Identity(), section.center});
    state.multiplier.emplace_back(Vec6::Zero());
  }
  return state;
}

void System::start_from(const State& state) {
  start_load_.resize(0);
  start_scale_ = 0;
  Assembly assembly;
  assemble(state, 0, false, assembly);
  start_load_ = std::move(assembly.residual);
  start_scale_ = assembly.scale;
}

void System::prescribe(State& state, double load) const {
  for (const auto& [dof, value] : supports_.prescribed) state.u[dof] = load * value;
  for (size_t s = 0; s < supports_.sections.size(); ++s) {
    const Section& section = supports_.sections[s];
    Pose& pose = state.pose[s];
    if (section.rotation_fixed()) pose.rotation = exp_rotation(load * section.rotation);
    for (size_t k = 0; k < 3; ++k) {
      if (!section.fixed[k]) continue;
      const Vec3 axis = section.axes.col(static_cast<Eigen::Index>(k));
      pose.position += axis.dot(section.center + load * section.move - pose.position) * axis;
    }
    place_members(section, pose, state.u);
  }
  for (const Tie& tie : supports_.ties)
    state.u[tie.slave] = state.u[tie.master] + load * tie.offset;
}

void System::add(State& state, const Eigen::VectorXd& unknowns) const {
  for (size_t d = 0; d < index_.size(); ++d)
    if (index_[d] >= 0) state.u[static_cast<Eigen::Index>(d)] += unknowns[index_[d]];
  for (size_t s = 0; s < supports_.sections.size(); ++s) {
    Vec6 step = Vec6::Zero();
    for (size_t k = 0; k < 6; ++k) {
      if (pose_index_[s][k] >= 0) step[static_cast<Eigen::Index>(k)] = unknowns[pose_index_[s][k]];
      if (multiplier_index_[s][k] >= 0)
        state.multiplier[s][static_cast<Eigen::Index>(k)] += unknowns[multiplier_index_[s][k]];
    }
    const Section& section = supports_.sections[s];
    state.pose[s].position += section.axes * step.head<3>();
    state.pose[s].rotation = exp_rotation(section.axes * step.tail<3>()) * state.pose[s].rotation;
    place_members(section, state.pose[s], state.u);
  }
}

Eigen::VectorXd System::difference(const State& from, const State& to) const {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(size_);
  for (size_t d = 0; d < index_.size(); ++d)
    if (index_[d] >= 0 && tied_[d] == 0)
      unknowns[index_[d]] =
          to.u[static_cast<Eigen::Index>(d)] - from.u[static_cast<Eigen::Index>(d)];
  for (size_t s = 0; s < supports_.sections.size(); ++s) {
    const Section& section = supports_.sections[s];
    Vec6 step;
    step.head<3>() = section.axes.transpose() * (to.pose[s].position - from.pose[s].position);
    step.tail<3>() = section.axes.transpose() *
                     log_rotation(to.pose[s].rotation * from.pose[s].rotation.transpose());
    const Vec6 multiplier = to.multiplier[s] - from.multiplier[s];
    for (size_t k = 0; k < 6; ++k) {
      if (pose_index_[s][k] >= 0) unknowns[pose_index_[s][k]] = step[static_cast<Eigen::Index>(k)];
      if (multiplier_index_[s][k] >= 0)
        unknowns[multiplier_index_[s][k]] = multiplier[static_cast<Eigen::Index>(k)];
    }
  }
  return unknowns;
}

double System::Assembly::relative_residual() const {
  const double length = residual.norm();
  return length == 0 ? 0 : length / std::max(scale, 1e-300);
}

void System::assemble(const State& state, double load, bool want_tangent, Assembly& out,
                      const State* target) const {
  out.admissible = false;
  out.energy = out.scale = 0;
  out.residual = Eigen::VectorXd::Zero(size_);
  out.nodal = Eigen::VectorXd::Zero(model_.dof_count());
  out.section_force.assign(supports_.sections.size(), Vec6::Zero());
  if (want_tangent) {
    if (out.tangent.rows() != size_ || out.tangent.nonZeros() != pattern_.nonZeros())
      out.tangent = pattern_;
    std::fill_n(out.tangent.valuePtr(), out.tangent.nonZeros(), 0.0);
  }

  CellTerms terms;
  bool inside = true;
  std::vector<int> dofs, columns, sections, place(static_cast<size_t>(size_), -1);
  for (int cell = 0; cell < model_.cell_count(); ++cell) {
    if (model_.owner(cell) != processes_.rank()) continue;
    inside = model_.evaluate(cell, state.u, load, want_tangent, terms);
    if (!inside) break;
    out.energy += terms.energy;
    out.scale += terms.residual.squaredNorm();
    reduced_columns(cell, dofs, columns, sections);
    const auto n = static_cast<Eigen::Index>(dofs.size());

    if (target != nullptr &&
        want_tangent) {  // the cell's contribution from prescribed values that still change
      Eigen::VectorXd jump = Eigen::VectorXd::Zero(n);
      bool any = false;
      for (Eigen::Index a = 0; a < n; ++a) {
        const int dof = dofs[static_cast<size_t>(a)];
        if (index_[static_cast<size_t>(dof)] >= 0 && tied_[static_cast<size_t>(dof)] == 0) continue;
        jump[a] = target->u[dof] - state.u[dof];
        any = any || jump[a] != 0;
      }
      if (any) terms.residual += terms.tangent * jump;
    }

    Eigen::VectorXd residual(static_cast<Eigen::Index>(columns.size()));
    residual.setZero();
    residual.head(n) = terms.residual;
    for (Eigen::Index a = 0; a < n; ++a)
      out.nodal[dofs[static_cast<size_t>(a)]] += terms.residual[a];

    Eigen::MatrixXd reduced;
    const Eigen::MatrixXd* tangent = &terms.tangent;
    if (!sections.empty()) {
      // rows of T: free values map to themselves, members to their section's six columns
      Eigen::MatrixXd T = Eigen::MatrixXd::Zero(n, 6 * static_cast<Eigen::Index>(sections.size()));
      std::vector<Mat6> geometric(sections.size(), Mat6::Zero());
      for (Eigen::Index a = 0; a < n; ++a) {
        const int dof = dofs[static_cast<size_t>(a)];
        const auto [s, m] = member_[static_cast<size_t>(dof)];
        if (s < 0) continue;
        const auto place_of =
            static_cast<size_t>(std::find(sections.begin(), sections.end(), s) - sections.begin());
        const Section& section = supports_.sections[static_cast<size_t>(s)];
        const Member& member = section.members[static_cast<size_t>(m)];
        const int component = dof - member.first_dof;
        const Mat3& R = state.pose[static_cast<size_t>(s)].rotation;
        const Eigen::RowVector<double, 6> row = member_columns(section, member, R).row(component);
        T.block<1, 6>(a, 6 * static_cast<Eigen::Index>(place_of)) = row;
        const double f = terms.residual[a];
        Vec6 force = Vec6::Zero();
        if (member.follows_center) force[component] = f;
        Vec3 unit = Vec3::Zero();
        unit[component] = f;
        const Vec3 arm = R * member.arm;
        force.tail<3>() = arm.cross(unit);
        out.section_force[static_cast<size_t>(s)] += force;
        // d(y x f) = y (a . f) - a (y . f) for the spin a
        const Mat3 turn = arm * unit.transpose() - arm.dot(unit) * Mat3::Identity();
        geometric[place_of].bottomRightCorner<3, 3>() +=
            section.axes.transpose() * turn * section.axes;
      }
      residual.tail(T.cols()) = T.transpose() * terms.residual;
      if (want_tangent) {
        reduced.resize(n + T.cols(), n + T.cols());
        reduced.topLeftCorner(n, n) = terms.tangent;
        reduced.topRightCorner(n, T.cols()).noalias() = terms.tangent * T;
        reduced.bottomLeftCorner(T.cols(), n).noalias() = T.transpose() * terms.tangent;
        reduced.bottomRightCorner(T.cols(), T.cols()).noalias() =
            T.transpose() * reduced.topRightCorner(n, T.cols());
        for (size_t s = 0; s < sections.size(); ++s)
          reduced.block<6, 6>(n + 6 * static_cast<Eigen::Index>(s),
                              n + 6 * static_cast<Eigen::Index>(s)) += geometric[s];
        tangent = &reduced;
      }
    }
    for (size_t a = 0; a < columns.size(); ++a)
      if (columns[a] >= 0) out.residual[columns[a]] += residual[static_cast<Eigen::Index>(a)];
    if (!want_tangent) continue;
    double* values = out.tangent.valuePtr();
    for (size_t b = 0; b < columns.size(); ++b) {
      if (columns[b] < 0) continue;
      const auto begin = out.tangent.outerIndexPtr()[columns[b]],
                 end = out.tangent.outerIndexPtr()[columns[b] + 1];
      for (auto p = begin; p < end; ++p)
        place[static_cast<size_t>(out.tangent.innerIndexPtr()[p])] = p;
      for (size_t a = 0; a < columns.size(); ++a)
        if (columns[a] >= 0)
          values[place[static_cast<size_t>(columns[a])]] +=
              (*tangent)(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
  }
  if (processes_.any(!inside)) return;
  processes_.sum(&out.energy, 1);
  processes_.sum(&out.scale, 1);
  processes_.sum(out.residual.data(), static_cast<size_t>(out.residual.size()));
  processes_.sum(out.nodal.data(), static_cast<size_t>(out.nodal.size()));
  for (Vec6& force : out.section_force) processes_.sum(force.data(), 6);
  out.scale = std::max(std::sqrt(out.scale), start_scale_);
  if (supports_.dead_load.size() > 0) {
    for (size_t d = 0; d < index_.size(); ++d) {
      const double f = load * supports_.dead_load[static_cast<Eigen::Index>(d)];
      out.nodal[static_cast<Eigen::Index>(d)] -= f;
      if (index_[d] >= 0) out.residual[index_[d]] -= f;
    }
    out.scale += std::abs(load) * supports_.dead_load.norm();
  }
  add_sections(state, load, want_tangent && processes_.first(), out);
  if (start_load_.size() > 0) out.residual -= (1 - load) * start_load_;
  out.admissible = true;
}

// External force and moment on free pose components; the constraint equations of soft sections.
void System::add_sections(const State& state, double load, bool want_tangent, Assembly& out) const {
  for (size_t s = 0; s < supports_.sections.size(); ++s) {
    const Section& section = supports_.sections[s];
    const Pose& pose = state.pose[s];
    const Mat3& A = section.axes;
    Vec3 moment = load * section.moment;
    if (section.moment_in_body) moment = pose.rotation * moment;
    out.scale += load * section.force.norm() + moment.norm();

    // On the pose, in the section's axes, by a soft section's multipliers.
    Vec6 internal = Vec6::Zero();
    Mat6 pose_pose = Mat6::Zero();
    if (section.soft) {
      double spread = 0;
      for (const Member& member : section.members)
        spread += member.weight * member.arm.squaredNorm();
      const Vec3 lc = state.multiplier[s].head<3>(), lr = state.multiplier[s].tail<3>() / spread;
      Vec6 gap = Vec6::Zero();
      Vec3 torque = Vec3::Zero();
      Mat3 spin_spin = Mat3::Zero(), multiplier_spin = Mat3::Zero();
      for (const Member& member : section.members) {
        const double w = member.weight;
        if (w == 0) continue;
        const Vec3 y = pose.rotation * member.arm;
        // from the current centre to the node, or the current director
        Vec3 d = member.arm + state.u.segment<3>(member.first_dof);
        if (member.follows_center) d += section.center - pose.position;
        if (member.follows_center) gap.head<3>() += w * d;
        gap.tail<3>() += w / spread * y.cross(d);
        Vec3 f = w * lr.cross(y);
        if (member.follows_center) f += w * lc;
        // derivative of lr . (y x d) for a spin of y
        torque += w * (d * lr.dot(y) - lr * y.dot(d));
        for (int k = 0; k < 3; ++k) {
          const int i = index_[static_cast<size_t>(member.first_dof + k)];
          out.nodal[member.first_dof + k] += f[k];
          if (i >= 0) out.residual[i] += f[k];
        }
        if (!want_tangent) continue;
        const Mat3 spin_of_y = -hat(y);                  // dy = spin_of_y a
        const Mat3 node_spin = w * hat(lr) * spin_of_y;  // d f / d a
        const Mat3 node_mult = -w / spread * hat(y);     // d f / d multiplier of the rotation
        // torque row: w [d (lr . y) - lr (y . d)]
        const Mat3 spin_node = w * (lr.dot(y) * Mat3::Identity() - lr * y.transpose());
        spin_spin += w * (d * lr.transpose() - lr * d.transpose()) * spin_of_y;
        multiplier_spin += w / spread * (-hat(d)) * spin_of_y;  // d gap_r / d a
        for (int k = 0; k < 3; ++k) {
          const int i = index_[static_cast<size_t>(member.first_dof + k)];
          if (i < 0) continue;
          for (size_t b = 0; b < 3; ++b) {
            const auto column = static_cast<Eigen::Index>(b);
            const int center = multiplier_index_[s][b], turn = multiplier_index_[s][3 + b],
                      spin = pose_index_[s][3 + b];
            if (static_cast<int>(b) == k && member.follows_center) {
              out.tangent.coeffRef(i, center) += w;
              out.tangent.coeffRef(center, i) += w;
            }
            out.tangent.coeffRef(i, turn) += node_mult(k, column);
            out.tangent.coeffRef(turn, i) += node_mult(k, column);
            if (spin < 0) continue;
            out.tangent.coeffRef(i, spin) += (node_spin * A)(k, column);
            out.tangent.coeffRef(spin, i) += (A.transpose() * spin_node)(column, k);
          }
        }
      }
      internal.head<3>() = -A.transpose() * lc;
      internal.tail<3>() = A.transpose() * torque;
      // the force of the section on the model is the multipliers' force on its nodes
      out.section_force[s].head<3>() = -lc;
      out.section_force[s].tail<3>() = torque;
      for (size_t a = 0; a < 6; ++a)
        out.residual[multiplier_index_[s][a]] += gap[static_cast<Eigen::Index>(a)];
      if (want_tangent) {
        pose_pose.bottomRightCorner<3, 3>() += A.transpose() * spin_spin * A;
        for (size_t a = 0; a < 3; ++a)
          for (size_t b = 0; b < 3; ++b) {
            const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
            if (const int p = pose_index_[s][b]; p >= 0) {  // d gap_c / d c = -1
              out.tangent.coeffRef(multiplier_index_[s][a], p) += -A(i, j);
              out.tangent.coeffRef(p, multiplier_index_[s][a]) += -A(i, j);
            }
            if (const int p = pose_index_[s][3 + b]; p >= 0) {
              const double value = (multiplier_spin * A)(i, j);
              out.tangent.coeffRef(multiplier_index_[s][3 + a], p) += value;
              out.tangent.coeffRef(p, multiplier_index_[s][3 + a]) += value;
            }
          }
      }
    }
    Vec6 applied;
    applied << A.transpose() * (load * section.force), A.transpose() * moment;
    if (section.moment_in_body && want_tangent)
      pose_pose.bottomRightCorner<3, 3>() += A.transpose() * hat(moment) * A;
    for (size_t a = 0; a < 6; ++a) {
      const int i = pose_index_[s][a];
      if (i < 0) continue;
      out.residual[i] +=
          internal[static_cast<Eigen::Index>(a)] - applied[static_cast<Eigen::Index>(a)];
      if (!want_tangent) continue;
      for (size_t b = 0; b < 6; ++b)
        if (pose_index_[s][b] >= 0)
          out.tangent.coeffRef(i, pose_index_[s][b]) +=
              pose_pose(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
  }
}

}  // namespace vasorod::fem
