// The options of a Glenn shunt: every combination of the values that a scene lists.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vasorod/scene.h>

#include "predict/fitted_vessels.h"

namespace vasorod {

/// One option: the operation, and the listed values it has.
struct Option {
  GlennSpec operation;
  /// Key of the scene and value, as the scene has them; keys in the order of option_keys().
  std::vector<std::pair<std::string, std::string>> values;

  /// "cut_along 0.5, rotation_deg auto", or "as in the scene".
  std::string text() const;
};

/// The keys that are listed, in the order of the tables' columns.
std::vector<std::string> option_keys(const ExploreSpec& spec);

/// A listed number between whose values a search may go.
struct RefinedKey {
  std::string name;          ///< key of the scene
  double low = 0, high = 0,  ///< the smallest and the largest listed value; `auto` counts as 0
      gap = 0;               ///< the smallest difference of two of them
};

/// The listed numbers with two values or more.
std::vector<RefinedKey> refined_keys(const ExploreSpec& spec);

/// The option's number of a key, `auto` as 0; empty: it has none.
std::optional<double> number_of(const Option& option, const std::string& key);

/// The option with another number of a key that it has. `incision`: as in options_of().
Option with_number(Option option, const std::string& key, double value, const PickSpec& incision);

/// The scene's cut as a fraction: a picked point becomes its place on the first way from the kept
/// end (to the farthest end first) that it lies on. Throws InputError where it lies on none.
PickSpec cut_by_fraction(const Scene& scene, const FittedVessels& fitted);

/// The scene's incision as fractions, so that options may change one of them: a picked point
/// becomes its place on the first way through the artery (from `start`, to the farthest end first)
/// that it lies on. Throws InputError where it lies on none.
PickSpec incision_by_fraction(const Scene& scene, const FittedVessels& fitted);

/// Every combination of the listed values, the last key varying fastest; of alike ones the first.
/// `incision`: that of the scene by fraction. An ellipse with a length has no incision_length.
/// Throws InputError where nothing is listed, or more than 10,000 options.
std::vector<Option> options_of(const Scene& scene, const PickSpec& incision);

/// The scene with the option's operation, named SCENE-NAME.
Scene with_option(const Scene& scene, const Option& option, const std::string& name);

}  // namespace vasorod
