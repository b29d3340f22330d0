// Fidelity section through the program: against coupled, the rod's closed forms, and what it
// refuses.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run_program.h"
#include "program/small_glenn.h"
#include "program/solved_scene.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

using nlohmann::json;

// A tube of R 6, t 0.6, L 60 with these ends and this fidelity; `more` belongs to the vessel.
std::string tube_scene(const std::string& fidelity, const std::string& start,
                       const std::string& end, const std::string& more = "",
                       const std::string& shape = "") {
  return "scene: tube\nunits: {length: mm, stress: MPa}\nvessels:\n  - name: tube\n"
         "    tube: {length: 60, radius: 6, around: 48, along: 80" +
         shape +
         "}\n"
         "    wall: {thickness: 0.6, young: 0.5, poisson: 0.45}\n" +
         more + "ends:\n  - {vessel: tube, end: start, " + start +
         "}\n"
         "  - {vessel: tube, end: end, " +
         end + "}\nfidelity: " + fidelity + "\n";
}

double norm(const json& vector) {
  double square = 0;
  for (const double x : vector) square += x * x;
  return std::sqrt(square);
}

// RMS distance over the radius, and the larger difference of a reaction over the largest.
struct Apart {
  double rms = 0, reaction = 0;
};
Apart apart(const std::string& start, const std::string& end, const std::string& more = "",
            const std::string& shape = "") {
  const ScratchFolder scratch;
  for (const char* fidelity : {"section", "coupled"}) {
    std::ofstream(scratch / "scene.yaml") << tube_scene(fidelity, start, end, more, shape);
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / fidelity).string() + "' --quiet --no-report"));
    EXPECT_EQ(run.exit_code, 0) << fidelity << ": " << run.err;
  }
  const auto run = run_program(vasorod("compare '" + (scratch / "section").string() + "' '" +
                                       (scratch / "coupled").string() + "' --json"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const json found = json::parse(run.out);
  Apart result{found.at("vessels")[0].at("surface").at("rms"), 0};
  const json a = json::parse(contents_of(scratch / "section" / "result.json")),
             b = json::parse(contents_of(scratch / "coupled" / "result.json"));
  EXPECT_EQ(a.at("status"), b.at("status"));
  EXPECT_EQ(a.at("certificate").at("smallest_curvature_positive"), true);
  double largest = 0, worst = 0;
  for (size_t e = 0; e < 2; ++e) {
    json force = a.at("ends")[e].at("force"), moment = a.at("ends")[e].at("moment");
    for (size_t k = 0; k < 3; ++k) {
      force[k] = force[k].get<double>() - b.at("ends")[e].at("force")[k].get<double>();
      moment[k] = moment[k].get<double>() - b.at("ends")[e].at("moment")[k].get<double>();
    }
    worst = std::max({worst, norm(force), norm(moment) / 6});
    largest = std::max(
        {largest, norm(b.at("ends")[e].at("force")), norm(b.at("ends")[e].at("moment")) / 6});
  }
  result.reaction = worst / largest;
  const json &ours = a.at("balance")[0], &theirs = b.at("balance")[0];
  EXPECT_EQ(ours.contains("pressure"), theirs.contains("pressure"));
  if (ours.contains("pressure")) {
    json force = ours.at("pressure");
    for (size_t k = 0; k < 3; ++k)
      force[k] = force[k].get<double>() - theirs.at("pressure")[k].get<double>();
    EXPECT_LT(norm(force), 6e-3 * std::max(norm(theirs.at("pressure")), largest));
    EXPECT_LT(ours.at("residual").get<double>(), 1e-6);
  }
  return result;
}

// Another discretisation of the same wall: coupled with 48 points around is within 0.05 % of R and
// 0.3 % of the reactions of itself on finer meshes.
TEST(Section, IsNearCoupledForEveryKindOfEnd) {
  struct Case {
    const char *start, *end, *more, *shape;
  };
  for (const Case& c : {
           Case{"hold: true", "move: [3, 0, 1], rotate_deg: [0, 5, 20]", "", ""},
           Case{"hold: true", "move: [3, 0, 1], rotate_deg: [0, 5, 0], section: soft", "", ""},
           Case{"hold: true, section: soft", "force: [0.005, 0.01, 0.1], section: soft", "", ""},
           Case{"hold: true", "force: [0.005, 0.01, 0.1]", "    law: neo-hookean\n", ""},
           Case{"hold: true", "move: [0.5, 0, 0.5], rotate_deg: [0, 4, 0]", "", ", bend_deg: 20"},
       }) {
    const Apart found = apart(c.start, c.end, c.more, c.shape);
    EXPECT_LT(found.rms, 1e-3) << c.end << c.more << c.shape;
    EXPECT_LT(found.reaction, 6e-3) << c.end << c.more << c.shape;
  }
}

// The pressure where the wall's stiffness against it counts: p_c of this tube is 1.6e-4 MPa. A
// prestretch of 1.05 alone pulls by E A e within 0.04 % here and 1.2 % in coupled.
TEST(Section, IsNearCoupledUnderPressure) {
  struct Case {
    const char *start, *end, *more, *shape;
  };
  for (const Case& c : {
           Case{"hold: true", "hold: true", "    pressure: {after: 0.002}\n", ""},
           Case{"hold: true", "move: [3, 0, 1], rotate_deg: [0, 5, 20]",
                "    pressure: {after: 0.002}\n", ""},
           Case{"hold: true, section: soft",
                "move: [3, 0, 1], rotate_deg: [0, 5, 0], section: soft",
                "    pressure: {scan: 0.001, after: 0.003}\n    axial_prestretch: 1.05\n", ""},
           Case{"hold: true", "force: [0.005, 0.01, 0.1]",
                "    pressure: {scan: 0.001, after: 0.002}\n    law: neo-hookean\n", ""},
           Case{"hold: true", "move: [0.5, 0, 0.5], rotate_deg: [0, 4, 0]",
                "    pressure: {scan: 0.002, after: -0.0001}\n", ", bend_deg: 20"},
       }) {
    const Apart found = apart(c.start, c.end, c.more, c.shape);
    EXPECT_LT(found.rms, 1e-3) << c.end << c.more << c.shape;
    EXPECT_LT(found.reaction, 1e-2) << c.end << c.more << c.shape;
  }
}

// A vessel that is held as it was seen carries stress though nothing moves it.
TEST(Section, AVesselAsSeenPullsAtItsEnds) {
  const json result = solved_scene(
      tube_scene("section", "hold: true", "hold: true, section: soft",
                 "    pressure: {scan: 0.002, after: 0.002}\n    axial_prestretch: 1.05\n",
                 ", bend_deg: 30, end_radius: 5"));
  EXPECT_EQ(result.at("status"), "converged");
  EXPECT_GT(norm(result.at("ends")[0].at("force")), 0.3);
  const auto& terms = result.at("model").at("terms");
  EXPECT_NE(std::find(terms.begin(), terms.end(), "pressure"), terms.end());
  EXPECT_GT(norm(result.at("balance")[0].at("pressure")), 0.01);
  bool said = false;
  for (const std::string note : result.at("certificate").at("notes"))
    said |= note.find("as scanned") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST(Section, StatesItsResolutionAndItsEstimate) {
  const json result =
      solved_scene(tube_scene("section", "hold: true", "move: [3, 0, 1], rotate_deg: [0, 5, 20]"));
  EXPECT_EQ(result.at("fidelity"), "section");
  EXPECT_EQ(result.at("status"), "converged");
  EXPECT_LT(result.at("certificate").at("relative_residual").get<double>(), 1e-9);
  EXPECT_LT(result.at("balance")[0].at("residual").get<double>(), 1e-6);
  bool said = false;
  for (const std::string note : result.at("certificate").at("notes"))
    said |= note.find("harmonics around") != std::string::npos &&
            note.find("estimated error") != std::string::npos;
  EXPECT_TRUE(said) << result.at("certificate").at("notes");
  EXPECT_TRUE(result.at("model").at("left_out").contains("contact"));
}

// Past Brazier's limit coupled follows the tube to its kink; so does this.
TEST(Section, PastItsLimitATubeIsNotGreen) {
  const json result = solved_scene(
      tube_scene("section", "hold: true", "move: [18, 0, -6], rotate_deg: [0, 40, 0]"), 1);
  EXPECT_NE(result.at("status"), "converged");
  EXPECT_FALSE(result.at("validity").at("in_range"));
}

void expect_refused(const std::string& scene, const std::string& sentence) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << scene;
  const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                       (scratch / "out").string() + "' --quiet"));
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
}

// coupled lets it shear beside its ends, and is softer.
TEST(Section, AWallThatIsSoftInShearIsNamed) {
  const ScratchFolder scratch;
  const auto solve = [&](const std::string& fidelity, const std::string& wall) {
    std::string scene = tube_scene(fidelity, "hold: true", "move: [1.5, 0, 0], section: rigid");
    const std::string isotropic = "{thickness: 0.6, young: 0.5, poisson: 0.45}";
    scene.replace(scene.find(isotropic), isotropic.size(), wall);
    std::ofstream(scratch / "scene.yaml") << scene;
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / "result").string() + "' --quiet --no-report"));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(contents_of(scratch / "result" / "result.json"));
  };
  const auto is_named = [](const json& result) {
    return result.at("certificate").at("notes").dump().find("is thick or soft in shear") !=
           std::string::npos;
  };
  const auto force = [](const json& result) { return norm(result.at("ends")[1].at("force")); };
  const std::string soft =
      "{thickness: 0.6, young: 0.5, shear: 0.002, transverse: {young: 0.5, poisson: 0.45, "
      "coupling: 0}}";
  const json section = solve("section", soft), coupled = solve("coupled", soft);
  EXPECT_TRUE(is_named(section));
  EXPECT_FALSE(is_named(coupled));
  EXPECT_GT(force(section), 1.01 * force(coupled));
  EXPECT_FALSE(is_named(solve("section", "{thickness: 0.6, young: 0.5, poisson: 0.45}")));
}

TEST(Section, RefusesWhatItDoesNotModel) {
  expect_refused(small_glenn("section"),
                 "found an operation at fidelity section, whose vessels are whole, expected "
                 "fidelity rod, skin, paper or coupled");
  expect_refused(tube_scene("section", "fix: [x, y, z]",
                            "fix: [x, y]}\n  - {vessel: tube, end: end, force: [0, 0, 0.1]"),
                 "nothing stops its wall's rigid motion, a rotation about the axis");
}

// The ends of a tube that is turned once are where they were, so that a wall that feels no contact
// with itself can end untwisted.
TEST(Section, TurnsThatAreLostAreNamed) {
  const auto solved = [](const std::string& degrees, int exit_code) {
    return solved_scene(
        "scene: tube\nunits: {length: mm, stress: MPa}\nvessels:\n  - name: tube\n"
        "    tube: {length: 100, radius: 10, around: 24, along: 44}\n"
        "    wall: {thickness: 3, young: 1, poisson: 0.3}\nends:\n"
        "  - {vessel: tube, end: start, hold: true}\n"
        "  - {vessel: tube, end: end, rotate_deg: [0, 0, " +
            degrees + "]}\nfidelity: section\n",
        exit_code);
  };
  const json lost = solved("1080", 1);
  EXPECT_EQ(lost.at("status"), "buckled");
  EXPECT_LT(lost.at("energy").at("total"), 1e-9);
  const std::string notes = lost.at("certificate").at("notes").dump();
  EXPECT_NE(notes.find("rod of tube: the twisted branch from rest lost its stability, and the "
                       "twist went from 1080 to 360 degrees"),
            std::string::npos)
      << notes;
  EXPECT_NE(notes.find("vessel tube is twisted by 0 degrees and not by 360 as its rod"),
            std::string::npos)
      << notes;
  EXPECT_EQ(solved("20", 0).at("certificate").at("notes").dump().find("lost"), std::string::npos);
}

}  // namespace
}  // namespace vasorod::testing
