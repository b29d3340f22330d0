#include <algorithm>
#include <set>
#include <unordered_map>

#include <vasorod/read_scene.h>

#include "data/part_names.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

std::vector<std::string> names_of(const std::vector<VesselSpec>& vessels) {
  std::vector<std::string> names;
  names.reserve(vessels.size());
  for (const VesselSpec& vessel : vessels) names.push_back(vessel.name);
  return names;
}

bool good_name(const std::string& name) {
  return !name.empty() && name.size() <= 100 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

Coefficients read_coefficients(const Field& field) {
  field.check_keys({"binding", "bending", "stretching"});
  // Only the binding ties the surface to the rod; the other two terms may be zero.
  return {field.at("binding", "k_c").stiffness(),
          field.at("bending", "k_b").not_negative(largest_stiffness),
          field.at("stretching", "k_s").not_negative(largest_stiffness)};
}

void read_shape(const Field& field, const std::filesystem::path& folder, VesselSpec& vessel) {
  int shapes = 0;
  for (const char* shape : {"surface", "tube", "rod"}) shapes += field.has(shape) ? 1 : 0;
  if (shapes != 1)
    field.refuse(
        shapes == 0 ? "none of surface, tube and rod" : "more than one of surface, tube and rod",
        "exactly one");
  if (const auto surface = field.find("surface")) {
    const std::filesystem::path path = surface->text("the name of a VTP, STL, PLY or OBJ file");
    vessel.surface = path.is_absolute() ? path : folder / path;
  }
  if (const auto tube = field.find("tube")) {
    vessel.tube = read_tube(*tube);
    vessel.surface_is = SurfaceIs::mid;
  }
  if (const auto rod = field.find("rod")) vessel.rod = read_rod(*rod);
  for (const char* key : {"remesh", "surface_is", "check"})
    if (const auto found = field.find(key); found && !vessel.surface)
      found->refuse("it on a vessel without a surface file", "it beside surface only");
  if (const auto remesh = field.find("remesh")) vessel.remesh = remesh->length();
  if (const auto check = field.find("check")) vessel.check = check->boolean();
  if (const auto is = field.find("surface_is")) {
    const std::string word = is->one_of({"mid", "outer", "inner"});
    vessel.surface_is = word == "mid"     ? SurfaceIs::mid
                        : word == "outer" ? SurfaceIs::outer
                                          : SurfaceIs::inner;
  }
}

void read_law(const Field& field, Material& material) {
  std::vector<std::string> names;
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean}) names.push_back(to_string(law));
  const std::string name = field.one_of(names);
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean})
    if (name == to_string(law)) material.law = law;
  if (const auto fault = fault_of(material)) field.refuse(fault->found, fault->expected);
}

void read_material(const Field& field, VesselSpec& vessel) {
  if (vessel.rod) {
    for (const char* key : {"wall", "law", "coefficients", "pressure", "axial_prestretch"})
      if (const auto found = field.find(key))
        found->refuse("it on a bare rod", "the stiffness of the rod's pieces instead");
    if (vessel.role == Role::obstacle)
      field.at("role", "").refuse("obstacle", "a surface or a tube for an obstacle");
    return;
  }
  if (const auto wall = field.find("wall")) {
    vessel.wall = read_wall(*wall);
  } else if (vessel.role == Role::deformable) {
    field.at("wall", "the wall of a deformable vessel");
  }
  if (const auto law = field.find("law")) {
    if (!vessel.wall) law->refuse("it on a vessel without a wall", "it beside wall only");
    read_law(*law, vessel.wall->material);
  }
  if (const auto coefficients = field.find("coefficients"))
    vessel.coefficients = read_coefficients(*coefficients);
  if (vessel.tube && vessel.tube->end_thickness && !vessel.wall)
    field.at("tube", "")
        .at("end_thickness", "")
        .refuse("it without a wall", "wall.thickness for the tube's start");
  if (vessel.tube && vessel.wall) {
    const TubeSpec& tube = *vessel.tube;
    if (vessel.wall->thickness > tube.radius ||
        tube.end_thickness.value_or(vessel.wall->thickness) > tube.end_radius.value_or(tube.radius))
      field.refuse("a wall thicker than the tube's mid-wall radius",
                   "one at most as thick, so that a lumen is left");
  }
}

// What the lumen and the wall carried when the vessel was seen, and afterwards.
void read_seen_state(const Field& field, double pressure_unit, VesselSpec& vessel) {
  const auto pressure = field.find("pressure");
  const auto stretch = field.find("axial_prestretch");
  for (const auto& key : {pressure, stretch})
    if (key && vessel.role == Role::obstacle)
      key->refuse("it on an obstacle", "it on deformable vessels, as an obstacle never moves");
  if (stretch) vessel.axial_prestretch = stretch->number_in(0.5, 2);
  if (!pressure) return;
  pressure->check_keys({"scan", "after"});
  LumenPressure& both = vessel.pressure.emplace();
  if (const auto scan = pressure->find("scan"))
    both.scan = pressure_unit * scan->not_negative(largest_stiffness);
  if (const auto after = pressure->find("after"))
    both.after = pressure_unit * after->number_up_to(largest_stiffness);
}

VesselSpec read_vessel(const Field& field, const std::filesystem::path& folder,
                       double pressure_unit) {
  VesselSpec vessel;
  field.check_keys({"name", "surface", "tube", "rod", "remesh", "surface_is", "check", "wall",
                    "law", "coefficients", "role", "pressure", "axial_prestretch"});
  const Field name = field.at("name", "the vessel's name");
  vessel.name = name.text("a name of letters, digits, _ and -");
  vessel.line = field.line();
  if (!good_name(vessel.name)) name.refuse(name.found(), "at most 100 letters, digits, _ and -");
  const Field named = field.renamed("vessels." + vessel.name);
  if (const auto role = named.find("role"))
    vessel.role =
        role->one_of({"deformable", "obstacle"}) == "obstacle" ? Role::obstacle : Role::deformable;
  read_shape(named, folder, vessel);
  read_material(named, vessel);
  read_seen_state(named, pressure_unit, vessel);
  return vessel;
}

// A result has NAME.vtp, NAME_stump.vtp and NAME_centerline.vtp. These must differ between vessels.
void check_names(const std::vector<Field>& fields, const std::vector<VesselSpec>& vessels) {
  std::set<std::string> taken;
  for (const VesselSpec& vessel : vessels) {
    taken.insert(stump_name(vessel.name));
    taken.insert(centerline_name(vessel.name));
  }
  std::set<std::string> seen;
  for (size_t i = 0; i < vessels.size(); ++i) {
    const Field name = fields[i].at("name", "");
    if (!seen.insert(vessels[i].name).second)
      name.refuse(in_quotes(vessels[i].name) + " a second time", "a name no other vessel has");
    if (taken.contains(vessels[i].name))
      name.refuse(in_quotes(vessels[i].name),
                  "a name that is not another vessel's with _stump or _centerline behind it");
  }
}

// Every parent is another rod of the scene, and no chain of parents closes to a ring. Chains that
// share a part walk it once, so that thousands of rods cost no more than their number.
void check_parents(const std::vector<Field>& fields, const std::vector<VesselSpec>& vessels) {
  std::unordered_map<std::string, size_t> rods;
  for (size_t i = 0; i < vessels.size(); ++i)
    if (vessels[i].rod) rods.emplace(vessels[i].name, i);
  const auto refuse = [&](size_t i, const std::string& found, const std::string& expected) {
    fields[i]
        .at("rod", "")
        .at("parent", "")
        .renamed("vessels." + vessels[i].name + ".rod.parent")
        .refuse(found, expected);
  };
  enum class Chain : char { unknown, open, ends };
  std::vector<Chain> chain(vessels.size(), Chain::unknown);
  for (size_t i = 0; i < vessels.size(); ++i) {
    std::vector<size_t> walked;
    for (size_t at = i; chain[at] != Chain::ends;) {
      if (chain[at] == Chain::open)
        refuse(i, "a ring of parents", "a tree of rods, as closed loops are not modelled");
      chain[at] = Chain::open;
      walked.push_back(at);
      if (!vessels[at].rod || !vessels[at].rod->parent) break;
      const auto next = rods.find(*vessels[at].rod->parent);
      if (next == rods.end())
        refuse(at, in_quotes(*vessels[at].rod->parent), "the name of another rod of this scene");
      at = next->second;
    }
    for (const size_t at : walked) chain[at] = Chain::ends;
  }
}

}  // namespace

const VesselSpec& named_vessel(const Field& name, const std::vector<VesselSpec>& vessels) {
  const std::string wanted = name.text("a vessel's name");
  for (const VesselSpec& vessel : vessels)
    if (vessel.name == wanted) return vessel;
  const auto names = names_of(vessels);
  const auto meant = nearest_word(wanted, names);
  name.refuse("the unknown vessel " + in_quotes(wanted), meant ? in_quotes(*meant) : listed(names));
}

std::vector<VesselSpec> read_vessels(const Field& field, const std::filesystem::path& folder,
                                     double pressure_unit) {
  const auto fields = field.list("a list of vessels");
  if (fields.empty()) field.refuse(field.found(), "at least one vessel");
  std::vector<VesselSpec> vessels;
  vessels.reserve(fields.size());
  for (const Field& one : fields) vessels.push_back(read_vessel(one, folder, pressure_unit));
  check_names(fields, vessels);
  check_parents(fields, vessels);
  return vessels;
}

std::vector<std::array<std::string, 2>> read_contact(const Field& field,
                                                     const std::vector<VesselSpec>& vessels) {
  std::vector<std::array<std::string, 2>> pairs;
  std::set<std::set<std::string>> seen;
  for (const Field& pair : field.list("a list of pairs of vessels")) {
    const auto names = pair.list("two vessels");
    if (names.size() != 2) pair.refuse(pair.found(), "two vessels");
    const VesselSpec& a = named_vessel(names[0], vessels);
    const VesselSpec& b = named_vessel(names[1], vessels);
    if (&a == &b)
      pair.refuse(
          in_quotes(a.name) + " twice",
          "two different vessels, as this list does not choose whether a vessel touches itself");
    for (size_t k = 0; k < 2; ++k)
      if ((k == 0 ? a : b).rod)
        names[k].refuse("the bare rod " + names[k].found(), "a vessel with a surface");
    if (a.role == Role::obstacle && b.role == Role::obstacle)
      pair.refuse("two obstacles", "at least one deformable vessel, as obstacles never move");
    if (!seen.insert({a.name, b.name}).second)
      pair.refuse("the same pair a second time", "it once");
    pairs.push_back({a.name, b.name});
  }
  return pairs;
}

}  // namespace vasorod
