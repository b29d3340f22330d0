#include "propose/scene_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "data/index.h"
#include "data/sentence.h"
#include "vessel/name_ends.h"

namespace vasorod {
namespace {

std::string vector_text(const Vec3& v) {
  std::string text = "[";
  for (int k = 0; k < 3; ++k)
    text += (k > 0 ? ", " : "") + number_text(std::abs(v[k]) < 1e-9 ? 0.0 : v[k], 6);
  return text + "]";
}

// To the decimal digit of `step`.
Vec3 rounded(const Vec3& v, double step) {
  const double digit = std::pow(10, std::floor(std::log10(step)));
  return v.unaryExpr([&](double x) { return digit * std::round(x / digit); });
}

double length_of(const RodTree& rod) {
  double length = 0;
  for (const RodElement& element : rod.elements) length += element.length;
  return length;
}

std::string vessel_text(const ProposedVessel& one, const std::string& unit) {
  const VesselSpec& spec = one.spec;
  std::string text = "  - name: " + yaml_text(spec.name) + "\n";
  text += "    surface: " + yaml_text(one.surface) + "\n";
  if (spec.role == Role::obstacle)
    return text +
           "    role: obstacle         # closed, no open end: it never moves, only touched\n";
  const auto [least, most] =
      std::minmax_element(one.vessel.rod.radius.begin(), one.vessel.rod.radius.end());
  text += "    # " +
          (one.kind == VesselKind::other ? std::string("not recognised by its name")
                                         : to_string(one.kind) + ", by its name") +
          "; length " + number_text(length_of(one.vessel.rod), 4) + ", radius " +
          number_text(*least, 3) + " to " + number_text(*most, 3) + " " + unit + "\n";
  text +=
      "    surface_is: outer      # decide: outer, mid, or inner as of a lumen full of contrast\n";
  if (spec.remesh)
    text +=
        "    remesh: " + number_text(*spec.remesh, 3) + "            # " + one.remesh_reason + "\n";
  const size_t young = one.wall_source.find("; ");
  text += "    # " + one.wall_source.substr(0, young) + "\n";
  if (young != std::string::npos) text += "    # " + one.wall_source.substr(young + 2) + "\n";
  text += "    wall: {thickness: " + number_text(spec.wall->thickness, 6) +
          ", young: " + number_text(spec.wall->material.young_axial, 6) +
          ", poisson: " + number_text(spec.wall->material.poisson_tt, 6) + "}   # decide\n";
  return text;
}

std::string ends_text(const ProposedVessel& one, const std::string& unit) {
  std::string text;
  for (size_t k = 0; k < one.vessel.ends.size(); ++k) {
    const VesselEnd& end = one.vessel.ends[k];
    text += "  - {vessel: " + yaml_text(one.spec.name) +
            ", end: " + yaml_of(selector_of(one.vessel, static_cast<int>(k))) + ", hold: true}\n";
    const double radius = one.vessel.rod.radius[index(end.node)];
    text += "    # centre " + vector_text(rounded(end.center, 1e-3 * radius)) + ", radius " +
            number_text(radius, 3) + " " + unit + ", normal " +
            vector_text(rounded(end.outward, 1e-2)) +
            (end.face.empty() ? "" : ", ModelFaceID " + end.face) + "\n";
  }
  return text;
}

std::string surgery_text(const GlennSpec& glenn, const std::string& keep_reason) {
  std::string text = "surgery:\n  glenn:                   # a bidirectional Glenn shunt\n";
  text += "    svc: " + yaml_text(glenn.svc) + "\n    rpa: " + yaml_text(glenn.rpa) + "\n";
  text +=
      "    # decide: a first place that fits, not a recommendation. A pick may also be a point\n"
      "    # [x, y, z], or {markup: FILE, label: TEXT} of 3D Slicer.\n";
  text += "    cut: {along: " + number_text(*glenn.cut.along, 4) +
          "}                  # of the vein's axis, from the kept end\n";
  text += "    incision: {along: " + number_text(*glenn.incision.along, 4) +
          ", around_deg: " + number_text(glenn.incision.around_deg, 4) +
          (glenn.incision.to ? ", to: " + yaml_of(*glenn.incision.to) : std::string()) + "}\n";
  text += "    rotation_deg: auto\n";
  text += "    keep: " + yaml_of(glenn.keep) + "   # decide: " + keep_reason + "\n";
  return text;
}

}  // namespace

std::string yaml_of(const EndSelector& end) {
  if (end.kind == EndSelector::Kind::start) return "start";
  if (end.kind == EndSelector::Kind::end) return "end";
  if (end.kind == EndSelector::Kind::face) return "{face: " + std::to_string(end.face) + "}";
  return "{near: " + vector_text(end.near) + "}";
}

std::string yaml_text(const std::string& text) {
  const char first = text.empty() ? ' ' : text.front();
  const bool plain = (std::isalnum(static_cast<unsigned char>(first)) != 0 || first == '.' ||
                      first == '/' || first == '_') &&
                     text != "null" && text != "Null" && text != "NULL" &&
                     std::all_of(text.begin(), text.end(), [](char c) {
                       return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
                              c == '.' || c == '/' || c == '-';
                     });
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 32 || byte == 127) {
      char escape[5];
      std::snprintf(escape, sizeof escape, "\\x%02X", byte);
      quoted += escape;
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

std::string scene_text(const Scene& scene, const std::vector<ProposedVessel>& vessels,
                       const std::string& unit_reason, const std::string& keep_reason) {
  std::string text =
      "# Proposed by `vasorod init` from the surfaces alone. Look at every line that says decide.\n"
      "# Research use only, not for clinical use.\n";
  text += "scene: " + yaml_text(scene.name) + "\n";
  text += "units: {length: " + scene.units.length + ", stress: " + scene.units.stress + "}   # " +
          unit_reason + "\n";
  text += "vessels:\n";
  for (const ProposedVessel& one : vessels) text += vessel_text(one, scene.units.length);
  text += "ends:                      # all held as they are: tissue and vessels go on there\n";
  for (const ProposedVessel& one : vessels) text += ends_text(one, scene.units.length);
  if (scene.glenn) text += surgery_text(*scene.glenn, keep_reason);
  text += "fidelity: skin             # quick, to try picks; `coupled` models walls and contact\n";
  return text;
}

}  // namespace vasorod
