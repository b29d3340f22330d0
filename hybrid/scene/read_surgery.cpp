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

}  // namespace

GlennSpec read_glenn(const Field& field, const std::vector<VesselSpec>& vessels) {
  field.check_keys({"svc", "rpa", "cut", "incision", "incision_length", "rotation_deg", "keep"});
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
  if (const auto length = field.find("incision_length"))
    glenn.incision_length = length->number_in(0.25, 4);
  if (const auto rotation = field.find("rotation_deg"); rotation && rotation->found() != "\"auto\"")
    glenn.rotation_deg = rotation->number_up_to(largest_length, "auto or a number");
  const Field keep = field.at("keep", "{near: [x, y, z]}, the end of the cut svc that goes on");
  keep.check_keys({"near"});
  glenn.keep_near = keep.at("near", "a point near the kept end").vec3();
  return glenn;
}

}  // namespace vasorod
