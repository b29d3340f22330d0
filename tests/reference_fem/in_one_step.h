// Equilibrium at the full load in a single step, for tests with small loads or with supports that
// hold nearly everything.
#pragma once

#include <gtest/gtest.h>
#include <utility>

#include "reference_fem/stepper.h"

namespace vasorod::fem {

struct Equilibrium {
  State state;
  System::Assembly assembly;
};

inline Equilibrium in_one_step(const Model& model, Supports supports, double tolerance) {
  const System system(model, std::move(supports));
  StepperOptions options;
  options.first_step = options.largest_step = 1;
  options.tolerance = tolerance;
  options.certify = false;
  Equilibrium out;
  EXPECT_EQ(follow_path(system, out.state, out.assembly, options).status, PathStatus::complete);
  return out;
}

/// Holds the nodes at the displacements `u` (a function of the rest position).
template <class Nodes, class Displacement>
void hold_at(Supports& supports, const Points& rest, const Nodes& nodes, const Displacement& u) {
  for (const int node : nodes) {
    const Vec3 value = u(Vec3(rest.row(node)));
    for (int c = 0; c < 3; ++c) supports.prescribed.emplace_back(3 * node + c, value[c]);
  }
}

}  // namespace vasorod::fem
