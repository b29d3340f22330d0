#include "planner/plan.h"

#include "data/limits.h"

namespace vasorod::planner {
namespace {

constexpr int most_ends = 1000;

std::optional<RouteEnds> read_route(const Body& pick) {
  if (!pick.has("route")) return std::nullopt;
  const Json& value = pick.value("route");
  RouteEnds route{};
  bool good = value.is_array() && value.size() == 2;
  for (std::size_t k = 0; good && k < 2; ++k) {
    good = value[k].is_number_integer() && value[k] >= 0 && value[k] < most_ends;
    if (good) route[k] = value[k].get<int>();
  }
  if (!good || route[0] == route[1]) pick.refuse("route", "two different ends' numbers, from 0");
  return route;
}

void add_route(const std::optional<RouteEnds>& route, Json& pick) {
  if (route) pick["route"] = *route;
}

}  // namespace

Plan read_plan(const Body& body) {
  body.check_keys({"cut", "cut_tilt_deg", "incision", "incision_length", "shape", "rotation_deg"});
  Plan plan;
  const Body cut = body.object("cut"), incision = body.object("incision");
  cut.check_keys({"along", "route"});
  incision.check_keys({"along", "around_deg", "route"});
  plan.cut_along = cut.number("along", 0, 1);
  plan.cut_route = read_route(cut);
  plan.incision_along = incision.number("along", 0, 1);
  plan.around_deg = incision.number("around_deg", -360, 360);
  plan.incision_route = read_route(incision);
  plan.cut_tilt_deg = body.number("cut_tilt_deg", cut_tilts_deg[0], cut_tilts_deg[1]);
  plan.incision_length = body.number("incision_length", incision_lengths[0], incision_lengths[1]);
  if (body.has("shape")) {
    if (body.value("shape").is_object()) {
      const Body shape = body.object("shape");
      shape.check_keys({"ellipse"});
      plan.ellipse_ratio = shape.number("ellipse", ellipse_ratios[0], ellipse_ratios[1]);
    } else if (body.value("shape") != "slit") {
      body.refuse("shape", "\"slit\" or {\"ellipse\": ratio}");
    }
  }
  if (body.has("rotation_deg"))
    plan.rotation_deg = body.number("rotation_deg", -largest_length, largest_length);
  return plan;
}

Json json_of(const Plan& plan) {
  Json json;
  json["cut"] = {{"along", plan.cut_along}};
  add_route(plan.cut_route, json["cut"]);
  json["cut_tilt_deg"] = plan.cut_tilt_deg;
  json["incision"] = {{"along", plan.incision_along}, {"around_deg", plan.around_deg}};
  add_route(plan.incision_route, json["incision"]);
  json["incision_length"] = plan.incision_length;
  if (plan.ellipse_ratio)
    json["shape"] = {{"ellipse", *plan.ellipse_ratio}};
  else
    json["shape"] = "slit";
  json["rotation_deg"] = plan.rotation_deg ? Json(*plan.rotation_deg) : Json();
  return json;
}

}  // namespace vasorod::planner
