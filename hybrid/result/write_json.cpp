#include <vasorod/result.h>

#include "data/part_names.h"
#include "result/json_text.h"
#include "result/unknown_validity.h"

namespace vasorod {

namespace {

using Json = nlohmann::ordered_json;

Json row(const Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Value>
Json object(const std::map<std::string, Value>& entries) {
  Json value = Json::object();
  for (const auto& [key, entry] : entries) value[key] = entry;
  return value;
}

template <class Entry, class Function>
Json array(const std::vector<Entry>& entries, Function&& to_value) {
  Json value = Json::array();
  for (const Entry& entry : entries) value.push_back(to_value(entry));
  return value;
}

Json certificate(const Certificate& c) {
  return {{"relative_residual", c.relative_residual},
          {"smallest_curvature_positive", or_null(c.smallest_curvature_positive)},
          {"notes", Json(c.notes)}};
}

Json validity(const Result& r) {
  const Validity& v = r.validity;
  std::vector<std::string> warnings = v.warnings;
  if (!is_solution(r.status)) warnings.insert(warnings.begin(), why_unknown(r.status));
  return {{"in_range", or_null(known_range(r))},  {"brazier_ratio", v.brazier_ratio},
          {"wrinkling_ratio", v.wrinkling_ratio}, {"twist_ratio", v.twist_ratio},
          {"largest_strain", v.largest_strain},   {"warnings", Json(warnings)}};
}

Json energies(const Energies& e) {
  Json value = {{"rod", e.rod},         {"binding", e.binding},
                {"bending", e.bending}, {"stretching", e.stretching},
                {"joining", e.joining}, {"contact", e.contact}};
  if (e.strain != 0) value["strain"] = e.strain;
  value["total"] = e.total();
  return value;
}

Json end_reaction(const EndReaction& e) {
  return {{"vessel", e.vessel},
          {"end", e.end},
          {"force", row(e.force)},
          {"moment", row(e.moment)},
          {"center", row(e.center)}};
}

Json balance(const Balance& b) {
  Json value = {{"vessel", b.vessel},  {"support", row(b.support)}, {"load", row(b.load)},
                {"join", row(b.join)}, {"contact", row(b.contact)}, {"residual", b.residual}};
  if (b.pressure) value["pressure"] = row(*b.pressure);
  if (b.binding) value["binding"] = row(*b.binding);
  if (b.rod_unbalanced) value["rod_unbalanced"] = row(*b.rod_unbalanced);
  return value;
}

Json contact(const ContactReport& c) {
  return {{"a", c.a},
          {"b", c.b},
          {"force", row(c.force)},
          {"area", c.area},
          {"largest_pressure", c.largest_pressure},
          {"smallest_gap", c.smallest_gap}};
}

Json self_intersection(const SelfIntersection& s) {
  return {{"a", s.a}, {"b", s.b}, {"pairs", s.pairs}, {"depth", s.depth}, {"where", row(s.where)}};
}

Json metrics(const VesselMetrics& m) {
  Json where = Json::object();
  for (const auto& [key, point] : m.where) where[key] = row(point);
  Json value = {{"vessel", m.vessel},
                {"flattening", m.flattening},
                {"largest_twist_shear", m.largest_twist_shear},
                {"stretch", {m.stretch[0], m.stretch[1]}},
                {"largest_curvature", m.largest_curvature},
                {"smallest_lumen_ratio", m.smallest_lumen_ratio},
                {"where", where}};
  if (m.largest_pressure) value["largest_pressure"] = *m.largest_pressure;
  if (m.contact_area) value["contact_area"] = *m.contact_area;
  return value;
}

Json criterion(const Criterion& c) {
  return {{"name", c.name},
          {"vessel", c.vessel},
          {"value", c.value},
          {"unit", c.unit},
          {"threshold", or_null(c.threshold)},
          {"strong_threshold", or_null(c.strong_threshold)},
          {"verdict", to_string(c.verdict)},
          {"source", c.source}};
}

Json fitted_length(const FittedLength& l) {
  return {{"length", l.length},
          {"smallest_radius", l.smallest_radius},
          {"mean_radius", l.mean_radius},
          {"largest_radius", l.largest_radius}};
}

Json fit(const FitReport& f) {
  Json value = fitted_length(f.whole);
  value["branches"] = array(f.branches, fitted_length);
  value["ends"] = array(f.ends, [](const FittedEnd& end) {
    return Json{{"end", end.end},
                {"name", end.name.empty() ? Json(nullptr) : Json(end.name)},
                {"center", row(end.center)},
                {"normal", row(end.normal)},
                {"radius", end.radius}};
  });
  return value;
}

Json model(const ModelReport& m) {
  return {{"rod_nodes", m.rod_nodes},       {"vertices", m.vertices},
          {"triangles", m.triangles},       {"terms", Json(m.terms)},
          {"left_out", object(m.left_out)}, {"cleaning", object(m.cleaning)}};
}

Json counts(const Counts& c) {
  return {{"factorisations", c.factorisations},
          {"solves", c.solves},
          {"gradients", c.gradients},
          {"hessians", c.hessians},
          {"outer", c.outer},
          {"factor_nonzeros", c.factor_nonzeros}};
}

Json mouth(const MouthReport& m) {
  return {{"area", m.area},
          {"lumen", m.lumen},
          {"area_ratio", m.area_ratio},
          {"span", m.span},
          {"width", m.width},
          {"perimeter", m.perimeter},
          {"perimeter_ratio", m.perimeter_ratio},
          {"center", row(m.center)}};
}

Json cut(const CutReport& c) {
  return {{"pick", row(c.pick)},
          {"fraction", c.fraction},
          {"tilt_deg", c.tilt_deg},
          {"perimeter", c.perimeter},
          {"plane", {{"point", row(c.point)}, {"normal", row(c.normal)}}}};
}

Json seam(const SeamReport& s) {
  return {{"pairs", s.pairs},
          {"rotation_deg", s.rotation_deg},
          {"axis_turn_deg", s.axis_turn_deg},
          {"largest_gap", s.largest_gap},
          {"rms_gap", s.rms_gap}};
}

Json end_to_end(const EndToEndReport& report) {
  Json rims = Json::array();
  for (const RimReport& rim : report.rims) {
    rims.push_back(cut(rim.cut));
    rims.back()["vessel"] = rim.vessel;
  }
  Json value = {{"rims", rims},
                {"narrower", report.rims[report.narrower == 0 ? 0 : 1].vessel},
                {"join", seam(report.join)}};
  if (report.mouth) value["mouth"] = mouth(*report.mouth);
  return value;
}

Json glenn(const GlennReport& g) {
  Json value = {{"svc", g.svc},
                {"rpa", g.rpa},
                {"cut", cut(g.cut)},
                {"incision",
                 {{"pick", row(g.incision.pick)},
                  {"along", g.incision.along},
                  {"around_deg", g.incision.around_deg},
                  {"shape", g.incision.shape},
                  {"length", g.incision.length},
                  {"width", g.incision.width},
                  {"perimeter", g.incision.perimeter},
                  {"perimeter_ratio", g.incision.perimeter_ratio},
                  {"removed_area", g.incision.removed_area},
                  {"ends", Json::array({row(g.incision.ends[0]), row(g.incision.ends[1])})},
                  {"opened_area", g.incision.opened_area}}},
                {"join", seam(g.join)}};
  if (g.mouth) value["mouth"] = mouth(*g.mouth);
  return value;
}

Json files_of(const VesselResult& v) {
  Json value = {{"name", v.name}, {"obstacle", v.obstacle}};
  if (v.rest.rows() > 0) value["surface"] = v.name + ".vtp";
  if (v.centerline) value["centerline"] = centerline_name(v.name) + ".vtp";
  if (v.stump) value["stump"] = stump_name(v.name) + ".vtp";
  return value;
}

}  // namespace

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::fine:
      return "fine";
    case Verdict::warning:
      return "warning";
    case Verdict::strong_warning:
      return "strong_warning";
    case Verdict::not_judged:
      return "not_judged";
    case Verdict::unknown:
      return "unknown";
  }
  return {};
}

std::string to_json(const Result& r) {
  Json value = {{"schema", 1},
                {"scene", r.scene},
                {"program", r.program},
                {"fidelity", r.fidelity},
                {"status", to_string(r.status)},
                {"units", {{"length", r.length_unit}, {"stress", r.stress_unit}}},
                {"certificate", certificate(r.certificate)},
                {"validity", validity(r)},
                {"energy", energies(r.energy)},
                {"ends", array(r.ends, end_reaction)},
                {"balance", array(r.balance, balance)},
                {"contact", array(r.contact, contact)},
                {"self_intersections", array(r.self_intersections, self_intersection)},
                {"metrics", array(r.metrics, metrics)},
                {"criteria", array(r.criteria, criterion)}};
  if (r.fit) value["fit"] = fit(*r.fit);
  if (r.glenn) value["glenn"] = glenn(*r.glenn);
  if (r.end_to_end) value["end_to_end"] = end_to_end(*r.end_to_end);
  if (r.discretisation)
    value["discretisation"] = {{"dofs", r.discretisation->dofs},
                               {"degree", r.discretisation->degree},
                               {"error_estimate", or_null(r.discretisation->error_estimate)},
                               {"observed_order", or_null(r.discretisation->observed_order)}};
  value["model"] = model(r.model);
  value["seconds"] = object(r.seconds);
  value["iterations"] = object(r.iterations);
  if (r.counts) value["counts"] = counts(*r.counts);
  value["environment"] = {{"blas", r.environment.blas},
                          {"threads", r.environment.threads},
                          {"inputs", object(r.environment.inputs)}};
  value["vessels"] = array(r.vessels, files_of);
  return json_text(value);
}

}  // namespace vasorod
