#include "vessel/end_conditions.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/scene_place.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

Vec3 radians(const Vec3& degrees) {
  return degrees * (M_PI / 180);
}

// A point far off every end is a slip of the keyboard, or of the units.
void require_near(const Vessel& vessel, const VesselEnd& nearest, const Vec3& point,
                  const std::string& where) {
  constexpr double most_radii = 2;
  const double most = most_radii * vessel.rod.radius[static_cast<size_t>(nearest.node)],
               distance = (nearest.center - point).norm();
  if (!(distance <= most))
    throw InputError(where + ": near: found " + place_text(point) + ", " +
                     number_text(distance, 4) + " off the nearest end's centre " +
                     place_text(nearest.center, 4) + ", expected at most two radii there, " +
                     number_text(most, 4));
}

// "the ModelFaceID of a lid: 2 or 3".
std::string faces_of(const Vessel& vessel) {
  std::vector<std::string> faces;
  for (const VesselEnd& end : vessel.ends)
    if (!end.face.empty()) faces.push_back(end.face);
  if (faces.empty())
    return "start, end or {near: [x, y, z]}, as no end of this vessel had a lid with a ModelFaceID";
  return "the ModelFaceID of a lid over one of its ends: " + listed(faces);
}

RodSupport& support_at(RodConditions& conditions, int node) {
  for (RodSupport& support : conditions.supports)
    if (support.node == node) return support;
  RodSupport none;
  none.node = node;
  none.fixed.fill(false);
  conditions.supports.push_back(none);
  return conditions.supports.back();
}

// How a message names it.
std::string called(const EndCondition& condition) {
  return condition.line > 0 ? "line " + std::to_string(condition.line) : "another condition";
}

}  // namespace

int find_end(const Vessel& vessel, const EndSelector& selector, const std::string& where) {
  switch (selector.kind) {
    case EndSelector::Kind::start:
      return 0;
    case EndSelector::Kind::end:
      if (vessel.ends.size() != 2)
        throw InputError(where + ": end: found `end` on a vessel with " +
                         std::to_string(vessel.ends.size()) +
                         " ends, expected {near: [x, y, z]} or {face: n}");
      return 1;
    case EndSelector::Kind::near: {
      const auto nearest = std::min_element(vessel.ends.begin(), vessel.ends.end(),
                                            [&](const VesselEnd& a, const VesselEnd& b) {
                                              return (a.center - selector.near).squaredNorm() <
                                                     (b.center - selector.near).squaredNorm();
                                            });
      require_near(vessel, *nearest, selector.near, where);
      return static_cast<int>(nearest - vessel.ends.begin());
    }
    case EndSelector::Kind::face: {
      const std::string face = std::to_string(selector.face);
      const auto named = [&](const VesselEnd& end) { return end.face == face; };
      const auto found = std::find_if(vessel.ends.begin(), vessel.ends.end(), named);
      if (found == vessel.ends.end())
        throw InputError(where + ": face: found " + face + ", expected " + faces_of(vessel));
      if (std::count_if(vessel.ends.begin(), vessel.ends.end(), named) > 1)
        throw InputError(where + ": face: found " + face +
                         ", which closed several ends, expected {near: [x, y, z]} or {face: n}");
      return static_cast<int>(found - vessel.ends.begin());
    }
    case EndSelector::Kind::at:
      break;
  }
  throw InputError(where +
                   ": end: found {at: ...} on a vessel with a surface, expected start, end, "
                   "{near: [x, y, z]} or {face: n}");
}

VesselConditions end_conditions(const Scene& scene, const std::string& name, const Vessel& vessel) {
  VesselConditions conditions;
  std::vector<std::pair<int, const EndCondition*>> before;
  for (const EndCondition& entry : scene.ends) {
    if (entry.vessel != name) continue;
    const std::string where = place_in(scene, entry.line);
    const int end = find_end(vessel, entry.end, where);
    const int node = vessel.ends[static_cast<size_t>(end)].node;
    for (const auto& [other_end, other] : before)
      if (other_end == end && exclude_each_other(entry, *other))
        throw InputError(where + ": end: found " + to_string(entry.end) + " of " + name +
                         ", the end that " + called(*other) + " calls " + to_string(other->end) +
                         ", expected one motion, or one load and one fix, for each end");
    before.emplace_back(end, &entry);

    auto known = std::find_if(conditions.ends.begin(), conditions.ends.end(),
                              [&](const ConditionedEnd& other) { return other.end == end; });
    if (known == conditions.ends.end())
      known = conditions.ends.insert(known, {to_string(entry.end), end, false});
    known->rigid = !entry.soft_section;

    const bool moved = entry.rotate_deg || entry.move;
    const bool some_fixed =
        std::any_of(entry.fix.begin(), entry.fix.end(), [](bool f) { return f; });
    if (entry.hold || moved || some_fixed) {
      RodSupport& support = support_at(conditions.rod, node);
      for (size_t k = 0; k < 6; ++k)
        support.fixed[k] |= entry.hold || (moved && !some_fixed) || entry.fix[k];
      if (entry.rotate_deg) support.motion.rotate += radians(*entry.rotate_deg);
      if (entry.move) support.motion.move += *entry.move;
      conditions.acts |= moved;
    }
    if (entry.force || entry.moment) {
      RodLoad load;
      load.node = node;
      load.force = entry.force.value_or(Vec3::Zero());
      load.moment = entry.moment.value_or(Vec3::Zero());
      load.moment_in_body = entry.moment_in_body;
      conditions.rod.loads.push_back(load);
      conditions.acts = true;
    }
  }
  return conditions;
}

}  // namespace vasorod
