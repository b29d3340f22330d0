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
    ellipse.ratio = field.number_in(0.1, 1);
    return ellipse;
  }
  field.check_keys({"length", "width"});
  ellipse.width = field.at("width", "the ellipse's axis across the artery").length();
  if (const auto length = field.find("length")) ellipse.length = length->length();
  return ellipse;
}

std::optional<IncisionEllipse> read_shape(const Field& field) {
  if (!field.is_map()) {
    const std::string expected = "slit, {ellipse: RATIO} or {ellipse: {length: L, width: W}}";
    if (field.text(expected) != "slit") field.refuse(field.found(), expected);
    return std::nullopt;
  }
  field.check_keys({"ellipse"});
  return read_ellipse(field.at("ellipse", "width over length, or {length: L, width: W}"));
}

}  // namespace

GlennSpec read_glenn(const Field& field, const std::vector<VesselSpec>& vessels) {
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
  glenn.cut = field.at("cut", "a point picked on the svc").vec3();
  glenn.incision = field.at("incision", "a point picked on the rpa").vec3();
  if (const auto tilt = field.find("cut_tilt_deg")) glenn.cut_tilt_deg = tilt->number_in(-75, 75);
  if (const auto length = field.find("incision_length"))
    glenn.incision_length = length->number_in(0.25, 4);
  if (const auto shape = field.find("incision_shape")) glenn.ellipse = read_shape(*shape);
  if (glenn.ellipse && glenn.ellipse->length && field.has("incision_length"))
    field.at("incision_length", "a number")
        .refuse("it beside an ellipse that has a length", "one of the two");
  if (const auto rotation = field.find("rotation_deg"); rotation && rotation->found() != "\"auto\"")
    glenn.rotation_deg = rotation->number_up_to(largest_length, "auto or a number");
  const Field keep = field.at("keep", "{near: [x, y, z]}, the end of the cut svc that goes on");
  keep.check_keys({"near"});
  glenn.keep_near = keep.at("near", "a point near the kept end").vec3();
  return glenn;
}

}  // namespace vasorod
