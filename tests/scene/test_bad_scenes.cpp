// Scenes that must be refused with one sentence, and mutations of valid scenes that must be read or
// refused.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "scratch_folder.h"

namespace vasorod {
namespace {

const std::string base = R"(scene: bad
units: {length: mm, stress: MPa}
vessels:
  - name: tube
    tube: {length: 100, radius: 10}
    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}
  - name: other
    tube: {length: 50, radius: 5, position: [30, 0, 0]}
    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}
ends:
  - {vessel: tube, end: start, hold: true}
  - {vessel: tube, end: end, move: [1, 0, 0]}
contact: [[tube, other]]
surgery:
  glenn: {svc: tube, rpa: other, cut: [10, 0, 50], incision: [35, 0, 25], keep: {near: [0, 0, 100]}}
fidelity: paper
)";

// Replaces the first occurrence of `from` by `to`. The sentence must contain all of `says`.
struct Bad {
  std::string what, from, to;
  std::vector<std::string> says;
};

std::string refusal(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string glenn =
    "  glenn: {svc: tube, rpa: other, cut: [10, 0, 50], incision: [35, 0, 25], keep: {near: [0, 0, "
    "100]}}";

std::string end_to_end(const std::string& rims) {
  return "  end_to_end: {rims: [" + rims + "]}";
}

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
    {"surgery_unknown", "glenn:", "fontan:", {"\"fontan\"", "glenn"}},
    {"surgery_empty", glenn, "  {}", {":15:", "surgery: found neither glenn nor end_to_end"}},
    {"surgery_both",
     "contact: [[tube, other]]\nsurgery:",
     "contact: [[tube, other]]\nsurgery:\n  end_to_end: {}",
     {"surgery: found both glenn and end_to_end", "one operation"}},
    {"rims_missing", glenn, "  end_to_end: {}", {"surgery.end_to_end.rims: found nothing"}},
    {"rims_one",
     glenn,
     end_to_end("{vessel: tube, end: end}"),
     {"rims: found", "a list of two rims"}},
    {"rims_same",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: tube, end: start}"),
     {":15:", "rims[1].vessel: found \"tube\" a second time", "another vessel"}},
    {"rim_unknown_vessel",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: othr, end: start}"),
     {"rims[1].vessel", "\"othr\"", "\"other\""}},
    {"rim_without_place",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: other}"),
     {"rims[1]: found neither cut nor end"}},
    {"rim_with_two_places",
     glenn,
     end_to_end("{vessel: tube, end: end, cut: [10, 0, 50]}, {vessel: other, end: start}"),
     {"rims[0]: found both cut and end"}},
    {"rim_without_keep",
     glenn,
     end_to_end("{vessel: tube, cut: [10, 0, 50]}, {vessel: other, end: start}"),
     {"rims[0].keep: found nothing"}},
    {"rim_keeps_a_whole_vessel",
     glenn,
     end_to_end("{vessel: tube, end: end, cut_tilt_deg: 5}, {vessel: other, end: start}"),
     {"rims[0].cut_tilt_deg: found it beside end"}},
    {"rim_tilt",
     glenn,
     end_to_end("{vessel: tube, cut: [10, 0, 50], cut_tilt_deg: 76, keep: {near: [0, 0, 0]}}, "
                "{vessel: other, end: start}"),
     {"rims[0].cut_tilt_deg: found 76", "-75 to 75"}},
    {"rim_end_word",
     glenn,
     end_to_end("{vessel: tube, end: top}, {vessel: other, end: start}"),
     {"rims[0].end: found \"top\"", "start, end, {near: [x, y, z]} or {face: ModelFaceID}"}},
    {"end_to_end_rotation_word",
     glenn,
     end_to_end("{vessel: tube, end: end}, {vessel: other, end: start}], rotation_deg: [automatic"),
     {"rotation_deg: found", "auto or a number"}},
    {"glenn_same", "rpa: other", "rpa: tube", {"another vessel"}},
    {"glenn_no_cut", "cut: [10, 0, 50], ", "", {"surgery.glenn.cut: found nothing"}},
    {"glenn_incision_length",
     "svc: tube,",
     "svc: tube, incision_length: 5,",
     {"surgery.glenn.incision_length: found 5"}},
    {"glenn_tilt",
     "svc: tube,",
     "svc: tube, cut_tilt_deg: 80,",
     {"surgery.glenn.cut_tilt_deg: found 80", "-75 to 75"}},
    {"glenn_shape_word",
     "svc: tube,",
     "svc: tube, incision_shape: oval,",
     {"surgery.glenn.incision_shape: found \"oval\"", "slit, {ellipse: RATIO}"}},
    {"glenn_ellipse_ratio",
     "svc: tube,",
     "svc: tube, incision_shape: {ellipse: 1.5},",
     {"incision_shape.ellipse: found 1.5", "0.1 to 1"}},
    {"glenn_ellipse_no_width",
     "svc: tube,",
     "svc: tube, incision_shape: {ellipse: {length: 8}},",
     {"incision_shape.ellipse.width: found nothing", "across the artery"}},
    {"glenn_ellipse_two_lengths",
     "svc: tube,",
     "svc: tube, incision_length: 1, incision_shape: {ellipse: {length: 8, width: 4}},",
     {"surgery.glenn.incision_length: found it beside an ellipse that has a length"}},
    {"glenn_rotation_word",
     "svc: tube",
     "svc: tube, rotation_deg: automatic",
     {"auto or a number"}},
    {"glenn_no_keep", ", keep: {near: [0, 0, 100]}", "", {"surgery.glenn.keep"}},
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
     "fidelity: paper\nexplore: {}",
     {":17:", "unknown key \"explore\""}},
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

class BadScene : public ScratchFolder {};

TEST_F(BadScene, IsRefusedWithOneSentence) {
  for (const Bad& bad : bads) {
    SCOPED_TRACE(bad.what);
    std::string text = base;
    ASSERT_NE(text.find(bad.from), std::string::npos);
    text.replace(text.find(bad.from), bad.from.size(), bad.to);
    const auto file = write("scene.yaml", text);
    const std::string sentence = refusal(file);
    EXPECT_EQ(sentence.rfind(file.string() + ":", 0), 0U) << sentence;
    EXPECT_NE(sentence.find("found "), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(", expected "), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    for (const std::string& word : bad.says)
      EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
  }
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

class BadFile : public ScratchFolder {};

TEST_F(BadFile, MissingEmptyFolderAndBinary) {
  EXPECT_NE(refusal(folder / "none.yaml").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder).find("folder"), std::string::npos);
  EXPECT_NE(refusal(write("empty.yaml", "")).find("empty"), std::string::npos);
  EXPECT_NE(refusal(write("comment.yaml", "# nothing\n")).find("empty"), std::string::npos);
  EXPECT_NE(refusal(write("word.yaml", "hello")).find("expected a map"), std::string::npos);
  EXPECT_FALSE(refusal(write("binary.yaml", std::string("\0\1\2\xff\xfe{[", 7))).empty());
  EXPECT_FALSE(refusal(write("deep.yaml", std::string(20000, '['))).empty());
}

TEST_F(BadFile, WhatWouldNeverEndOrFillTheMemory) {
  for (const std::string text : {",", "{scene: x},", ",#5: d", "!#up1, pu^SNull", ",(", "]", "}",
                                 "a: 1\n,", "--- ,", ", !!str"}) {
    const std::string sentence = refusal(write("stray.yaml", text));
    EXPECT_NE(sentence.find(", expected "), std::string::npos) << text << ": " << sentence;
  }
  EXPECT_NE(refusal(write("comma.yaml", ",")).find(":1: found a stray \",\" in column 1"),
            std::string::npos);
  for (const std::string part : {"[", "{a: ", "- ", "? "}) {
    std::string text;
    for (int k = 0; k < 100000; ++k) text += part;
    EXPECT_NE(refusal(write("deep.yaml", text)).find(", expected "), std::string::npos);
  }
  std::ostringstream doubled;  // 2^40 values where it is written in full
  doubled << "a0: &a0 [x, x]\n";
  for (int k = 1; k < 40; ++k)
    doubled << "a" << k << ": &a" << k << " [*a" << k - 1 << ", *a" << k - 1 << "]\n";
  EXPECT_NE(refusal(write("doubled.yaml", doubled.str())).find("more than 2000000 values"),
            std::string::npos);
  EXPECT_NE(refusal(write("large.yaml", std::string{}.append(17'000'000, '#'))).find("bytes"),
            std::string::npos);
  EXPECT_NE(refusal(write("zero.yaml", std::string("scene: a\0b", 10))).find("0x00"),
            std::string::npos);
}

// Every mutation is read or refused with one line; no other outcome is allowed.
TEST_F(BadFile, MutationsAreReadOrRefused) {
  std::mt19937 random(1);
  const std::string letters = "[]{}:,-#&*!|>'\"%@` \n\t0123456789.eE+xaz_\xc3\xa9\x01";
  auto pick = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  int refused = 0;
  constexpr int rounds = 400;
  for (int round = 0; round < rounds; ++round) {
    std::string text = base;
    const size_t changes = 1 + pick(4);
    for (size_t k = 0; k < changes && !text.empty(); ++k) {
      const size_t at = pick(text.size());
      switch (pick(5)) {
        case 0:
          text[at] = letters[pick(letters.size())];
          break;
        case 1:
          text.insert(at, 1, letters[pick(letters.size())]);
          break;
        case 2:
          text.erase(at, 1 + pick(5));
          break;
        case 3:
          text.insert(at, text.substr(pick(text.size()), pick(40)));
          break;
        default:
          text.resize(std::max<size_t>(at, 1));
          break;
      }
    }
    const auto file = write("scene.yaml", text);
    try {
      read_scene(file);
    } catch (const InputError& error) {
      ++refused;
      const std::string sentence = error.what();
      ASSERT_EQ(sentence.find('\n'), std::string::npos) << text;
      ASSERT_NE(sentence.find(", expected "), std::string::npos) << sentence;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(refused, rounds / 2);
}

// Replaces every value of the scene in turn by one of a wrong type.
TEST_F(BadFile, WrongKindsOfEveryValue) {
  for (const char* wrong : {"[]", "{}", "[[1]]", "{a: 1}", "~", "-1", "0", "1e400", ".inf", "\"\"",
                            "*x", "&x", "!!int a"}) {
    for (size_t colon = base.find(": "); colon != std::string::npos;
         colon = base.find(": ", colon + 1)) {
      const size_t end = base.find_first_of(",}\n", colon);
      std::string text = base;
      text.replace(colon + 2, end - colon - 2, wrong);
      const auto file = write("scene.yaml", text);
      try {
        read_scene(file);
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << text;
      } catch (const std::exception& error) {
        FAIL() << error.what() << "\n" << text;
      }
    }
  }
}

}  // namespace
}  // namespace vasorod
