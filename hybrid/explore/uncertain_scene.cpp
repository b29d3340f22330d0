#include "explore/uncertain_scene.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "explore/latin_hypercube.h"
#include "explore/options.h"
#include "surgery/pick_place.h"
#include "vessel/end_conditions.h"
#include "vessel/fitted_wall.h"

namespace vasorod {
namespace {

using What = Uncertain::What;

constexpr double cut_off = 4;  // standard deviations

void scale_wall(What what, double factor, VesselSpec& vessel) {
  Material& material = vessel.wall->material;
  if (what == What::thickness) {
    vessel.wall->thickness *= factor;
    if (vessel.tube && vessel.tube->end_thickness) *vessel.tube->end_thickness *= factor;
  } else if (what == What::young) {
    material.young_axial *= factor;
    material.young_transverse *= factor;
    material.shear_axial *= factor;
  } else if (material.is_isotropic()) {
    material =
        Material::isotropic(material.young_axial, factor * material.poisson_tt, material.law);
  } else {
    material.poisson_tt *= factor;
    material.poisson_lt *= factor;
  }
}

// Moves a pick that is a fraction of an axis of this length.
void move_along(PickSpec& pick, double by, double length, const std::string& where) {
  const double to = *pick.along + by / length;
  if (to < 0 || to > 1)
    throw InputError(where + ": found it moved by " + number_text(by, 3) +
                     " past an end of the axis, expected a smaller offset");
  pick.along = to;
}

void move_cut(Scene& scene, double by, const FittedVessels& fitted, const std::string& where) {
  GlennSpec& glenn = *scene.glenn;
  const Vessel& vein = fitted.named(glenn.svc).vessel;
  glenn.cut = cut_by_fraction(scene, fitted);
  move_along(
      glenn.cut, by,
      pick_route(where, glenn.cut, vein, find_end(vein, glenn.keep, where + ".keep")).length(),
      where + ".cut");
}

}  // namespace

double value_at(const Uncertain& uncertain, double share) {
  if (uncertain.sd == 0) return uncertain.low + share * (uncertain.high - uncertain.low);
  const double deviations =
      share <= 0 ? -cut_off
      : share >= 1
          ? cut_off
          : std::clamp(-std::sqrt(2.) * boost::math::erfc_inv(2 * share), -cut_off, cut_off);
  return (uncertain.scales() ? 1 : 0) + uncertain.sd * deviations;
}

std::vector<Sample> samples_of(const VarySpec& spec) {
  std::vector<Sample> samples;
  for (const std::vector<double>& point :
       latin_hypercube(spec.samples, static_cast<int>(spec.uncertain.size()), spec.seed)) {
    Sample& sample = samples.emplace_back();
    for (std::size_t d = 0; d < point.size(); ++d) {
      const Uncertain& uncertain = spec.uncertain[d];
      sample.values.push_back(value_at(uncertain, point[d]));
      sample.text += (d > 0 ? ", " : "") + to_string(uncertain.what) +
                     (uncertain.vessel.empty() ? "" : " " + uncertain.vessel) + " " +
                     number_text(sample.values.back(), 9);
    }
  }
  return samples;
}

Scene with_sampled_walls(const Scene& scene, const VarySpec& spec, const Sample& sample) {
  Scene changed = scene;
  for (std::size_t d = 0; d < spec.uncertain.size(); ++d) {
    const Uncertain& uncertain = spec.uncertain[d];
    if (!uncertain.scales()) continue;
    for (VesselSpec& vessel : changed.vessels) {
      if (uncertain.what == What::pressure) {
        if (!vessel.pressure) continue;
        vessel.pressure->scan *= sample.values[d];
        vessel.pressure->after *= sample.values[d];
      } else if (vessel.wall && (uncertain.vessel.empty() || uncertain.vessel == vessel.name)) {
        scale_wall(uncertain.what, sample.values[d], vessel);
        check_material(vessel.wall->material,
                       place_of(scene, vessel) + "with the sample " + sample.text + ": ");
      }
    }
  }
  return changed;
}

Scene with_sample(const Scene& scene, const VarySpec& spec, const Sample& sample,
                  const FittedVessels& fitted) {
  Scene changed = with_sampled_walls(scene, spec, sample);
  const std::string where = place_in(scene, scene.glenn->line) + ": glenn";
  GlennSpec& glenn = *changed.glenn;
  for (std::size_t d = 0; d < spec.uncertain.size(); ++d) {
    if (spec.uncertain[d].what == What::cut) move_cut(changed, sample.values[d], fitted, where);
    if (spec.uncertain[d].what != What::incision) continue;
    glenn.incision = incision_by_fraction(changed, fitted);
    const Vessel& artery = fitted.named(glenn.rpa).vessel;
    move_along(glenn.incision, sample.values[d],
               pick_route(where, glenn.incision, artery, 0).length(), where + ".incision");
  }
  return changed;
}

FittedVessels with_walls(const FittedVessels& fitted, const Scene& scene) {
  FittedVessels changed = fitted;
  for (PreparedVessel& vessel : changed.vessels)
    if (!vessel.obstacle()) change_wall(vessel, scene.vessel(vessel.spec.name));
  return changed;
}

}  // namespace vasorod
