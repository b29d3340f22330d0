#include "predict/name_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/sentence.h"

namespace vasorod {
namespace {

// Names of what is not finite, in the result's order.
class Scan {
 public:
  void see(const std::string& name, double value) {
    if (!std::isfinite(value)) names_.push_back(name);
  }
  // A whole array counts once.
  template <class Derived>
  void see(const std::string& name, const Eigen::DenseBase<Derived>& values) {
    if (!values.derived().array().isFinite().all()) names_.push_back(name);
  }
  template <class Value>
  void see_each(const std::string& name, const std::vector<Value>& values) {
    const std::size_t before = names_.size();
    for (const Value& value : values) {
      if (names_.size() > before) return;
      see(name, value);
    }
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

void scan_shapes(const VesselResult& vessel, Scan& scan) {
  const std::string of = " of " + vessel.name;
  scan.see("rest surface" + of, vessel.rest);
  scan.see("surface" + of, vessel.current);
  scan.see("axial stretch" + of, vessel.axial_stretch);
  scan.see("twist shear" + of, vessel.twist_shear);
  scan.see("contact pressure" + of, vessel.contact_pressure);
  if (!vessel.centerline) return;
  const CenterlineResult& line = *vessel.centerline;
  scan.see("rest centerline" + of, line.rest);
  scan.see("centerline" + of, line.current);
  scan.see_each("arc length" + of, line.abscissa);
  scan.see_each("radius" + of, line.radius);
  scan.see_each("directors" + of, line.directors);
  for (const auto* strains : {&line.u, &line.v, &line.u0, &line.v0})
    scan.see_each("strains" + of, *strains);
  scan.see_each("section forces" + of, line.force);
  scan.see_each("section moments" + of, line.moment);
}

void scan_forces(const Result& result, Scan& scan) {
  for (const EndReaction& end : result.ends) {
    const std::string of = " at " + end.end + " of " + end.vessel;
    scan.see("force" + of, end.force);
    scan.see("moment" + of, end.moment);
    scan.see("centre" + of, end.center);
  }
  for (const Balance& balance : result.balance) {
    Vec3 all = balance.support + balance.load + balance.join + balance.contact;
    if (balance.binding) all += *balance.binding;
    if (balance.rod_unbalanced) all += *balance.rod_unbalanced;
    scan.see("balance of " + balance.vessel, all);
    scan.see("balance's residual of " + balance.vessel, balance.residual);
  }
  for (const ContactReport& contact : result.contact) {
    const std::string of = " of " + contact.a + " and " + contact.b;
    scan.see("contact force" + of, contact.force);
    scan.see("contact area" + of, contact.area);
    scan.see("largest contact pressure" + of, contact.largest_pressure);
    if (!(contact.smallest_gap > 0)) scan.see("smallest gap" + of, contact.smallest_gap);
  }
}

void scan_metrics(const VesselMetrics& metrics, Scan& scan) {
  const std::string of = " of " + metrics.vessel;
  scan.see("flattening" + of, metrics.flattening);
  scan.see("largest twist shear" + of, metrics.largest_twist_shear);
  scan.see("smallest stretch" + of, metrics.stretch[0]);
  scan.see("largest stretch" + of, metrics.stretch[1]);
  scan.see("largest curvature" + of, metrics.largest_curvature);
  scan.see("smallest lumen ratio" + of, metrics.smallest_lumen_ratio);
  if (metrics.largest_pressure) scan.see("largest pressure" + of, *metrics.largest_pressure);
  if (metrics.contact_area) scan.see("contact area" + of, *metrics.contact_area);
  for (const auto& [name, place] : metrics.where)
    scan.see(joined_text("place of ", name, of), place);
}

void scan_cut(const std::string& of, const CutReport& cut, Scan& scan) {
  scan.see("pick of the cut" + of, cut.pick);
  scan.see("fraction of the cut" + of, cut.fraction);
  scan.see("perimeter of the cut" + of, cut.perimeter);
  scan.see("point of the cut" + of, cut.point);
  scan.see("normal of the cut" + of, cut.normal);
}

// `sewn`: it has gaps and a mouth.
void scan_seam(const JoinedVessels& joined, bool sewn, Scan& scan) {
  scan.see("seam's rotation", joined.seam->rotation_deg);
  scan.see("turn of the mouth's axis", joined.seam->axis_turn_deg);
  if (!sewn) return;
  scan.see("seam's largest gap", joined.seam->largest_gap);
  scan.see("seam's mean gap", joined.seam->rms_gap);
  if (joined.mouth == nullptr) return;
  scan.see("mouth's area", joined.mouth->area);
  scan.see("mouth's lumen ratio", joined.mouth->area_ratio);
  scan.see("mouth's span", joined.mouth->span);
  scan.see("mouth's width", joined.mouth->width);
  scan.see("mouth's perimeter ratio", joined.mouth->perimeter_ratio);
}

void scan_operation(const Result& result, Scan& scan) {
  const bool sewn = result.fidelity != "rod";
  if (result.glenn) {
    const IncisionReport& incision = result.glenn->incision;
    scan_cut(" of " + result.glenn->svc, result.glenn->cut, scan);
    scan.see("incision's pick", incision.pick);
    scan.see("incision's angle", incision.around_deg);
    scan.see("incision's length", incision.length);
    scan.see("incision's width", incision.width);
    scan.see("incision's perimeter", incision.perimeter_ratio);
    scan.see("incision's removed area", incision.removed_area);
    for (const Vec3& end : incision.ends) scan.see("incision's end", end);
    if (sewn) scan.see("incision's opened area", incision.opened_area);
  }
  if (result.end_to_end)
    for (const RimReport& rim : result.end_to_end->rims)
      scan_cut(" of " + rim.vessel, rim.cut, scan);
  if (const auto joined = joined_vessels(result)) scan_seam(*joined, sewn, scan);
}

std::vector<std::string> not_finite(const Result& result) {
  Scan scan;
  scan.see("relative residual", result.certificate.relative_residual);
  const Energies& e = result.energy;
  const std::pair<const char*, double> energies[] = {{"rod", e.rod},
                                                     {"binding", e.binding},
                                                     {"bending", e.bending},
                                                     {"stretching", e.stretching},
                                                     {"joining", e.joining},
                                                     {"contact", e.contact},
                                                     {"wall's strain", e.strain}};
  for (const auto& [name, value] : energies) scan.see(std::string(name) + " energy", value);
  const Validity& v = result.validity;
  scan.see("Brazier ratio", v.brazier_ratio);
  scan.see("wrinkling ratio", v.wrinkling_ratio);
  scan.see("twist ratio", v.twist_ratio);
  scan.see("largest strain", v.largest_strain);
  scan_forces(result, scan);
  for (const VesselMetrics& metrics : result.metrics) scan_metrics(metrics, scan);
  scan_operation(result, scan);
  for (const VesselResult& vessel : result.vessels) scan_shapes(vessel, scan);
  return scan.names();
}

// Whether a note says why there is no equilibrium. All such notes use one of these words; others,
// as of a chosen fidelity, do not.
bool explains(const std::string& note) {
  return note.find("equilibrium") != std::string::npos ||
         note.find("not finite") != std::string::npos;
}

}  // namespace

void name_faults(Result& result) {
  if (const std::vector<std::string> names = not_finite(result); !names.empty()) {
    constexpr std::size_t most = 5;
    std::string note = "found numbers that are not finite: ";
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
      note += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > most) note += " and " + std::to_string(names.size() - most) + " more";
    result.certificate.notes.push_back(note + "; this is no result");
    result.status = worse(result.status, Status::iteration_limit);
    result.validity.in_range = false;
    // What was found of a state that is none says nothing.
    result.certificate.relative_residual = std::numeric_limits<double>::quiet_NaN();
    result.certificate.smallest_curvature_positive.reset();
  }
  const auto& notes = result.certificate.notes;
  if (result.status == Status::iteration_limit &&
      std::none_of(notes.begin(), notes.end(), explains))
    result.certificate.notes.push_back("no equilibrium was found; the relative residual is " +
                                       number_text(result.certificate.relative_residual, 3));
}

}  // namespace vasorod
