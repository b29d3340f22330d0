// The interface between load stepper and finite-element models: energy, residual and tangent of
// each cell.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vasorod::fem {

/// Contribution of one cell, in the order of Model::dofs(cell). The buffers are reused for all
/// cells.
struct CellTerms {
  double energy = 0;
  Eigen::VectorXd residual;  ///< dPi/du: internal minus follower forces
  Eigen::MatrixXd tangent;   ///< d residual / du
};

/// The values of a model's degrees of freedom; a model that is part of a larger one gets its
/// segment.
using DofValues = Eigen::Ref<const Eigen::VectorXd>;

/// A finite-element model. Degrees of freedom are numbered node * components + component; the first
/// three of a node are its displacement.
class Model {
 public:
  virtual ~Model() = default;
  virtual int node_count() const = 0;
  virtual int components() const = 0;
  virtual int cell_count() const = 0;     ///< follower-load faces count as cells
  virtual int owner(int cell) const = 0;  ///< the process that evaluates the cell
  virtual std::vector<int> dofs(int cell) const = 0;
  /// False if a deformation gradient has det F <= 0; `terms` is then undefined. `load` scales
  /// follower loads.
  virtual bool evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                        CellTerms& terms) const = 0;
  virtual bool symmetric() const { return true; }  ///< whether the tangent is symmetric
  int dof_count() const { return node_count() * components(); }
};

/// Row a: the three degrees of freedom from `first` on of the a-th of these nodes.
inline Eigen::MatrixX3d triples_of(const DofValues& u, const std::vector<int>& nodes,
                                   int components, int first = 0) {
  Eigen::MatrixX3d out(static_cast<Eigen::Index>(nodes.size()), 3);
  for (Eigen::Index a = 0; a < out.rows(); ++a)
    out.row(a) = u.segment<3>(components * nodes[static_cast<std::size_t>(a)] + first);
  return out;
}

}  // namespace vasorod::fem
