#include "planner/scene_answer.h"

#include <vasorod/predict.h>

#include "data/index.h"
#include "data/limits.h"
#include "report/report_pictures.h"
#include "vessel/axis_route.h"

namespace vasorod::planner {
namespace {

// Points of a way along the axis, at its nodes' distances at most.
constexpr int axis_points = 101;

Json limits() {
  return {{"incision_length", incision_lengths},
          {"cut_tilt_deg", cut_tilts_deg},
          {"ellipse_ratio", ellipse_ratios}};
}

Json axis_json(const Vessel& vessel, const RouteEnds& route) {
  const AxisRoute way(vessel, route);
  Json axis = Json::array();
  for (int k = 0; k < axis_points; ++k) {
    const double along = static_cast<double>(k) / (axis_points - 1);
    const AxisPlace at = way.at(along * way.length());
    const RodElement& element = vessel.rod.elements[index(at.element)];
    const double share = element.length > 0 ? at.s / element.length : 0;
    const double radius = (1 - share) * vessel.rod.radius[index(element.first)] +
                          share * vessel.rod.radius[index(element.second)];
    axis.push_back(
        {{"along", along},
         {"point", json_of(frame_at(vessel.rod, vessel.rod.rest, at.element, at.s).position)},
         {"radius", radius}});
  }
  return axis;
}

Json vessel_json(const OpenedScene& opened, std::size_t k) {
  const PreparedVessel& prepared = opened.fitted.vessels[k];
  const Vessel& vessel = prepared.vessel;
  const std::string part = opened.part_of(k);
  Json one{{"name", prepared.spec.name},
           {"role", prepared.obstacle() ? "obstacle" : "deformable"},
           {"part", part.empty() ? Json() : Json(part)},
           {"radius", prepared.obstacle() ? Json() : Json(vessel.mean_radius)},
           {"ends", Json::array()},
           {"axis", Json::array()}};
  for (std::size_t e = 0; e < vessel.ends.size(); ++e) {
    const VesselEnd& end = vessel.ends[e];
    one["ends"].push_back({{"end", e},
                           {"face", end.face},
                           {"centre", json_of(end.center)},
                           {"normal", json_of(end.outward)},
                           {"radius", vessel.rod.radius[index(end.node)]}});
  }
  if (part.empty() || !opened.plan) return one;
  const RouteEnds usual = part == "svc" ? opened.cut_route : opened.incision_route;
  one["axis"] = axis_json(vessel, usual);
  one["route"] = usual;
  one["routes"] = Json::array();
  for (int end = 0; end < static_cast<int>(vessel.ends.size()); ++end)
    if (end != usual[0])
      one["routes"].push_back(
          {{"route", RouteEnds{usual[0], end}}, {"axis", axis_json(vessel, {usual[0], end})}});
  return one;
}

std::string space_of_vessels(const FittedVessels& fitted) {
  for (const PreparedVessel& vessel : fitted.vessels)
    if (!vessel.loaded.space.empty()) return vessel.loaded.space;
  return "";
}

}  // namespace

Json scene_answer(const OpenedScene& opened) {
  const Scene& scene = opened.scene;
  Json answer{{"id", opened.id},
              {"name", scene.name},
              {"kind", "scene"},
              {"units", {{"length", scene.units.length}, {"stress", scene.units.stress}}},
              {"space", space_of_vessels(opened.fitted)},
              {"fidelity", scene.fidelity ? Json(*scene.fidelity) : Json()},
              {"editable", opened.plan.has_value()},
              {"why_not", opened.plan ? Json() : Json(opened.why_not)},
              {"plan", opened.plan ? json_of(*opened.plan) : Json()},
              {"result", nullptr},
              {"limits", limits()},
              {"vessels", Json::array()}};
  for (std::size_t k = 0; k < opened.fitted.vessels.size(); ++k)
    answer["vessels"].push_back(vessel_json(opened, k));
  return answer;
}

Json result_answer(const std::string& id, const std::string& name, const StoredResult& stored) {
  const Result& result = stored.result;
  Json answer{{"id", id},
              {"name", name},
              {"kind", "result"},
              {"units", {{"length", result.length_unit}, {"stress", result.stress_unit}}},
              {"space", space_of(result)},
              {"fidelity", result.fidelity},
              {"editable", false},
              {"why_not", "found a result, expected a scene whose plan is changed"},
              {"plan", nullptr},
              {"result", stored.id},
              {"limits", limits()},
              {"vessels", Json::array()}};
  for (const VesselResult& vessel : result.vessels)
    answer["vessels"].push_back({{"name", vessel.name},
                                 {"role", vessel.obstacle ? "obstacle" : "deformable"},
                                 {"part", nullptr},
                                 {"radius", nullptr},
                                 {"ends", Json::array()},
                                 {"axis", Json::array()}});
  return answer;
}

}  // namespace vasorod::planner
