#include <algorithm>

#include "data/limits.h"
#include "scene/read_markup.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

std::string read_operated(const Field& field, const std::vector<VesselSpec>& vessels) {
  const VesselSpec& vessel = named_vessel(field, vessels);
  if (vessel.rod) field.refuse("the bare rod " + in_quotes(vessel.name), "a vessel with a surface");
  if (vessel.role == Role::obstacle)
    field.refuse("the obstacle " + in_quotes(vessel.name),
                 "a deformable vessel, as obstacles never move");
  return vessel.name;
}

// An ellipse by its ratio, or by its width and, if given, its length.
IncisionEllipse read_ellipse(const Field& field) {
  IncisionEllipse ellipse;
  if (!field.is_map()) {
    ellipse.ratio = field.number_in(ellipse_ratios[0], ellipse_ratios[1]);
    return ellipse;
  }
  field.check_keys({"length", "width"});
  ellipse.width = field.at("width", "the ellipse's axis across the artery").length();
  if (const auto length = field.find("length")) ellipse.length = length->length();
  return ellipse;
}

// A control point of a markups file, in the scene's length unit.
PickSpec read_markup(const Field& field, const std::filesystem::path& folder, const Units& units) {
  field.check_keys({"markup", "label"});
  const std::filesystem::path name =
      field.at("markup", "").text("the name of a markups file of 3D Slicer");
  const Field label = field.at("label", "the label of a point in " + in_quotes(name.string()));
  const std::string wanted = label.text("the label of a point");
  PickSpec pick;
  pick.markup = name.is_absolute() ? name : folder / name;
  const std::vector<MarkupPoint> points = read_markups(pick.markup);
  const auto called = [&](const MarkupPoint& point) { return point.label == wanted; };
  const auto found = std::find_if(points.begin(), points.end(), called);
  if (found == points.end()) {
    std::vector<std::string> labels;
    for (const MarkupPoint& point : points) labels.push_back(in_quotes(point.label));
    if (labels.size() > 10) labels.resize(10);
    label.refuse(in_quotes(wanted),
                 labels.empty() ? "a point, but the file has none that is placed"
                                : "a label of " + in_quotes(name.string()) + ": " + listed(labels));
  }
  if (std::count_if(points.begin(), points.end(), called) > 1)
    label.refuse(in_quotes(wanted) + ", which several points of the file have",
                 "a label that one point has");
  pick.point = found->point * (1e-3 / units.metres);
  pick.space = found->space;
  return pick;
}

// A pick on `vessel`: a point, a fraction of its axis, or a point of a markups file. Only an
// incision lies at an angle about the axis.
PickSpec read_pick(const Field& field, const VesselSpec& vessel, bool incision,
                   const std::filesystem::path& folder, const Units& units) {
  const std::string expected = incision
                                   ? "[x, y, z], {along: fraction, around_deg: angle} or "
                                     "{markup: file, label: text}"
                                   : "[x, y, z], {along: fraction} or {markup: file, label: text}";
  if (field.is_list()) return field.vec3();
  if (!field.is_map()) field.refuse(field.found(), expected);
  if (field.has("markup")) return read_markup(field, folder, units);
  if (!field.has("along")) field.refuse(field.found() + " without along or markup", expected);
  if (incision)
    field.check_keys({"along", "around_deg", "from", "to"});
  else
    field.check_keys({"along", "to"});
  PickSpec pick;
  pick.along = field.at("along", "").number_in(0, 1);
  if (incision)
    pick.around_deg = field.at("around_deg", "the angle about the axis").number_in(-360, 360);
  if (const auto from = field.find("from")) pick.from = read_selector(*from, vessel);
  if (const auto to = field.find("to")) pick.to = read_selector(*to, vessel);
  return pick;
}

EndSelector read_keep(const Field& field, const VesselSpec& vessel, const std::string& called) {
  return read_selector(field.at("keep",
                                "start, end, {near: [x, y, z]} or {face: ModelFaceID}, the end of "
                                "the cut " +
                                    called + " that goes on"),
                       vessel);
}

std::optional<double> read_rotation(const Field& field) {
  const auto rotation = field.find("rotation_deg");
  if (!rotation || rotation->is("auto")) return std::nullopt;
  return rotation->number_up_to(largest_length, "auto or a number");
}

RimSpec read_rim(const Field& field, const std::vector<VesselSpec>& vessels,
                 const std::filesystem::path& folder, const Units& units) {
  field.check_keys({"vessel", "cut", "cut_tilt_deg", "keep", "end"});
  RimSpec rim;
  rim.line = field.line();
  const Field name = field.at("vessel", "a vessel's name");
  rim.vessel = read_operated(name, vessels);
  const VesselSpec& vessel = named_vessel(name, vessels);
  const auto cut = field.find("cut"), end = field.find("end");
  if (cut.has_value() == end.has_value())
    field.refuse(cut ? "both cut and end" : "neither cut nor end",
                 "cut: a picked point, or end: the open end of the whole vessel that is joined");
  if (cut) {
    rim.cut = read_pick(*cut, vessel, false, folder, units);
    if (const auto tilt = field.find("cut_tilt_deg"))
      rim.cut_tilt_deg = tilt->number_in(cut_tilts_deg[0], cut_tilts_deg[1]);
    rim.keep = read_keep(field, vessel, "vessel");
    return rim;
  }
  for (const char* key : {"cut_tilt_deg", "keep"})
    if (const auto stray = field.find(key))
      stray->refuse("it beside end", "it beside cut, as a whole vessel keeps all but the rim");
  rim.end = read_selector(*end, vessel);
  return rim;
}

}  // namespace

std::optional<IncisionEllipse> read_shape(const Field& field) {
  if (!field.is_map()) {
    const std::string expected = "slit, {ellipse: RATIO} or {ellipse: {length: L, width: W}}";
    if (field.text(expected) != "slit") field.refuse(field.found(), expected);
    return std::nullopt;
  }
  field.check_keys({"ellipse"});
  return read_ellipse(field.at("ellipse", "width over length, or {length: L, width: W}"));
}

EndToEndSpec read_end_to_end(const Field& field, const std::vector<VesselSpec>& vessels,
                             const std::filesystem::path& folder, const Units& units) {
  field.check_keys({"rims", "rotation_deg"});
  EndToEndSpec spec;
  spec.line = field.line();
  const std::string expected =
      "a list of two rims, {vessel: NAME, cut: ...} or {vessel: NAME, end: ...}";
  const Field rims = field.at("rims", expected);
  const auto both = rims.list(expected);
  if (both.size() != 2) rims.refuse(rims.found(), expected);
  for (size_t k = 0; k < 2; ++k) spec.rims[k] = read_rim(both[k], vessels, folder, units);
  if (spec.rims[0].vessel == spec.rims[1].vessel)
    both[1]
        .at("vessel", "a vessel's name")
        .refuse(in_quotes(spec.rims[1].vessel) + " a second time", "another vessel");
  spec.rotation_deg = read_rotation(field);
  return spec;
}

GlennSpec read_glenn(const Field& field, const std::vector<VesselSpec>& vessels,
                     const std::filesystem::path& folder, const Units& units) {
  field.check_keys({"svc", "rpa", "cut", "cut_tilt_deg", "incision", "incision_length",
                    "incision_shape", "rotation_deg", "keep"});
  GlennSpec glenn;
  glenn.line = field.line();
  glenn.svc =
      read_operated(field.at("svc", "the name of the superior vena cava's vessel"), vessels);
  const Field rpa = field.at("rpa", "the name of the pulmonary artery's vessel");
  glenn.rpa = read_operated(rpa, vessels);
  if (glenn.svc == glenn.rpa)
    rpa.refuse(in_quotes(glenn.rpa) + ", which is the svc", "another vessel");
  const VesselSpec& svc = named_vessel(field.at("svc", ""), vessels);
  glenn.cut = read_pick(field.at("cut", "a point picked on the svc"), svc, false, folder, units);
  glenn.incision = read_pick(field.at("incision", "a point picked on the rpa"),
                             named_vessel(rpa, vessels), true, folder, units);
  if (const auto tilt = field.find("cut_tilt_deg"))
    glenn.cut_tilt_deg = tilt->number_in(cut_tilts_deg[0], cut_tilts_deg[1]);
  if (const auto length = field.find("incision_length"))
    glenn.incision_length = length->number_in(incision_lengths[0], incision_lengths[1]);
  if (const auto shape = field.find("incision_shape")) glenn.ellipse = read_shape(*shape);
  if (glenn.ellipse && glenn.ellipse->length && field.has("incision_length"))
    field.at("incision_length", "a number")
        .refuse("it beside an ellipse that has a length", "one of the two");
  glenn.rotation_deg = read_rotation(field);
  glenn.keep = read_keep(field, svc, "svc");
  return glenn;
}

}  // namespace vasorod
