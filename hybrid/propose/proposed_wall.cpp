#include "propose/proposed_wall.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <vector>

#include "data/sentence.h"

namespace vasorod {
namespace {

std::set<std::string> words_of(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  for (const char c : name + " ") {
    if (std::isalpha(static_cast<unsigned char>(c))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

bool has_any(const std::set<std::string>& words, const std::vector<std::string_view>& wanted) {
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](std::string_view one) { return words.contains(std::string(one)); });
}

// Wall over radius: ADAN-86 has 1.18 mm at 9.75 mm for the superior vena cava.
constexpr double thickness_over_radius = 0.12;
// Below this mean radius a vessel is taken for a child's.
constexpr double largest_child_radius = 6;  // mm

}  // namespace

VesselKind kind_of(const std::string& name) {
  const std::set<std::string> words = words_of(name);
  // A word for a branch outranks that for the whole: "pulmonary_vein" is no artery.
  if (has_any(words, {"vein", "veins", "inferior", "ivc"})) return VesselKind::other;
  if (has_any(words, {"svc", "vcs"}) || (words.contains("vena") && words.contains("cava")) ||
      words.contains("venacava"))
    return VesselKind::superior_vena_cava;
  if (has_any(words, {"pa", "rpa", "mpa", "pulmonary", "pulmonalis"}))
    return VesselKind::pulmonary_artery;
  if (has_any(words, {"aorta", "aortic", "ao"})) return VesselKind::aorta;
  return VesselKind::other;
}

std::string to_string(VesselKind kind) {
  switch (kind) {
    case VesselKind::superior_vena_cava:
      return "superior vena cava";
    case VesselKind::pulmonary_artery:
      return "pulmonary artery";
    case VesselKind::aorta:
      return "aorta";
    case VesselKind::other:
      break;
  }
  return "vessel";
}

ProposedWall propose_wall(VesselKind kind, double radius, double millimetres) {
  const bool child = radius * millimetres < largest_child_radius;
  ProposedWall wall;
  wall.thickness = std::stod(number_text(thickness_over_radius * radius, 2));
  const std::string thickness = "thickness: 0.12 of " + number_text(radius, 3) +
                                ", as in the ADAN-86 model (vena cava, 1.18 mm at 9.75 mm)";
  switch (kind) {
    case VesselKind::superior_vena_cava:
      wall.young = child ? 0.5 : 0.8;
      wall.source = thickness + "; young: " +
                    (child ? "models of children have 0.3 to 0.8 MPa" : "0.80 MPa there");
      return wall;
    case VesselKind::pulmonary_artery:
      wall.young = child ? 0.45 : 0.64;
      wall.source = thickness + "; young: " +
                    (child ? "models of children have 0.3 to 0.6 MPa"
                           : "0.64 +- 0.30 MPa along, 0.93 +- 0.34 MPa around (sheep, PMC5064828)");
      return wall;
    case VesselKind::aorta:
      wall.young = 0.4;
      wall.source = thickness + "; young: 0.40 MPa there (aorta)";
      return wall;
    case VesselKind::other:
      break;
  }
  wall.young = 0.5;
  wall.source = thickness + "; young: 0.3 to 0.8 MPa in models of great vessels";
  return wall;
}

}  // namespace vasorod
