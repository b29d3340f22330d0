// What every operation leaves to the solvers: two vessels whose rims are sewn to each other.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/result.h>

#include "rod/newton.h"

namespace vasorod {

/// One of the two vessels that an operation joins.
struct OperatedVessel {
  std::string name;
  /// Equilibrium of its rod with the rim in the place of the join; empty: the join does not move
  /// the rod.
  std::optional<RodSolution> rod;
  int rim_node = -1;  ///< rod node of the rim that the join places; -1: the rim is in its side
  std::optional<TriangleSurface> stump;  ///< closed surface of the part cut off
};

/// The outcome of an operation.
struct Operation {
  std::array<OperatedVessel, 2> vessels;
  /// {vertex of the first vessel, vertex of the second}, in order around the seam.
  std::vector<std::array<int, 2>> pairs;
  std::vector<Stage> stages;  ///< pictures of the steps, with the two vessels
  /// The kind of operation, without seam gaps, opened area and mouth, which belong to a solution:
  /// one of the two is set.
  std::optional<GlennReport> glenn;
  std::optional<EndToEndReport> end_to_end;
};

/// Options of an operation.
struct OperationOptions {
  RodOptions rod;  ///< options of the rod solver
  /// Called with one line of text at each step.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

}  // namespace vasorod
