// Why the wall of an operation's vein has to fold, and what would let it lie round.
#pragma once

#include <optional>
#include <string>

#include "predict/prediction.h"

namespace vasorod {

/// The kept vein between its held end and the mouth.
struct SharpVein {
  std::string name, length_unit;
  double length = 0, width = 0;  ///< at rest, length; width: of the round mouth
  double strain = 0;             ///< of its wall by its rod, as Validity::largest_strain
  bool turned = false;           ///< by the scene's own `rotation_deg`
};

/// The length at which the same offset of the mouth would strain the wall by 0.2 only, the end of
/// the model's range: the curvature of a rod between two held ends goes as one over the square of
/// its length.
double length_in_range(const SharpVein& vein);

/// Whether it folds on its way to the incision: its rod strains the wall by more than 0.4, twice
/// the end of the model's range.
bool has_to_fold(const SharpVein& vein);

/// The sentence that says so; empty where the vein is strained by no more than 0.2.
std::optional<std::string> sharp_vein_sentence(const SharpVein& vein);

/// The vein of a prediction with a Glenn operation; empty: there is none.
std::optional<SharpVein> sharp_vein(const Prediction& prediction);

}  // namespace vasorod
