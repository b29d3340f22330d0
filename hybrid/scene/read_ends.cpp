#include <unordered_map>

#include "scene/read_parts.h"

namespace vasorod {

namespace {

std::string ends_of(const VesselSpec& vessel) {
  return vessel.rod ? "start, end, {near: [x, y, z]} or {at: fraction}"
                    : "start, end, {near: [x, y, z]} or {face: ModelFaceID}";
}

EndSelector read_place(const Field& at, const VesselSpec& vessel) {
  if (!vessel.rod) at.refuse("it on a vessel with a surface", ends_of(vessel));
  EndSelector selector;
  selector.kind = EndSelector::Kind::at;
  selector.at = at.number_in(0, 1);
  return selector;
}

// The end of an entry of `ends:`, which may be a place on a bare rod.
EndSelector end_of(const Field& entry, const VesselSpec& vessel) {
  const auto at = entry.find("at"), end = entry.find("end");
  if (at && end) at->refuse("it beside end", "one or the other");
  if (at) return read_place(*at, vessel);
  return read_selector(entry.at("end", ends_of(vessel)), vessel);
}

std::array<bool, 6> read_fix(const Field& field) {
  const std::vector<std::string> words = {"x", "y", "z", "rx", "ry", "rz"};
  std::array<bool, 6> fixed{};
  const auto items = field.list("a list of some of x, y, z, rx, ry, rz");
  if (items.empty()) field.refuse("an empty list", "at least one of x, y, z, rx, ry, rz");
  for (const Field& item : items) {
    const std::string word = item.one_of(words);
    for (size_t k = 0; k < 6; ++k) {
      if (words[k] != word) continue;
      if (fixed[k]) item.refuse(in_quotes(word) + " a second time", "it once");
      fixed[k] = true;
    }
  }
  return fixed;
}

void check_sense(const Field& entry, const EndCondition& end) {
  if (const std::string wrong = contradiction(end); !wrong.empty()) entry.refuse(wrong);
}

bool same_place(const EndCondition& a, const EndCondition& b) {
  return a.vessel == b.vessel && a.end.kind == b.end.kind && a.end.near == b.end.near &&
         a.end.at == b.end.at && a.end.face == b.end.face;
}

// Two different names of one end are detected once the vessel is known (vessel/end_conditions.h).
// `before`: the entries of the same vessel.
void check_shared(const Field& entry, const EndCondition& end, const std::vector<EndCondition>& all,
                  const std::vector<size_t>& before) {
  for (const size_t i : before)
    if (same_place(end, all[i]) && exclude_each_other(end, all[i]))
      entry.refuse("a second condition for the end of line " + std::to_string(all[i].line),
                   "one motion, or one load and one fix, for each end");
}

using Vessels = std::unordered_map<std::string, const VesselSpec*>;

// named_vessel(), found by name first: scenes may have thousands of rods.
const VesselSpec& vessel_of(const Field& name, const Vessels& by_name,
                            const std::vector<VesselSpec>& vessels) {
  const auto known = by_name.find(name.text("a vessel's name"));
  return known != by_name.end() ? *known->second : named_vessel(name, vessels);
}

EndCondition read_end(const Field& entry, const Vessels& by_name,
                      const std::vector<VesselSpec>& vessels) {
  entry.check_keys({"vessel", "end", "at", "hold", "rotate_deg", "move", "force", "moment",
                    "moment_frame", "fix", "section"});
  EndCondition end;
  end.line = entry.line();
  const Field name = entry.at("vessel", "a vessel's name");
  const VesselSpec& vessel = vessel_of(name, by_name, vessels);
  end.vessel = vessel.name;
  if (vessel.role == Role::obstacle)
    name.refuse("the obstacle " + in_quotes(vessel.name),
                "a deformable vessel, as obstacles never move");
  end.end = end_of(entry, vessel);
  if (const auto hold = entry.find("hold")) end.hold = hold->boolean();
  if (const auto rotate = entry.find("rotate_deg")) end.rotate_deg = rotate->vec3();
  if (const auto move = entry.find("move")) end.move = move->vec3();
  if (const auto force = entry.find("force")) end.force = force->vec3(largest_stiffness);
  if (const auto moment = entry.find("moment")) end.moment = moment->vec3(largest_stiffness);
  if (const auto frame = entry.find("moment_frame")) {
    end.moment_in_body = frame->one_of({"space", "body"}) == "body";
    if (!end.moment) frame->refuse("it without a moment", "a moment beside it");
  }
  if (const auto fix = entry.find("fix")) end.fix = read_fix(*fix);
  if (const auto section = entry.find("section"))
    end.soft_section = section->one_of({"rigid", "soft"}) == "soft";
  check_sense(entry, end);
  return end;
}

}  // namespace

EndSelector read_selector(const Field& end, const VesselSpec& vessel) {
  EndSelector selector;
  const std::string expected = ends_of(vessel);
  if (!end.is_map()) {
    if (end.is_list()) end.refuse(end.found(), expected);
    const std::string word = end.text(expected);
    if (word != "start" && word != "end") end.refuse(end.found(), expected);
    selector.kind = word == "start" ? EndSelector::Kind::start : EndSelector::Kind::end;
    return selector;
  }
  end.check_keys({"near", "at", "face"});
  const auto near = end.find("near"), at = end.find("at"), face = end.find("face");
  if (near.has_value() + at.has_value() + face.has_value() != 1) end.refuse(end.found(), expected);
  if (at) return read_place(*at, vessel);
  if (face) {
    if (vessel.rod) face->refuse("it on a bare rod", expected);
    selector.kind = EndSelector::Kind::face;
    selector.face = face->integer_in(0, 2'000'000'000);
    return selector;
  }
  selector.kind = EndSelector::Kind::near;
  selector.near = near->vec3();
  return selector;
}

std::vector<EndCondition> read_ends(const Field& field, const std::vector<VesselSpec>& vessels) {
  Vessels by_name;
  for (const VesselSpec& vessel : vessels) by_name.emplace(vessel.name, &vessel);
  std::vector<EndCondition> ends;
  std::unordered_map<std::string, std::vector<size_t>> ends_of;
  for (const Field& entry : field.list("a list of ends")) {
    EndCondition end = read_end(entry, by_name, vessels);
    std::vector<size_t>& before = ends_of[end.vessel];
    check_shared(entry, end, ends, before);
    before.push_back(ends.size());
    ends.push_back(std::move(end));
  }
  return ends;
}

}  // namespace vasorod
