#include "planner/opened_scene.h"

#include <array>
#include <charconv>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "data/sentence.h"
#include "explore/options.h"
#include "propose/scene_text.h"
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

void find_plan(OpenedScene& opened) {
  const GlennSpec& glenn = *opened.scene.glenn;
  if (glenn.ellipse && (glenn.ellipse->length || glenn.ellipse->width)) {
    opened.why_not =
        "incision_shape: found an ellipse with lengths, expected slit or {ellipse: RATIO}, whose "
        "size the planner can change";
    return;
  }
  const Vessel &vein = opened.svc().vessel, &artery = opened.rpa().vessel;
  const PickSpec cut = cut_by_fraction(opened.scene, opened.fitted),
                 incision = incision_by_fraction(opened.scene, opened.fitted);
  opened.cut_route = pick_ends("cut", cut, vein, find_end(vein, glenn.keep, "keep"));
  opened.incision_route = pick_ends("incision", incision, artery, 0);
  Plan plan;
  plan.cut_along = *cut.along;
  plan.cut_tilt_deg = glenn.cut_tilt_deg;
  plan.incision_along = *incision.along;
  plan.around_deg = incision.around_deg;
  plan.incision_length = glenn.incision_length;
  if (glenn.ellipse) plan.ellipse_ratio = glenn.ellipse->ratio;
  plan.rotation_deg = glenn.rotation_deg;
  opened.plan = plan;
}

void require_ends(const RouteEnds& route, const Vessel& vessel, const std::string& what) {
  for (const int end : route)
    if (end >= static_cast<int>(vessel.ends.size()))
      throw Refusal(400, "plan." + what + ".route: found the end " + std::to_string(end) +
                             ", expected 0 to " + std::to_string(vessel.ends.size() - 1));
}

std::string cut_text(const OpenedScene& opened, const Plan& plan) {
  const RouteEnds route = cut_route_of(opened, plan);
  std::string text = "{along: " + exact_text(plan.cut_along);
  if (route[1] != farthest_end(opened.svc().vessel, route[0]))
    text += ", to: " + yaml_of(selector_of(opened.svc().vessel, route[1]));
  return text + "}";
}

std::string incision_text(const OpenedScene& opened, const Plan& plan) {
  const Vessel& artery = opened.rpa().vessel;
  const RouteEnds route = incision_route_of(opened, plan);
  std::string text =
      "{along: " + exact_text(plan.incision_along) + ", around_deg: " + exact_text(plan.around_deg);
  if (route[0] != 0) text += ", from: " + yaml_of(selector_of(artery, route[0]));
  if (route[1] != farthest_end(artery, route[0]))
    text += ", to: " + yaml_of(selector_of(artery, route[1]));
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

RouteEnds cut_route_of(const OpenedScene& opened, const Plan& plan) {
  const RouteEnds route = plan.cut_route.value_or(opened.cut_route);
  require_ends(route, opened.svc().vessel, "cut");
  if (route[0] != opened.cut_route[0])
    throw Refusal(400, "plan.cut.route: found a way from the end " + std::to_string(route[0]) +
                           ", expected one from the kept end, " +
                           std::to_string(opened.cut_route[0]));
  return route;
}

RouteEnds incision_route_of(const OpenedScene& opened, const Plan& plan) {
  const RouteEnds route = plan.incision_route.value_or(opened.incision_route);
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
