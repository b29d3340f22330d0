#include "program/glenn_scene.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iomanip>
#include <yaml-cpp/yaml.h>

#include <vasorod/read_scene.h>

#include "obj_text.h"
#include "program/run_program.h"
#include "surface_file/read_surface.h"

namespace vasorod::testing {
namespace {

const std::filesystem::path cases =
    std::filesystem::path(VASOROD_SOURCE_DIR) / "benchmarks/cases/glenn";

nlohmann::json run_scene(const std::filesystem::path& scene, const std::string& options) {
  const ScratchFolder scratch;
  const auto run = run_program(
      vasorod("solve '" + scene.string() + "' -o '" + (scratch / "out").string() + "' " + options));
  EXPECT_LE(run.exit_code, 1) << run.err;
  const auto text = contents_of(scratch / "out" / "result.json");
  if (text.empty()) throw std::runtime_error("no result.json: " + run.err);
  return nlohmann::json::parse(text);
}

YAML::Node list_of(const Vec3& v) {
  YAML::Node node;
  for (int k = 0; k < 3; ++k) {
    std::ostringstream text;
    text << std::setprecision(17) << v[k];
    node.push_back(text.str());
  }
  return node;
}

Vec3 vec3_of(const YAML::Node& node) {
  return {node[0].as<double>(), node[1].as<double>(), node[2].as<double>()};
}

}  // namespace

nlohmann::json solve_case(const std::string& file, const std::string& options) {
  return run_scene(cases / file, options);
}

nlohmann::json solve_turned(const std::string& file, double rotation_deg,
                            const std::string& options, Left left) {
  const ScratchFolder scratch;
  YAML::Node yaml = YAML::LoadFile((cases / file).string());
  for (YAML::Node vessel : yaml["vessels"])
    vessel["surface"] = (cases / vessel["surface"].as<std::string>()).string();
  yaml["surgery"]["glenn"]["rotation_deg"] = rotation_deg;
  if (left == Left::out_contact) yaml["contact"] = YAML::Node(YAML::NodeType::Sequence);
  if (left == Left::out_pressure) {
    yaml["units"].remove("pressure");
    for (YAML::Node vessel : yaml["vessels"])
      for (const char* key : {"pressure", "axial_prestretch", "law"}) vessel.remove(key);
  }
  std::ofstream(scratch / "scene.yaml") << YAML::Dump(yaml);
  return run_scene(scratch / "scene.yaml", options);
}

nlohmann::json solve_glenn(const GlennScene& changed, const std::string& options) {
  const ScratchFolder scratch;
  const auto moved = [&](const Vec3& p) {
    return Vec3(changed.length_scale * (changed.motion * p));
  };
  const auto scaled = [](YAML::Node parent, const char* key, double factor) {
    if (!parent[key]) return;
    std::ostringstream text;
    text << std::setprecision(17) << factor * parent[key].as<double>();
    parent[key] = text.str();
  };
  const Scene scene = read_scene(cases / changed.file);
  YAML::Node yaml = YAML::LoadFile((cases / changed.file).string());
  yaml["units"]["length"] = changed.length_unit;
  yaml["units"]["stress"] = changed.stress_unit;
  for (size_t k = 0; k < scene.vessels.size(); ++k) {
    const VesselSpec& spec = scene.vessels[k];
    YAML::Node vessel = yaml["vessels"][k];
    TriangleSurface surface = load_surface(spec, scene).surface;
    for (int i = 0; i < surface.points.rows(); ++i)
      surface.points.row(i) = moved(surface.points.row(i).transpose()).transpose();
    std::ofstream(scratch / (spec.name + ".obj")) << obj_text(surface);
    vessel["surface"] = spec.name + ".obj";
    if (vessel["wall"]) {
      scaled(vessel["wall"], "thickness", changed.length_scale);
      scaled(vessel["wall"], "young", changed.stress_scale);
    }
  }
  for (YAML::Node end : yaml["ends"])
    if (end["end"].IsMap()) end["end"]["near"] = list_of(moved(vec3_of(end["end"]["near"])));
  YAML::Node glenn = yaml["surgery"]["glenn"];
  for (const char* pick : {"cut", "incision"}) glenn[pick] = list_of(moved(vec3_of(glenn[pick])));
  glenn["keep"]["near"] = list_of(moved(changed.keep.value_or(vec3_of(glenn["keep"]["near"]))));
  if (changed.rotation_deg) glenn["rotation_deg"] = *changed.rotation_deg;
  if (changed.incision_length) glenn["incision_length"] = *changed.incision_length;
  const auto file = scratch / "scene.yaml";
  std::ofstream(file) << YAML::Dump(yaml);
  return run_scene(file, options);
}

}  // namespace vasorod::testing
