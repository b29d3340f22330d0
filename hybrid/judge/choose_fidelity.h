// `accuracy: x` in a scene: the cheapest fidelity that the measured table promises to be that near
// to finite elements.
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
  double stretch = 0, twist = 0, bend = 0;  ///< as LoadKind says
  double edge = 0;                          ///< mean edge of the surface over R
};

/// The error to expect at most, RMS over R: for each kind of load the table's, interpolated
/// linearly in the demand from zero at rest (errors grow faster than linearly, so that is on the
/// safe side), summed. Empty: the table does not reach that far.
std::optional<double> promised_error(std::span<const AccuracyRow> table, std::string_view fidelity,
                                     const Demand& demand);

/// What a wanted accuracy is answered with.
struct FidelityChoice {
  double wanted = 0;  ///< RMS distance over R
  std::string fidelity;
  std::optional<double> promised;  ///< empty: the table says nothing of such a scene
  std::string reason;
  /// All of it, as the result's notes have it.
  std::string sentence() const;
};

/// A deformable vessel with its rod solved.
struct RodOfVessel {
  const PreparedVessel* vessel = nullptr;
  const RodPoses* poses = nullptr;
  std::vector<int> rigid_nodes;
};

/// Picks among the table's fidelities. Where the table says nothing of the scene (several vessels,
/// an operation, forks, obstacles, a curved vessel, loads or walls outside of what was measured),
/// the dearest is taken (`dearest`), promises nothing and says why. Throws InputError where it does
/// reach, and nothing is as accurate as asked for.
FidelityChoice choose_fidelity(const Scene& scene, const std::vector<RodOfVessel>& rods,
                               const std::string& dearest,
                               std::span<const AccuracyRow> table = accuracy_table());

}  // namespace vasorod
