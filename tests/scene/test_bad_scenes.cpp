// Scenes whose parts must be refused with one sentence, operations apart.
#include "bad_scene.h"

namespace vasorod {
namespace {

using testing::Bad;
using testing::BadScene;
using testing::base;
using testing::refusal;

const std::vector<Bad> bads = {
    {"unknown_key",
     "fidelity: paper",
     "fidelty: paper",
     {":16:", "fidelty", "expected \"fidelity\""}},
    {"unknown_key_in_wall", "young: 1.0", "yuong: 1.0", {":6:", "vessels.tube.wall", "\"young\""}},
    {"unknown_key_far_from_any", "thickness: 1.0", "zzzzzzzzz: 1.0", {"thickness, young, poisson"}},
    {"double_key", "fidelity: paper", "fidelity: paper\nfidelity: rod", {":17:", "a second time"}},
    {"no_units", "units: {length: mm, stress: MPa}\n", "", {"units: found nothing"}},
    {"unit_inch", "length: mm", "length: inch", {":2:", "\"inch\"", "mm, cm or m"}},
    {"no_vessels", "contact:", "vessels: []\ncontact:", {"a second time"}},
    {"vessels_a_word", "vessels:\n", "vessels: none\nx:\n", {}},
    {"young_zero",
     "young: 1.0",
     "young: 0",
     {":6:", "vessels.tube.wall.young", "found 0", "above 0"}},
    {"young_negative", "young: 1.0", "young: -1", {"found -1"}},
    {"young_word", "young: 1.0", "young: soft", {"\"soft\"", "a number"}},
    {"young_quoted", "young: 1.0", "young: \"1.0\"", {"the text \"1.0\""}},
    {"young_list", "young: 1.0", "young: [1.0]", {"a list of 1"}},
    {"young_nan", "young: 1.0", "young: .nan", {".nan"}},
    {"young_infinite", "young: 1.0", "young: 1e999", {"1e999"}},
    {"young_missing", "young: 1.0, ", "", {"wall.young: found nothing"}},
    {"young_empty", "young: 1.0", "young: ", {"wall.young: found nothing"}},
    {"thickness_zero", "thickness: 1.0", "thickness: 0.0", {"wall.thickness", "found 0"}},
    {"thickness_negative", "thickness: 1.0", "thickness: -0.5", {"found -0.5"}},
    {"thickness_fills_lumen", "thickness: 1.0", "thickness: 20", {"lumen"}},
    {"poisson_too_large", "poisson: 0.3", "poisson: 0.51", {"0.51", "at most 0.5"}},
    {"poisson_too_small", "poisson: 0.3", "poisson: -1", {"above -1"}},
    {"not_admissible",
     "poisson: 0.3",
     "shear: 0.4, transverse: {young: 4, poisson: 0.3, coupling: 0.3}",
     {"1 - nu_TT - 2 nu_LT^2 E_T/E_L = -0.02", "not negative"}},
    {"transverse_without_shear",
     "poisson: 0.3",
     "transverse: {poisson: 0.3}",
     {"wall.shear: found nothing"}},
    {"transverse_and_poisson",
     "poisson: 0.3",
     "poisson: 0.3, shear: 1, transverse: {poisson: 0.3}",
     {"beside"}},
    {"name_twice", "name: other", "name: tube", {":7:", "a second time"}},
    {"name_with_space", "name: other", "name: the other", {"letters, digits, _ and -"}},
    {"name_with_path", "name: other", "name: ../x", {"letters, digits, _ and -"}},
    {"name_of_anothers_file", "name: other", "name: tube_stump", {"_stump"}},
    {"two_shapes",
     "tube: {length: 100, radius: 10}",
     "tube: {length: 100, radius: 10}\n    surface: a.vtp",
     {"more than one of surface, tube and rod"}},
    {"no_shape", "    tube: {length: 100, radius: 10}\n", "", {"none of surface, tube and rod"}},
    {"no_wall",
     "    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}\n",
     "",
     {"vessels.tube.wall: found nothing"}},
    {"tube_radius_negative", "radius: 10", "radius: -10", {":5:", "vessels.tube.tube.radius"}},
    {"tube_around_fraction", "radius: 10", "radius: 10, around: 40.5", {"whole number"}},
    {"tube_around_huge", "radius: 10", "radius: 10, around: 1e9", {"from 6 to 5000"}},
    {"tube_bent_into_itself", "radius: 10", "radius: 20, bend_deg: 300", {"meets itself"}},
    {"tube_bent_full_circle", "radius: 10", "radius: 1, bend_deg: 400", {"below 360"}},
    {"tube_normal_along_tangent",
     "radius: 10",
     "radius: 10, tangent: [1, 0, 0]",
     {"at 0 degrees", "90 degrees"}},
    {"tube_no_tangent",
     "radius: 10",
     "radius: 10, tangent: [0, 0, 0]",
     {"[0, 0, 0]", "a direction"}},
    {"remesh_of_a_tube",
     "radius: 10}",
     "radius: 10}\n    remesh: 1",
     {"vessels.tube.remesh", "beside surface only"}},
    {"pressure_of_one_number",
     "radius: 10}",
     "radius: 10}\n    pressure: 0.01",
     {"vessels.tube.pressure", "0.01"}},
    {"pressure_below_zero_in_the_scan",
     "radius: 10}",
     "radius: 10}\n    pressure: {scan: -5, after: 5}",
     {"vessels.tube.pressure.scan", "-5", "at least 0"}},
    {"pressure_of_an_obstacle",
     "radius: 10}",
     "radius: 10}\n    role: obstacle\n    pressure: {after: 5}",
     {"vessels.tube.pressure", "obstacle"}},
    {"prestretch_of_a_half",
     "radius: 10}",
     "radius: 10}\n    axial_prestretch: 0.4",
     {"vessels.tube.axial_prestretch", "0.4", "0.5"}},
    {"pressure_unit", "stress: MPa", "stress: MPa, pressure: atm", {"units.pressure", "mmHg"}},
    {"law_unknown", "radius: 10}", "radius: 10}\n    law: hooke", {"biot, svk or neo-hookean"}},
    {"law_of_a_fibred_wall",
     "poisson: 0.3}",
     "poisson: 0.3, shear: 0.1}\n    law: neo-hookean",
     {"vessels.tube.law", "transversely isotropic", "biot or svk"}},
    {"law_with_negative_nu",
     "poisson: 0.3}",
     "poisson: -0.1}\n    law: neo-hookean",
     {"nu = -0.1", "0 <= nu <= 0.5"}},
    {"binding_zero",
     "radius: 10}",
     "radius: 10}\n    coefficients: {binding: 0, bending: 1, stretching: 1}",
     {"coefficients.binding"}},
    {"role_unknown", "radius: 10}", "radius: 10}\n    role: fixed", {"deformable or obstacle"}},
    {"end_of_obstacle",
     "radius: 10}",
     "radius: 10}\n    role: obstacle",
     {"ends[0].vessel", "obstacles never move"}},
    {"end_unknown_vessel",
     "{vessel: tube, end: start",
     "{vessel: tub, end: start",
     {":11:", "\"tub\"", "\"tube\""}},
    {"end_unknown", "end: start", "end: middle", {"\"middle\"", "start, end, {near"}},
    {"end_near_two", "end: start", "end: {near: [1, 2]}", {"a list of 2", "three numbers"}},
    {"end_at_on_tube", "end: start", "at: 0.5", {"a vessel with a surface"}},
    {"end_missing", "end: start, ", "", {"end: found nothing"}},
    {"end_nothing_done", ", hold: true", "", {"without a condition"}},
    {"end_hold_word", "hold: true", "hold: yes please", {"true or false"}},
    {"end_held_and_loaded",
     "hold: true",
     "hold: true, force: [0, 0, 1]",
     {"either a motion or a load"}},
    {"end_twice", "end: end, move", "end: start, move", {":12:", "line 11"}},
    {"end_fix_unknown", "hold: true", "fix: [x, w]", {"\"w\"", "x, y, z, rx, ry or rz"}},
    {"end_fix_twice", "hold: true", "fix: [x, x]", {"a second time"}},
    {"end_frame_alone", "hold: true", "hold: true, moment_frame: body", {"without a moment"}},
    {"end_section_unknown", "hold: true", "hold: true, section: hard", {"rigid or soft"}},
    {"move_word", "move: [1, 0, 0]", "move: [1, 0, up]", {"ends[1].move[2]", "\"up\""}},
    {"contact_with_itself", "[[tube, other]]", "[[tube, tube]]", {"two different vessels"}},
    {"contact_unknown",
     "[[tube, other]]",
     "[[tube, aorta]]",
     {":13:", "\"aorta\"", "tube or other"}},
    {"contact_twice", "[[tube, other]]", "[[tube, other], [other, tube]]", {"a second time"}},
    {"contact_three", "[[tube, other]]", "[[tube, other, tube]]", {"two vessels"}},
    {"fidelity_no_name", "fidelity: paper", "fidelity: [paper]", {"the name of a fidelity"}},
    {"fidelity_and_accuracy",
     "fidelity: paper",
     "fidelity: paper\naccuracy: 0.1",
     {":17:", "one of the two"}},
    {"fidelity_missing", "fidelity: paper\n", "", {"neither fidelity nor accuracy"}},
    {"accuracy_zero", "fidelity: paper", "accuracy: 0", {":16:", "above 0"}},
    {"accuracy_above_one", "fidelity: paper", "accuracy: 2", {"below 1"}},
    {"explore",
     "fidelity: paper",
     "fidelity: paper\nexplore: {cut: 0.5}",
     {":17:", "unknown key \"cut\""}},
    {"second_document", "fidelity: paper", "---\nfidelity: paper", {"second YAML document"}},
    {"yaml_syntax", "units: {length: mm", "units: {length: mm, {", {":2:", "YAML"}},
    {"yaml_indent", "ends:", " ends:", {"YAML"}},
    {"yaml_tab", "    wall:", "\twall:", {":6:", "a tab", "YAML"}},
    {"yaml_tab_behind_spaces", "    wall:", "   \twall:", {":6:", "a tab"}},
    {"yaml_comma_behind", "scene: bad", "{scene: bad},", {":1:", "a stray \",\" in column 13"}},
    {"yaml_control_byte", "scene: bad", "scene: b\x01", {":1:", "the control byte 0x01"}},
    {"yaml_escape_byte", "scene: bad", "scene: \x1b[2J", {":1:", "the control byte 0x1b"}},
    {"yaml_ring", "scene: bad", "scene: &a [*a]", {":1:", "alias within"}},
    {"escaped_in_the_sentence", "{length: mm", R"({length: "\e\n")", {R"("\x1b\n")"}},
    {"young_too_large", "young: 1.0", "young: 1e31", {"wall.young: found 1e+31", "1e+30"}},
    {"young_denormal", "young: 1.0", "young: 1e-320", {"wall.young: found ", "1e-30"}},
    {"thickness_denormal", "thickness: 1.0", "thickness: 1e-320", {"thickness: found ", "1e-09"}},
    {"tube_too_long", "length: 100", "length: 1e12", {":5:", "tube.length: found 1e+12", "1e+09"}},
    {"tube_too_short", "length: 100", "length: 1e-320", {":5:", "tube.length: found ", "1e-09"}},
    {"tube_too_wide", "radius: 10", "radius: 2147483648", {"tube.radius: found 2.14748e+09"}},
    {"tube_too_fine", "radius: 10", "radius: 10, around: 5000, along: 20000", {"points around"}},
    {"tube_far_away", "position: [30", "position: [-1e200", {"position[0]: found -1e+200"}},
    {"tube_tiny_tangent", "radius: 10", "radius: 10, tangent: [0, 0, 1e-200]", {"a direction"}},
    {"move_too_far", "move: [1", "move: [1e10", {"move[0]: found 1e+10", "1e+09"}},
    {"force_too_large", "move: [1, 0, 0]", "force: [0, 0, 1e31]", {"force[2]: found 1e+31"}},
};

TEST_F(BadScene, IsRefusedWithOneSentence) {
  expect_refused(bads);
}

// A number that is no mistake of kind, but longer than a sentence.
TEST_F(BadScene, LongValuesAreShortened) {
  for (const std::string& value :
       {"-1." + std::string(5000, '0'), std::string(5000, 'x'), std::string(3000, '\xc3'),
        "\"" + std::string(5000, ' ') + "\\n\""}) {
    std::string text = base;
    text.replace(text.find("radius: 10"), 10, "radius: " + value);
    const std::string sentence = refusal(write("scene.yaml", text));
    EXPECT_NE(sentence.find("tube.radius: found "), std::string::npos) << sentence;
    EXPECT_LT(sentence.size(), folder.string().size() + 200) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

class BadRod : public ScratchFolder {
 protected:
  std::string refusal_of(const std::string& rod) const {
    return refusal(
        write("scene.yaml",
              "scene: rod\nunits: {length: mm, stress: MPa}\nfidelity: rod\nvessels:\n" + rod));
  }
};

TEST_F(BadRod, AsymmetricOrIndefiniteStiffness) {
  const std::string head =
      "  - {name: a, rod: {pieces: [{length: 1, elements: 1, stiffness: {matrix: [[1, 0, 0, 0, 0, ";
  const std::string tail =
      "], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [";
  EXPECT_EQ(refusal_of(head + "0.5" + tail + "0.5, 0, 0, 0, 0, 1]]}}]}}\n"), "");
  EXPECT_NE(refusal_of(head + "0.5" + tail + "0, 0, 0, 0, 0, 1]]}}]}}\n").find("symmetric"),
            std::string::npos);
  EXPECT_NE(refusal_of(head + "2" + tail + "2, 0, 0, 0, 0, 1]]}}]}}\n").find("positive definite"),
            std::string::npos);
  EXPECT_NE(refusal_of(head + "0" + tail + "0, 0, 0, 0, 0, 0]]}}]}}\n").find("positive definite"),
            std::string::npos);
}

TEST_F(BadRod, NumbersThatMakeNoSense) {
  const auto refusal_with = [&](const std::string& length, const std::string& axial,
                                const std::string& more) {
    return refusal_of("  - {name: a, rod: {pieces: [{length: " + length +
                      ", elements: 1000000, stiffness: {axial: " + axial +
                      ", shear: [1, 1], bending: [1, 1], torsion: 1}" + more + "}]}}\n");
  };
  EXPECT_EQ(refusal_with("1", "1", ""), "");
  EXPECT_EQ(refusal_with("1e-9", "1e30", ", curvature: [1e9, 0, 0]"), "");
  for (const auto& [sentence, part] :
       {std::pair(refusal_with("1e-320", "1", ""), "length: found 9.99989e-321"),
        std::pair(refusal_with("1e12", "1", ""), "length: found 1e+12"),
        std::pair(refusal_with("1", "1e308", ""), "axial: found 1e+308"),
        std::pair(refusal_with("1", "1e-308", ""), "axial: found 1e-308"),
        std::pair(refusal_with("1", "1", ", curvature: [0, 1e10, 0]"), "curvature[1]: found 1e+10"),
        std::pair(refusal_with("1", "1", ", natural: {u: [0, 0, 1e100]}"), "u[2]: found 1e+100"),
        std::pair(refusal_with("1", "1",
                               ", curvature: [0, 0, 0]}, {length: 1, elements: 1, stiffness: "
                               "{axial: 1, shear: [1, 1], bending: [1, 1], torsion: 1}"),
                  "1000001 elements")})
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

TEST_F(BadRod, ParentsThatAreNoTree) {
  const std::string pieces =
      "pieces: [{length: 1, elements: 1, stiffness: {axial: 1, shear: [1, 1], bending: [1, 1], "
      "torsion: 1}}]}}\n";
  EXPECT_NE(refusal_of("  - {name: a, rod: {parent: c, " + pieces).find("another rod"),
            std::string::npos);
  EXPECT_NE(refusal_of("  - {name: a, rod: {parent: a, " + pieces).find("ring"), std::string::npos);
  EXPECT_NE(refusal_of("  - {name: a, rod: {parent: b, " + pieces +
                       "  - {name: b, rod: {parent: a, " + pieces)
                .find("ring"),
            std::string::npos);
  EXPECT_EQ(
      refusal_of("  - {name: a, rod: {parent: b, " + pieces + "  - {name: b, rod: {" + pieces), "");
}

TEST_F(BadRod, OtherFidelities) {
  const auto file = write("scene.yaml",
                          "scene: rod\nunits: {length: mm, stress: MPa}\nfidelity: "
                          "skin\nvessels:\n  - {name: a, rod: {pieces: "
                          "[{length: 1, elements: 1, stiffness: {axial: 1, shear: [1, 1], bending: "
                          "[1, 1], torsion: 1}}]}}\n");
  EXPECT_NE(refusal(file).find("bare rod \"a\", expected rod"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
