// Compares a cell's residual and tangent with central differences of its energy and residual.
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "reference_fem/model.h"

namespace vasorod::fem {

/// A state without symmetry; `size` is the magnitude per degree of freedom.
inline Eigen::VectorXd uneven_state(const Model& model, double size) {
  Eigen::VectorXd u(model.dof_count());
  for (int i = 0; i < u.size(); ++i) u[i] = size * std::sin(3.0 * i);
  return u;
}

/// `has_energy`: false if a follower load acts in addition to the strain energy.
inline void expect_derivatives(const Model& model, int cell, const Eigen::VectorXd& u, double load,
                               bool has_energy) {
  CellTerms at, plus, minus;
  const std::vector<int> dofs = model.dofs(cell);
  ASSERT_TRUE(model.evaluate(cell, u, load, true, at));
  double worst_tangent = 0, worst_residual = 0;
  for (std::size_t b = 0; b < dofs.size(); ++b) {
    const double h = 1e-6;
    Eigen::VectorXd v = u;
    v[dofs[b]] += h;
    ASSERT_TRUE(model.evaluate(cell, v, load, false, plus));
    v[dofs[b]] -= 2 * h;
    ASSERT_TRUE(model.evaluate(cell, v, load, false, minus));
    const auto column = static_cast<Eigen::Index>(b);
    worst_tangent =
        std::max(worst_tangent,
                 ((plus.residual - minus.residual) / (2 * h) - at.tangent.col(column)).norm());
    worst_residual = std::max(
        worst_residual, std::abs((plus.energy - minus.energy) / (2 * h) - at.residual[column]));
  }
  EXPECT_LT(worst_tangent, 1e-7 * at.tangent.norm());
  if (has_energy) {
    EXPECT_LT(worst_residual, 1e-7 * at.residual.norm());
  }
}

}  // namespace vasorod::fem
