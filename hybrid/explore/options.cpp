#include "explore/options.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "surgery/pick_place.h"
#include "vessel/end_conditions.h"
#include "vessel/name_ends.h"

namespace vasorod {
namespace {

constexpr std::size_t most_options = 10000;

std::string in_explore(const Scene& scene) {
  return place_in(scene, scene.explore ? scene.explore->line : 0) + ": explore: ";
}

// As many digits as tell values of a list apart.
std::string value_text(double value) {
  return number_text(value, 9);
}

std::string shape_text(const std::optional<IncisionEllipse>& ellipse) {
  if (!ellipse) return "slit";
  if (!ellipse->width) return "ellipse " + value_text(ellipse->ratio);
  return "ellipse width " + value_text(*ellipse->width) +
         (ellipse->length ? " length " + value_text(*ellipse->length) : "");
}

// Every option with every value. `set` changes an operation and returns the value's text.
template <class Value, class Set>
void multiply(std::vector<Option>& options, const std::string& key,
              const std::vector<Value>& values, const std::string& where, Set&& set) {
  if (values.empty()) return;
  if (options.size() * values.size() > most_options)
    throw InputError(where + "found " + std::to_string(options.size() * values.size()) +
                     " or more options, expected at most " + std::to_string(most_options));
  std::vector<Option> product;
  for (const Option& option : options) {
    const std::size_t first = product.size();
    for (const Value& value : values) {
      Option one = option;
      one.values.emplace_back(key, set(one.operation, value));
      const bool alike = std::any_of(
          product.begin() + static_cast<std::ptrdiff_t>(first), product.end(),
          [&](const Option& other) { return other.values.back() == one.values.back(); });
      if (!alike) product.push_back(std::move(one));
    }
  }
  options = std::move(product);
}

// Sets a listed number; returns its text, empty where the operation has no such number.
std::string set_number(GlennSpec& glenn, const std::string& key, double value,
                       const PickSpec& incision) {
  if (key == "cut_along") {
    PickSpec pick;
    pick.along = value;
    pick.to = glenn.cut.to;
    glenn.cut = pick;
  } else if (key == "cut_tilt_deg") {
    glenn.cut_tilt_deg = value;
  } else if (key == "incision_along") {
    glenn.incision = incision;
    glenn.incision.along = value;
  } else if (key == "around_deg") {
    if (!glenn.incision.along) glenn.incision = incision;
    glenn.incision.around_deg = value;
  } else if (key == "incision_length") {
    if (glenn.ellipse && glenn.ellipse->length) return "";
    glenn.incision_length = value;
  } else {
    glenn.rotation_deg = value;
  }
  return value_text(value);
}

}  // namespace

std::string Option::text() const {
  std::string text;
  for (const auto& [key, value] : values)
    if (!value.empty()) text += (text.empty() ? "" : ", ") + key + " " + value;
  return text.empty() ? "as in the scene" : text;
}

std::vector<std::string> option_keys(const ExploreSpec& spec) {
  std::vector<std::string> keys;
  const auto add = [&](const char* key, const auto& values) {
    if (!values.empty()) keys.emplace_back(key);
  };
  add("cut_along", spec.cut_along);
  add("cut_tilt_deg", spec.cut_tilt_deg);
  add("incision_along", spec.incision_along);
  add("around_deg", spec.around_deg);
  add("incision_shape", spec.incision_shape);
  add("incision_length", spec.incision_length);
  add("rotation_deg", spec.rotation_deg);
  return keys;
}

std::vector<RefinedKey> refined_keys(const ExploreSpec& spec) {
  std::vector<RefinedKey> keys;
  const auto add = [&](const char* name, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    if (values.size() < 2) return;
    double gap = values.back() - values.front();
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      gap = std::min(gap, values[i + 1] - values[i]);
    keys.push_back({name, values.front(), values.back(), gap});
  };
  add("cut_along", spec.cut_along);
  add("cut_tilt_deg", spec.cut_tilt_deg);
  add("incision_along", spec.incision_along);
  add("around_deg", spec.around_deg);
  add("incision_length", spec.incision_length);
  std::vector<double> rotations;
  for (const auto& rotation : spec.rotation_deg) rotations.push_back(rotation.value_or(0));
  add("rotation_deg", rotations);
  return keys;
}

std::optional<double> number_of(const Option& option, const std::string& key) {
  for (const auto& [name, text] : option.values)
    if (name == key && !text.empty()) return text == "auto" ? 0 : std::stod(text);
  return std::nullopt;
}

Option with_number(Option option, const std::string& key, double value, const PickSpec& incision) {
  for (auto& [name, text] : option.values)
    if (name == key) text = set_number(option.operation, key, value, incision);
  return option;
}

PickSpec cut_by_fraction(const Scene& scene, const FittedVessels& fitted) {
  const GlennSpec& glenn = *scene.glenn;
  if (glenn.cut.along) return glenn.cut;
  const PreparedVessel& vein = fitted.named(glenn.svc);
  const std::string where = place_in(scene, glenn.line) + ": glenn.cut";
  const int kept = find_end(vein.vessel, glenn.keep, where + ": keep");
  for (const int end : other_ends(vein.vessel, kept)) {
    PickSpec pick = glenn.cut;
    pick.to = selector_of(vein.vessel, end);
    const PickPlace place = place_cut(where, pick, vein, kept);
    if (!place.fraction) continue;
    PickSpec found;
    found.along = *place.fraction;
    found.to = pick.to;
    return found;
  }
  throw InputError(where +
                   ": found a point that lies on no way from the kept end to another end, "
                   "expected {along: fraction, to: end}, as it is moved along such a way");
}

PickSpec incision_by_fraction(const Scene& scene, const FittedVessels& fitted) {
  const GlennSpec& glenn = *scene.glenn;
  if (glenn.incision.along) return glenn.incision;
  const PreparedVessel& artery = fitted.named(glenn.rpa);
  const Vessel& vessel = artery.vessel;
  const std::string where = place_in(scene, glenn.line) + ": glenn.incision";
  for (const int end : other_ends(vessel, 0)) {
    PickSpec pick = glenn.incision;
    pick.from = selector_of(vessel, 0);
    pick.to = selector_of(vessel, end);
    const PickPlace place = place_incision_pick(where, pick, artery);
    if (!place.fraction) continue;
    PickSpec found;
    found.along = *place.fraction;
    found.around_deg = place.angle * (180 / M_PI);
    found.from = pick.from;
    found.to = pick.to;
    return found;
  }
  throw InputError(where +
                   ": found a point that lies on no way from the artery's start to another end, "
                   "expected {along: fraction, around_deg: angle, from: end, to: end}, as it is "
                   "moved along such a way");
}

std::vector<Option> options_of(const Scene& scene, const PickSpec& incision) {
  const ExploreSpec& spec = *scene.explore;
  const std::string where = in_explore(scene);
  if (option_keys(spec).empty())
    throw InputError(where +
                     "found no values, expected at least one of cut_along, cut_tilt_deg, "
                     "incision_along, around_deg, incision_shape, incision_length, rotation_deg");
  std::vector<Option> options(1);
  options.front().operation = *scene.glenn;
  const auto numbers = [&](const char* key, const std::vector<double>& values) {
    multiply(options, key, values, where, [&](GlennSpec& glenn, double value) {
      return set_number(glenn, key, value, incision);
    });
  };
  numbers("cut_along", spec.cut_along);
  numbers("cut_tilt_deg", spec.cut_tilt_deg);
  numbers("incision_along", spec.incision_along);
  numbers("around_deg", spec.around_deg);
  multiply(options, "incision_shape", spec.incision_shape, where,
           [](GlennSpec& glenn, const std::optional<IncisionEllipse>& value) {
             glenn.ellipse = value;
             return shape_text(value);
           });
  numbers("incision_length", spec.incision_length);
  multiply(options, "rotation_deg", spec.rotation_deg, where,
           [](GlennSpec& glenn, const std::optional<double>& value) {
             glenn.rotation_deg = value;
             return value ? value_text(*value) : std::string("auto");
           });
  return options;
}

Scene with_option(const Scene& scene, const Option& option, const std::string& name) {
  Scene changed = scene;
  changed.glenn = option.operation;
  changed.explore.reset();
  changed.name = scene.name + "-" + name;
  return changed;
}

}  // namespace vasorod
