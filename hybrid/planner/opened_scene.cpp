#include "planner/opened_scene.h"

#include <array>
#include <charconv>
#include <cmath>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "data/index.h"
#include "data/sentence.h"
#include "explore/options.h"
#include "surgery/pick_place.h"
#include "vessel/end_conditions.h"
#include "vessel/name_ends.h"

namespace vasorod::planner {
namespace {

// The shortest text that reads back to the same double.
std::string exact_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string selector_text(const EndSelector& selector) {
  switch (selector.kind) {
    case EndSelector::Kind::end:
      return "end";
    case EndSelector::Kind::near:
      return "{near: [" + exact_text(selector.near.x()) + ", " + exact_text(selector.near.y()) +
             ", " + exact_text(selector.near.z()) + "]}";
    case EndSelector::Kind::face:
      return "{face: " + std::to_string(selector.face) + "}";
    default:
      return "start";
  }
}

// The first of the routes that the pick lies on. Empty: none.
template <class Find>
std::optional<Route> route_with(const std::vector<Route>& routes, Find&& lies_on) {
  for (const Route& route : routes)
    if (lies_on(route)) return route;
  return std::nullopt;
}

// From one end to each other, the farthest first.
std::vector<Route> routes_from(const Vessel& vessel, int from) {
  const int far = farthest_end(vessel, from);
  std::vector<Route> routes{{from, far}};
  for (int end = 0; end < static_cast<int>(vessel.ends.size()); ++end)
    if (end != from && end != far) routes.push_back({from, end});
  return routes;
}

AxisRoute axis(const Vessel& vessel, const Route& route) {
  return {vessel.rod, vessel.ends[index(route[0])].node, vessel.ends[index(route[1])].node};
}

void find_plan(OpenedScene& opened) {
  const GlennSpec& glenn = *opened.scene.glenn;
  const Vessel& vein = opened.svc().vessel;
  const Vessel& artery = opened.rpa().vessel;
  Plan plan;
  const int kept = find_end(vein, glenn.keep, "keep");
  const PickPlace cut = place_cut("cut", glenn.cut, opened.svc(), kept);
  std::vector<Route> routes = routes_from(vein, kept);
  if (glenn.cut.to) routes = {{kept, find_end(vein, *glenn.cut.to, "cut: to")}};
  const auto on_vein = route_with(routes, [&](const Route& route) {
    return axis(vein, route).distance_to(cut.at).has_value();
  });
  const PickPlace incision = place_incision_pick("incision", glenn.incision, opened.rpa());
  routes = routes_from(artery, 0);
  if (glenn.incision.from || glenn.incision.to) {
    const int from = glenn.incision.from ? find_end(artery, *glenn.incision.from, "from") : 0;
    const int to =
        glenn.incision.to ? find_end(artery, *glenn.incision.to, "to") : farthest_end(artery, from);
    routes = {{from, to}};
  }
  const auto on_artery = route_with(routes, [&](const Route& route) {
    return axis(artery, route).distance_to(incision.at).has_value();
  });
  if (!on_vein || !on_artery) {
    opened.why_not = std::string(on_vein ? "incision" : "cut") +
                     ": found a point that lies on no way between the vessel's ends that the "
                     "planner knows, expected {along: fraction} with the way's end";
    return;
  }
  if (glenn.ellipse && (glenn.ellipse->length || glenn.ellipse->width)) {
    opened.why_not =
        "incision_shape: found an ellipse with lengths, expected slit or {ellipse: RATIO}, whose "
        "size the planner can change";
    return;
  }
  opened.cut_route = *on_vein;
  opened.incision_route = *on_artery;
  const AxisRoute along_vein = axis(vein, *on_vein), along_artery = axis(artery, *on_artery);
  plan.cut_along =
      glenn.cut.along ? *glenn.cut.along : *along_vein.distance_to(cut.at) / along_vein.length();
  plan.cut_tilt_deg = glenn.cut_tilt_deg;
  plan.incision_along = glenn.incision.along
                            ? *glenn.incision.along
                            : *along_artery.distance_to(incision.at) / along_artery.length();
  plan.around_deg =
      glenn.incision.along ? glenn.incision.around_deg : incision.angle * (180 / M_PI);
  plan.incision_length = glenn.incision_length;
  if (glenn.ellipse) plan.ellipse_ratio = glenn.ellipse->ratio;
  plan.rotation_deg = glenn.rotation_deg;
  opened.plan = plan;
}

void require_ends(const Route& route, const Vessel& vessel, const std::string& what) {
  for (const int end : route)
    if (end >= static_cast<int>(vessel.ends.size()))
      throw Refusal(400, "plan." + what + ".route: found the end " + std::to_string(end) +
                             ", expected 0 to " + std::to_string(vessel.ends.size() - 1));
}

std::string cut_text(const OpenedScene& opened, const Plan& plan) {
  const Route route = cut_route_of(opened, plan);
  std::string text = "{along: " + exact_text(plan.cut_along);
  if (route[1] != farthest_end(opened.svc().vessel, route[0]))
    text += ", to: " + selector_text(selector_of(opened.svc().vessel, route[1]));
  return text + "}";
}

std::string incision_text(const OpenedScene& opened, const Plan& plan) {
  const Vessel& artery = opened.rpa().vessel;
  const Route route = incision_route_of(opened, plan);
  std::string text =
      "{along: " + exact_text(plan.incision_along) + ", around_deg: " + exact_text(plan.around_deg);
  if (route[0] != 0) text += ", from: " + selector_text(selector_of(artery, route[0]));
  if (route[1] != farthest_end(artery, route[0]))
    text += ", to: " + selector_text(selector_of(artery, route[1]));
  return text + "}";
}

}  // namespace

std::size_t OpenedScene::vessel(const std::string& name) const {
  for (std::size_t k = 0; k < fitted.vessels.size(); ++k)
    if (fitted.vessels[k].spec.name == name) return k;
  throw Refusal(404, "found no vessel " + in_quotes(name) + ", expected one of the scene");
}

std::string OpenedScene::part_of(std::size_t vessel) const {
  if (!scene.glenn) return "";
  return vessel == svc_at ? "svc" : vessel == rpa_at ? "rpa" : "";
}

std::shared_ptr<const OpenedScene> open_scene(const std::string& id,
                                              const std::filesystem::path& file) {
  auto opened = std::make_shared<OpenedScene>();
  opened->id = id;
  opened->scene = read_scene(file);
  const bool rods = std::any_of(opened->scene.vessels.begin(), opened->scene.vessels.end(),
                                [](const VesselSpec& vessel) { return vessel.rod.has_value(); });
  if (rods)
    throw InputError(one_line(file.string()) +
                     ": found bare rods, expected vessels with surfaces, which the page shows");
  opened->fitted = fit_vessels(opened->scene);
  for (const PreparedVessel& vessel : opened->fitted.vessels)
    opened->walls.emplace_back(vessel.vessel.surface);
  if (opened->scene.glenn) {
    opened->svc_at = opened->vessel(opened->scene.glenn->svc);
    opened->rpa_at = opened->vessel(opened->scene.glenn->rpa);
    try {
      find_plan(*opened);
    } catch (const InputError& error) {
      opened->why_not = error.what();
    }
  } else {
    opened->why_not = "found no surgery: glenn, expected the operation whose plan is changed";
  }
  return opened;
}

Route cut_route_of(const OpenedScene& opened, const Plan& plan) {
  const Route route = plan.cut_route.value_or(opened.cut_route);
  require_ends(route, opened.svc().vessel, "cut");
  if (route[0] != opened.cut_route[0])
    throw Refusal(400, "plan.cut.route: found a way from the end " + std::to_string(route[0]) +
                           ", expected one from the kept end, " +
                           std::to_string(opened.cut_route[0]));
  return route;
}

Route incision_route_of(const OpenedScene& opened, const Plan& plan) {
  const Route route = plan.incision_route.value_or(opened.incision_route);
  require_ends(route, opened.rpa().vessel, "incision");
  return route;
}

SceneEdit edit_for(const OpenedScene& opened, const Plan& plan,
                   const std::optional<std::string>& fidelity) {
  if (!opened.plan) throw Refusal(400, opened.why_not);
  const Plan& old = *opened.plan;
  SceneEdit edit;
  const auto set = [&](const char* key, const std::string& value) {
    edit.glenn.emplace_back(key, value);
  };
  if (plan.cut_along != old.cut_along || cut_route_of(opened, plan) != opened.cut_route)
    set("cut", cut_text(opened, plan));
  if (plan.cut_tilt_deg != old.cut_tilt_deg) set("cut_tilt_deg", exact_text(plan.cut_tilt_deg));
  if (plan.incision_along != old.incision_along || plan.around_deg != old.around_deg ||
      incision_route_of(opened, plan) != opened.incision_route)
    set("incision", incision_text(opened, plan));
  if (plan.incision_length != old.incision_length)
    set("incision_length", exact_text(plan.incision_length));
  if (plan.ellipse_ratio != old.ellipse_ratio)
    set("incision_shape",
        plan.ellipse_ratio ? "{ellipse: " + exact_text(*plan.ellipse_ratio) + "}" : "slit");
  if (plan.rotation_deg != old.rotation_deg)
    set("rotation_deg", plan.rotation_deg ? exact_text(*plan.rotation_deg) : "auto");
  if (fidelity && fidelity != opened.scene.fidelity) edit.fidelity = fidelity;
  return edit;
}

Scene with_plan(const OpenedScene& opened, const Plan& plan,
                const std::optional<std::string>& fidelity) {
  const std::string text = edited_scene(opened.scene.text, edit_for(opened, plan, fidelity)).text;
  return read_scene_text(text, opened.scene.file.parent_path());
}

}  // namespace vasorod::planner
