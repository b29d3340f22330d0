#include "predict/sharp_vein.h"

#include <cmath>
#include <numbers>

#include "data/sentence.h"
#include "judge/validity.h"

namespace vasorod {
namespace {

constexpr double strain_in_range = 0.2;  // judge/validity.h

}  // namespace

double length_in_range(const SharpVein& vein) {
  return vein.length * std::sqrt(vein.strain / strain_in_range);
}

bool has_to_fold(const SharpVein& vein) {
  return vein.strain > 2 * strain_in_range;
}

std::optional<std::string> sharp_vein_sentence(const SharpVein& vein) {
  if (!(vein.strain > strain_in_range)) return std::nullopt;
  const auto text = [&](double value) { return number_text(value, 2) + " " + vein.length_unit; };
  return "vessel " + vein.name + " keeps " + text(vein.length) + " up to a mouth " +
         text(vein.width) + " wide, and its way to the incision strains its wall by " +
         number_text(vein.strain, 2) + ": it has to fold; over about " +
         text(length_in_range(vein)) + " the same way would strain it by " +
         number_text(strain_in_range, 2) +
         "; expected a cut that keeps more of it or an incision nearer to its own line" +
         (vein.turned ? ", or rotation_deg: auto, which twists it least" : "");
}

std::optional<SharpVein> sharp_vein(const Prediction& prediction) {
  if (!prediction.operation || !prediction.operation->glenn) return std::nullopt;
  const GlennReport& report = *prediction.operation->glenn;
  const PredictedVessel& vessel = prediction.vessels[vessel_named(prediction, report.svc)];
  SharpVein vein;
  vein.name = report.svc;
  vein.length_unit = prediction.scene->units.length;
  for (const RodElement& element : vessel.prepared.vessel.rod.elements)
    vein.length += element.length;
  vein.width = report.cut.perimeter / std::numbers::pi;
  Validity validity;
  add_validity(vessel.prepared, vessel.rod.poses, {.rigid_nodes = rigid_nodes(prediction, vessel)},
               validity);
  vein.strain = validity.largest_strain;
  vein.turned = prediction.scene->glenn->rotation_deg.value_or(0) != 0;
  return vein;
}

}  // namespace vasorod
