// Two models as one: the degrees of freedom and the cells of the second follow those of the first.
#pragma once

#include "reference_fem/model.h"

namespace vasorod::fem {

/// Both models have the same components per node. They must outlive the pair.
class ModelPair final : public Model {
 public:
  ModelPair(const Model& first, const Model& second) : first_(first), second_(second) {}

  int node_count() const override { return first_.node_count() + second_.node_count(); }
  int components() const override { return first_.components(); }
  int cell_count() const override { return first_.cell_count() + second_.cell_count(); }
  int owner(int cell) const override {
    return in_first(cell) ? first_.owner(cell) : second_.owner(cell - first_.cell_count());
  }
  bool symmetric() const override { return first_.symmetric() && second_.symmetric(); }
  std::vector<int> dofs(int cell) const override {
    if (in_first(cell)) return first_.dofs(cell);
    std::vector<int> dofs = second_.dofs(cell - first_.cell_count());
    for (int& dof : dofs) dof += first_.dof_count();
    return dofs;
  }
  bool evaluate(int cell, const DofValues& u, double load, bool want_tangent,
                CellTerms& terms) const override {
    return in_first(cell)
               ? first_.evaluate(cell, u.head(first_.dof_count()), load, want_tangent, terms)
               : second_.evaluate(cell - first_.cell_count(), u.tail(second_.dof_count()), load,
                                  want_tangent, terms);
  }

 private:
  bool in_first(int cell) const { return cell < first_.cell_count(); }

  const Model& first_;
  const Model& second_;
};

}  // namespace vasorod::fem
