#include "planner/place.h"

#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/plane_section.h"
#include "surgery/glenn.h"
#include "surgery/pick_place.h"

namespace vasorod::planner {
namespace {

// The points of a rim, each once in a row.
Json outline_of(const std::vector<std::array<int, 2>>& pairs, std::size_t side,
                const Points& points) {
  Json outline = Json::array();
  int before = -1;
  for (const auto& pair : pairs) {
    if (pair[side] == before) continue;
    before = pair[side];
    outline.push_back(json_of(Vec3(points.row(before))));
  }
  return outline;
}

void draw_built(const OpenedScene& opened, const Scene& scene, Json& answer) {
  PreparedVessel vein = opened.svc(), artery = opened.rpa();
  VesselConditions conditions = end_conditions(scene, vein.spec.name, vein.vessel);
  const Operation operation = operate(scene, *scene.glenn, vein, artery, conditions);
  const GlennReport& report = *operation.glenn;
  answer["cut"] = {{"point", json_of(report.cut.point)},
                   {"normal", json_of(report.cut.normal)},
                   {"outline", outline_of(operation.pairs, 0, vein.vessel.surface.points)}};
  answer["incision"] = {
      {"point", json_of(report.incision.pick)},
      {"ends", {json_of(report.incision.ends[0]), json_of(report.incision.ends[1])}},
      {"outline", outline_of(operation.pairs, 1, artery.vessel.surface.points)},
      {"length", report.incision.length}};
}

// The cut across the vein, without its tilt, which depends on the join.
double draw_cut(const OpenedScene& opened, const GlennSpec& glenn, Json& answer) {
  const Vessel& vein = opened.svc().vessel;
  const PickPlace place =
      place_cut("cut", glenn.cut, opened.svc(), find_end(vein, glenn.keep, "keep"));
  const Vec3 centre = place.section.position, normal = place.section.director(3);
  const auto loops = plane_sections(vein.surface, centre, normal);
  const int around = section_around(loops, centre, normal);
  answer["cut"] = {{"point", json_of(centre)},
                   {"normal", json_of(normal)},
                   {"outline", around < 0 ? Json::array() : json_of(loops[index(around)].points)}};
  return around < 0 ? 2 * M_PI * place.radius : section_perimeter(loops[index(around)]);
}

// The incision as a line on the wall at one angle about the axis.
void draw_incision(const OpenedScene& opened, const Plan& plan, const GlennSpec& glenn,
                   double mouth, Json& answer) {
  const PickPlace place = place_incision_pick("incision", glenn.incision, opened.rpa());
  const Vessel& artery = opened.rpa().vessel;
  const double length = glenn.incision_length * mouth / 2;
  Json ends = Json::array();
  const AxisRoute route(artery, incision_route_of(opened, plan));
  const RayHits& wall = opened.walls[opened.rpa_at];
  const double at = plan.incision_along * route.length();
  for (const double sense : {-0.5, 0.5}) {
    const AxisPlace there = route.at(at + sense * length);
    const auto point = wall_point(
        wall, frame_at(artery.rod, artery.rod.rest, there.element, there.s), place.angle);
    ends.push_back(json_of(point.value_or(place.point)));
  }
  answer["incision"] = {{"point", json_of(place.point)},
                        {"ends", ends},
                        {"outline", Json::array()},
                        {"length", length}};
}

}  // namespace

Json placed_plan(const OpenedScene& opened, const Plan& plan) {
  const Scene scene = with_plan(opened, plan, std::nullopt);
  Json answer{{"cut", nullptr}, {"incision", nullptr}, {"problem", nullptr}};
  try {
    draw_built(opened, scene, answer);
    return answer;
  } catch (const InputError& error) {
    answer["problem"] = one_line(error.what());
  }
  double mouth = 0;
  try {
    mouth = draw_cut(opened, *scene.glenn, answer);
  } catch (const InputError&) {  // its sentence is the problem
    return answer;
  }
  try {
    draw_incision(opened, plan, *scene.glenn, mouth, answer);
  } catch (const InputError&) {
  }
  return answer;
}

}  // namespace vasorod::planner
