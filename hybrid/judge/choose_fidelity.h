// `accuracy: x` in a scene: selects the cheapest fidelity that, by the measured table, is that
// close to finite elements.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/accuracy_table.h"
#include "rod/rod_tree.h"
#include "vessel/prepared_vessel.h"

namespace vasorod {

/// How hard a scene is for a fidelity, from its vessel's solved rod.
struct Demand {
  double stretch = 0, twist = 0, bend = 0;  ///< as in LoadKind
  double edge = 0;                          ///< mean edge of the surface over R
};

/// The largest expected error, RMS over R: the sum over the kinds of load of the table's error,
/// interpolated linearly in the demand from zero at rest. Errors grow faster than linearly, so the
/// interpolation is conservative. Empty: the table does not reach that far.
std::optional<double> promised_error(std::span<const AccuracyRow> table, std::string_view fidelity,
                                     const Demand& demand);

/// The fidelity chosen for a requested accuracy.
struct FidelityChoice {
  double wanted = 0;               ///< requested RMS distance over R
  std::string fidelity;            ///< name of the chosen fidelity
  std::optional<double> promised;  ///< expected error; empty: the table does not cover the scene
  std::string reason;              ///< why this fidelity
  /// The choice as one sentence for the result's notes.
  std::string sentence() const;
};

/// A deformable vessel with its rod solved.
struct RodOfVessel {
  const PreparedVessel* vessel = nullptr;
  const RodPoses* poses = nullptr;
  std::vector<int> rigid_nodes;
};

/// Chooses among the table's fidelities. If the table does not cover the scene (several vessels, an
/// operation, forks, obstacles, a curved vessel, loads or walls outside the measured range), the
/// most expensive fidelity (`dearest`) is chosen without a promise, and the reason is stated.
/// Throws InputError if the table covers the scene and no fidelity is as accurate as requested.
FidelityChoice choose_fidelity(const Scene& scene, const std::vector<RodOfVessel>& rods,
                               const std::string& dearest,
                               std::span<const AccuracyRow> table = accuracy_table());

}  // namespace vasorod
