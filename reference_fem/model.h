// What the load stepper asks of a finite-element model: energy, residual and tangent, cell by cell.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vasorod::fem {

/// Contribution of one cell in the order of Model::dofs(cell). Buffers are reused from cell to
/// cell.
struct CellTerms {
  double energy = 0;
  Eigen::VectorXd residual;  ///< dPi/du: internal minus follower forces
  Eigen::MatrixXd tangent;   ///< d residual / du
};

/// Degrees of freedom are numbered node * components + component; the first three of a node are its
/// displacement.
class Model {
 public:
  virtual ~Model() = default;
  virtual int node_count() const = 0;
  virtual int components() const = 0;
  virtual int cell_count() const = 0;     ///< follower-load faces count as cells
  virtual int owner(int cell) const = 0;  ///< the process that may evaluate it
  virtual std::vector<int> dofs(int cell) const = 0;
  /// False where a deformation gradient has det F <= 0; `terms` is then meaningless. `load` scales
  /// follower loads.
  virtual bool evaluate(int cell, const Eigen::VectorXd& u, double load, bool want_tangent,
                        CellTerms& terms) const = 0;
  virtual bool symmetric() const { return true; }  ///< of the tangent
  int dof_count() const { return node_count() * components(); }
};

}  // namespace vasorod::fem
