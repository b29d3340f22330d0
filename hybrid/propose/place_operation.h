// A first place for a Glenn shunt on two vessels: a cut and an incision that fit.
#pragma once

#include <functional>
#include <optional>

#include <vasorod/scene.h>

#include "surgery/glenn.h"

namespace vasorod {

/// A place that was tried and fits.
struct PlacedOperation {
  GlennSpec spec;      ///< picks by fraction, rounded as a scene states them
  GlennReport report;  ///< of the operation there
};

/// The vein's end on the head's side: the higher one where `space` says what is up, else the one
/// farther from the artery's ends.
int head_end(const Vessel& vein, const Vessel& artery, const std::string& space);

/// Looks for an incision on whose outward normal the kept vein comes without a large turn, near the
/// vein, and for the cut that leaves the vein as long as the way to it. `scene` holds both vessels
/// and their ends. Each place is tried by building the operation; the first is taken in which the
/// vein's rod finds its equilibrium and its mouth turns by at most 90 degrees. Empty: none of the
/// `most_tries` best.
std::optional<PlacedOperation> place_operation(const Scene& scene, const PreparedVessel& vein,
                                               const PreparedVessel& artery, int kept_end,
                                               int most_tries = 20);

}  // namespace vasorod
