// Differences of each fidelity from finite elements, measured on single tubes (docs/comparison.md).
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace vasorod {

/// The measure of how hard a scene is: what the vessel's rod does.
///   stretch  largest |v3 - v3^0|
///   twist    largest ratio to the wrinkling limit (Validity::twist_ratio)
///   bend     largest ratio to the local wrinkling curvature 0.605 t / R^2
///            (Validity::wrinkling_ratio)
enum class LoadKind { stretch, twist, bend };

/// One measurement. For demands up to `demand`, on meshes whose mean edge over R is at most `edge`,
/// material points were within `error` (RMS over R) of the reference in all measured cases. `error`
/// includes the reference's own error and a margin of 1.5.
struct AccuracyRow {
  std::string_view fidelity;
  LoadKind kind;
  double edge, demand, error;
};

/// Sorted by fidelity from cheap to expensive, kind, edge and demand.
std::span<const AccuracyRow> accuracy_table();

/// Range of the measured tubes: lowest and highest t/R and L/R.
struct AccuracyScope {
  std::array<double, 2> thickness, length;
};
AccuracyScope accuracy_scope();

}  // namespace vasorod
