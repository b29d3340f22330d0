#include <cmath>

#include "scene/read_parts.h"

namespace vasorod {

namespace {

std::string read_operated(const Field& field, const std::vector<VesselSpec>& vessels) {
  const VesselSpec& vessel = named_vessel(field, vessels);
  if (vessel.rod) field.refuse("the bare rod " + in_quotes(vessel.name), "a vessel with a surface");
  if (vessel.role == Role::obstacle)
    field.refuse("the obstacle " + in_quotes(vessel.name), "a deformable vessel, as obstacles never move");
  return vessel.name;
}

ExploreRange read_range(const Field& field, std::optional<std::array<double, 2>> limits) {
  field.check_keys({"from", "to", "steps"});
  auto bound = [&](const char* key) {
    const Field value = field.at(key, "a number");
    return limits ? value.number_in((*limits)[0], (*limits)[1]) : value.number();
  };
  ExploreRange range{bound("from"), bound("to"),
                     field.at("steps", "the number of steps").integer_in(1, 100000)};
  if (range.to < range.from) field.refuse("to below from", "to at least from");
  if (range.steps > 1 && range.to == range.from)
    field.refuse("several steps from a number to itself", "steps: 1, or to above from");
  return range;
}

}  // namespace

GlennSpec read_glenn(const Field& field, const std::vector<VesselSpec>& vessels) {
  field.check_keys({"svc", "rpa", "cut", "incision", "rotation_deg", "keep"});
  GlennSpec glenn;
  glenn.line = field.line();
  glenn.svc = read_operated(field.at("svc", "the name of the superior vena cava's vessel"), vessels);
  const Field rpa = field.at("rpa", "the name of the pulmonary artery's vessel");
  glenn.rpa = read_operated(rpa, vessels);
  if (glenn.svc == glenn.rpa) rpa.refuse(in_quotes(glenn.rpa) + ", which is the svc", "another vessel");
  glenn.cut = field.at("cut", "a point picked on the svc").vec3();
  glenn.incision = field.at("incision", "a point picked on the rpa").vec3();
  if (const auto rotation = field.find("rotation_deg"); rotation && rotation->found() != "\"auto\"")
    glenn.rotation_deg = rotation->number("auto or a number");
  const Field keep = field.at("keep", "{near: [x, y, z]}, the end of the cut svc that goes on");
  keep.check_keys({"near"});
  glenn.keep_near = keep.at("near", "a point near the kept end").vec3();
  return glenn;
}

ExploreSpec read_explore(const Field& field) {
  field.check_keys({"cut_along", "incision_along", "rotation_deg"});
  constexpr std::array<double, 2> fraction = {0, 1};
  ExploreSpec explore;
  if (const auto cut = field.find("cut_along")) explore.cut_along = read_range(*cut, fraction);
  if (const auto incision = field.find("incision_along"))
    explore.incision_along = read_range(*incision, fraction);
  if (const auto rotation = field.find("rotation_deg"))
    explore.rotation_deg = read_range(*rotation, std::nullopt);
  if (!explore.cut_along && !explore.incision_along && !explore.rotation_deg)
    field.refuse(field.found(), "at least one of cut_along, incision_along and rotation_deg");
  return explore;
}

}  // namespace vasorod
