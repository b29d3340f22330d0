#include <algorithm>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "data/mmhg.h"
#include "scene/read_parts.h"

namespace vasorod {

namespace {

void read_fidelity(const Field& root, Scene& scene) {
  const auto fidelity = root.find("fidelity");
  if (fidelity) {
    scene.fidelity = fidelity->text("the name of a fidelity");
    scene.fidelity_line = fidelity->line();
  }
  if (const auto accuracy = root.find("accuracy")) {
    if (fidelity)
      accuracy->refuse("it beside fidelity", "one of the two, as accuracy chooses the fidelity");
    scene.accuracy = accuracy->positive();
    if (*scene.accuracy >= 1)
      accuracy->refuse(accuracy->found(), "an RMS distance over R above 0 and below 1");
  }
  if (!scene.fidelity && !scene.accuracy)
    root.refuse("neither fidelity nor accuracy",
                "fidelity: the name of one, or accuracy: a number");
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.rod && scene.fidelity && scene.fidelity != "rod")
      fidelity->refuse(fidelity->found() + " with the bare rod " + in_quotes(vessel.name),
                       "rod, as it has no surface");
}

// One unit of the scene's pressures in stress units.
double pressure_unit(const Field& field, const Units& units) {
  const auto unit = field.find("pressure");
  if (!unit) return 1;
  return pascals_per(unit->one_of({"mmHg", "Pa", "kPa", "MPa"})) / units.pascals;
}

}  // namespace

Units read_units(const Field& field) {
  field.check_keys({"length", "stress", "pressure"});
  Units units;
  units.length = field.at("length", "mm, cm or m").one_of({"mm", "cm", "m"});
  units.stress = field.at("stress", "Pa, kPa or MPa").one_of({"Pa", "kPa", "MPa"});
  units.metres = units.length == "mm" ? 1e-3 : units.length == "cm" ? 1e-2 : 1;
  units.pascals = pascals_per(units.stress);
  return units;
}

namespace {

// `folder`: where the paths of surfaces and markups begin.
Scene scene_of(const Field& root, const std::filesystem::path& folder) {
  root.check_keys({"scene", "units", "vessels", "ends", "contact", "surgery", "fidelity",
                   "accuracy", "explore", "extrapolate",
                   "study"});  // study: notes for the comparison's driver, not read here
  Scene scene;
  scene.name = root.at("scene", "the scene's name").text("the scene's name");
  const Field units = root.at("units", "{length: mm, stress: MPa} or other units");
  scene.units = read_units(units);
  scene.vessels = read_vessels(root.at("vessels", "a list of vessels"), folder,
                               pressure_unit(units, scene.units));
  if (const auto ends = root.find("ends")) scene.ends = read_ends(*ends, scene.vessels);
  if (const auto contact = root.find("contact"))
    scene.contact = read_contact(*contact, scene.vessels);
  if (const auto surgery = root.find("surgery")) {
    surgery->check_keys({"glenn", "end_to_end"});
    const auto glenn = surgery->find("glenn"), end_to_end = surgery->find("end_to_end");
    if (glenn.has_value() == end_to_end.has_value())
      surgery->refuse(glenn ? "both glenn and end_to_end" : "neither glenn nor end_to_end",
                      "one operation");
    if (glenn) scene.glenn = read_glenn(*glenn, scene.vessels, folder, scene.units);
    if (end_to_end)
      scene.end_to_end = read_end_to_end(*end_to_end, scene.vessels, folder, scene.units);
  }
  read_fidelity(root, scene);
  if (const auto explore = root.find("explore")) {
    if (!scene.glenn)
      explore->refuse("it without surgery: glenn", "the operation whose options it lists");
    scene.explore = read_explore(*explore, scene.vessels);
  }
  if (const auto extrapolate = root.find("extrapolate")) {
    scene.extrapolate = extrapolate->boolean();
    for (const VesselSpec& vessel : scene.vessels)
      if (scene.extrapolate && !vessel.rod)
        extrapolate->refuse("it with the vessel '" + vessel.name + "'",
                            "it in a scene of bare rods alone");
  }
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  std::string text = scene_file_text(file.string());
  Scene scene = scene_of(read_yaml(file.string(), text), file.parent_path());
  scene.file = file;
  scene.text = std::move(text);
  return scene;
}

Scene read_scene_text(const std::string& text, const std::filesystem::path& folder) {
  Scene scene = scene_of(read_yaml("", text), folder);
  scene.text = text;
  // There is no file in which these would be lines.
  for (VesselSpec& vessel : scene.vessels) vessel.line = 0;
  for (EndCondition& end : scene.ends) end.line = 0;
  if (scene.glenn) scene.glenn->line = 0;
  if (scene.end_to_end) {
    scene.end_to_end->line = 0;
    for (RimSpec& rim : scene.end_to_end->rims) rim.line = 0;
  }
  if (scene.explore) scene.explore->line = 0;
  scene.fidelity_line = 0;
  return scene;
}

std::vector<std::filesystem::path> input_files(const Scene& scene) {
  std::vector<std::filesystem::path> files;
  if (!scene.file.empty()) files.push_back(scene.file);
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface) files.push_back(*vessel.surface);
  for (const PickSpec* pick : scene.picks())
    if (!pick->markup.empty()) files.push_back(pick->markup);
  return files;
}

}  // namespace vasorod
