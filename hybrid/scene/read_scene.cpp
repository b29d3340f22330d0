#include <algorithm>

#include "geometry/error.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

Fidelity fidelity_of(const std::string& word) {
  return word == "rod"     ? Fidelity::rod
         : word == "skin"  ? Fidelity::skin
         : word == "paper" ? Fidelity::paper
                           : Fidelity::coupled;
}

void read_fidelity(const Field& root, Scene& scene) {
  const auto fidelity = root.find("fidelity");
  if (fidelity) scene.fidelity = fidelity_of(fidelity->one_of({"rod", "skin", "paper", "coupled"}));
  if (const auto accuracy = root.find("accuracy")) {
    scene.accuracy = accuracy->positive();
    if (*scene.accuracy >= 1)
      accuracy->refuse(accuracy->found(), "an RMS distance over R above 0 and below 1");
  }
  if (!scene.fidelity && !scene.accuracy)
    root.refuse("neither fidelity nor accuracy",
                "fidelity: rod, skin, paper or coupled, or accuracy: a number");
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.rod && scene.fidelity && scene.fidelity != Fidelity::rod)
      fidelity->refuse(fidelity->found() + " with the bare rod " + in_quotes(vessel.name),
                       "rod, as it has no surface");
}

}  // namespace

std::string to_string(Role role) {
  return role == Role::obstacle ? "obstacle" : "deformable";
}

std::string to_string(Fidelity fidelity) {
  switch (fidelity) {
    case Fidelity::rod:
      return "rod";
    case Fidelity::skin:
      return "skin";
    case Fidelity::paper:
      return "paper";
    case Fidelity::coupled:
      break;
  }
  return "coupled";
}

std::string to_string(SurfaceIs is) {
  return is == SurfaceIs::mid ? "mid" : is == SurfaceIs::outer ? "outer" : "inner";
}

std::string to_string(Law law) {
  return law == Law::biot ? "biot" : "svk";
}

const VesselSpec& Scene::vessel(const std::string& vessel_name) const {
  for (const VesselSpec& candidate : vessels)
    if (candidate.name == vessel_name) return candidate;
  throw InputError(file.string() + ": found no vessel " + in_quotes(vessel_name) +
                   ", expected one of the scene's");
}

Units read_units(const Field& field) {
  field.check_keys({"length", "stress"});
  Units units;
  units.length = field.at("length", "mm, cm or m").one_of({"mm", "cm", "m"});
  units.stress = field.at("stress", "Pa, kPa or MPa").one_of({"Pa", "kPa", "MPa"});
  units.metres = units.length == "mm" ? 1e-3 : units.length == "cm" ? 1e-2 : 1;
  units.pascals = units.stress == "MPa" ? 1e6 : units.stress == "kPa" ? 1e3 : 1;
  return units;
}

Scene read_scene(const std::filesystem::path& file, const ReadOptions& options) {
  const Field root = read_yaml(file.string());
  root.check_keys(
      {"scene", "units", "vessels", "ends", "contact", "surgery", "fidelity", "accuracy", "explore", "extrapolate",
       "study"});  // study: notes for the comparison's driver, not read here
  Scene scene;
  scene.file = file;
  scene.name = root.at("scene", "the scene's name").text("the scene's name");
  scene.units = read_units(root.at("units", "{length: mm, stress: MPa} or other units"));
  scene.vessels = read_vessels(root.at("vessels", "a list of vessels"), file.parent_path(), options);
  if (const auto ends = root.find("ends")) scene.ends = read_ends(*ends, scene.vessels);
  if (const auto contact = root.find("contact")) scene.contact = read_contact(*contact, scene.vessels);
  if (const auto surgery = root.find("surgery")) {
    surgery->check_keys({"glenn"});
    scene.glenn = read_glenn(surgery->at("glenn", "the operation"), scene.vessels);
  }
  read_fidelity(root, scene);
  if (const auto extrapolate = root.find("extrapolate")) {
    scene.extrapolate = extrapolate->boolean();
    for (const VesselSpec& vessel : scene.vessels)
      if (scene.extrapolate && !vessel.rod)
        extrapolate->refuse("it with the vessel '" + vessel.name + "'", "it in a scene of bare rods alone");
  }
  if (const auto explore = root.find("explore")) {
    scene.explore = read_explore(*explore);
    if (!scene.glenn) explore->refuse("it without surgery.glenn", "an operation to explore");
  }
  return scene;
}

}  // namespace vasorod
