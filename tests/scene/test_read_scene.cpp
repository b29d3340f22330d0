#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "scratch_folder.h"

namespace vasorod {
namespace {

// Every key of a scene file at least once.
const char* const tubes = R"(scene: bend-10
units: {length: cm, stress: kPa}
vessels:
  - name: tube
    tube: {length: 100, radius: 10, around: 40, along: 70, bend_deg: 30, end_radius: 8, end_thickness: 0.5, position: [1, 2, 3], tangent: [0, 1, 0], normal: [0, 0, 2]}
    wall: {thickness: 1.0, young: 1.0, shear: 0.4, transverse: {young: 0.5, poisson: 0.3, coupling: 0.1}}
    law: svk
    coefficients: {binding: 1.0, bending: 2.0, stretching: 3.0}
  - name: heart
    surface: heart.vtp
    remesh: 1.5
    surface_is: inner
    check: false
    role: obstacle
  - name: plain
    surface: sub/plain.stl
    wall: {thickness: 1.0, young: 2.0, poisson: 0.25}
ends:
  - {vessel: tube, end: start, hold: true}
  - {vessel: tube, end: end, rotate_deg: [0, 400, 0], move: [8.70, 0, -0.51], section: soft}
  - {vessel: plain, end: {near: [1, 2, 3]}, force: [0, 0, 1], moment: [1, 0, 0], moment_frame: body}
  - {vessel: plain, end: start, fix: [x, rz]}
contact: [[tube, heart], [plain, tube]]
surgery:
  glenn:
    svc: tube
    rpa: plain
    cut: [1, 2, 3]
    incision: [4, 5, 6]
    rotation_deg: "auto"
    incision_length: 1.25
    incision_shape: {ellipse: {width: 4}}
    cut_tilt_deg: -20
    keep: {near: [7, 8, 9]}
fidelity: coupled
)";

const char* const rods = R"(scene: rods
units: {length: mm, stress: MPa}
vessels:
  - name: trunk
    rod:
      position: [1, 0, 0]
      tangent: [0, 0, 1]
      normal: [1, 0, 0]
      pieces:
        - {length: 78.5, curvature: [0, 0.01, 0], elements: 32, natural: {u: [0, 0, 0.1]}}
        - {length: 10, elements: 4, stiffness: {matrix: [[5, 0, 0, 0, 0, 0], [0, 5, 0, 0, 0, 0], [0, 0, 9, 0, 0, 1], [0, 0, 0, 2, 0, 0], [0, 0, 0, 0, 2, 0], [0, 0, 1, 0, 0, 3]]}, end_stiffness: {axial: 1, shear: [2, 3], bending: [4, 5], torsion: 6}}
      stiffness: {axial: 1e7, shear: [5e6, 4e6], bending: [8.3e5, 8.2e5], torsion: 8.1e5}
  - name: branch
    rod: {parent: trunk, pieces: [{length: 5, elements: 2, stiffness: {axial: 1, shear: [1, 1], bending: [1, 1], torsion: 1}}]}
ends:
  - {vessel: trunk, end: start, hold: true}
  - {vessel: trunk, at: 0.5, force: [0, 0, 1]}
  - {vessel: branch, end: {at: 0.25}, force: [0, 0, 2]}
fidelity: rod
)";

class ReadScene : public ScratchFolder {
 protected:
  Scene read(const std::string& text) const { return read_scene(write("scene.yaml", text)); }
};

TEST_F(ReadScene, ReadsTheNeoHookeanLaw) {
  const Scene scene = read(R"(scene: law
units: {length: mm, stress: MPa}
vessels:
  - name: tube
    tube: {length: 100, radius: 10}
    wall: {thickness: 1.0, young: 1.0, poisson: 0.45}
    law: neo-hookean
ends:
  - {vessel: tube, end: start, hold: true}
  - {vessel: tube, end: end, move: [1, 0, 0]}
fidelity: coupled
)");
  EXPECT_EQ(scene.vessel("tube").wall->material.law, Law::neo_hookean);
}

TEST_F(ReadScene, ReadsEveryKeyOfTheContract) {
  const Scene scene = read(tubes);
  EXPECT_EQ(scene.name, "bend-10");
  EXPECT_EQ(scene.units.metres, 1e-2);
  EXPECT_EQ(scene.units.pascals, 1e3);
  ASSERT_EQ(scene.vessels.size(), 3U);
  const VesselSpec& tube = scene.vessel("tube");
  EXPECT_EQ(tube.tube->around, 40);
  EXPECT_EQ(tube.tube->along, 70);
  EXPECT_EQ(tube.tube->bend_deg, 30);
  EXPECT_EQ(*tube.tube->end_radius, 8);
  EXPECT_EQ(*tube.tube->end_thickness, 0.5);
  EXPECT_EQ(tube.tube->position, Vec3(1, 2, 3));
  EXPECT_EQ(tube.tube->normal, Vec3(0, 0, 1));
  EXPECT_EQ(tube.surface_is, SurfaceIs::mid);
  EXPECT_EQ(tube.wall->material.young_transverse, 0.5);
  EXPECT_EQ(tube.wall->material.poisson_tt, 0.3);
  EXPECT_EQ(tube.wall->material.poisson_lt, 0.1);
  EXPECT_EQ(tube.wall->material.shear_axial, 0.4);
  EXPECT_EQ(tube.wall->material.law, Law::svk);
  EXPECT_EQ(tube.coefficients->stretching, 3);
  const VesselSpec& heart = scene.vessel("heart");
  EXPECT_EQ(*heart.surface, folder / "heart.vtp");
  EXPECT_EQ(*heart.remesh, 1.5);
  EXPECT_EQ(heart.surface_is, SurfaceIs::inner);
  EXPECT_FALSE(heart.check);
  EXPECT_EQ(heart.role, Role::obstacle);
  EXPECT_EQ(*scene.vessel("plain").surface, folder / "sub/plain.stl");
  EXPECT_EQ(scene.vessel("plain").surface_is, SurfaceIs::outer);
  EXPECT_DOUBLE_EQ(scene.vessel("plain").wall->material.shear_axial, 0.8);
  ASSERT_EQ(scene.ends.size(), 4U);
  EXPECT_TRUE(scene.ends[0].hold);
  EXPECT_EQ(*scene.ends[1].rotate_deg, Vec3(0, 400, 0));
  EXPECT_EQ(*scene.ends[1].move, Vec3(8.7, 0, -0.51));
  EXPECT_TRUE(scene.ends[1].soft_section);
  EXPECT_EQ(scene.ends[2].end.kind, EndSelector::Kind::near);
  EXPECT_EQ(to_string(scene.ends[2].end), "near(1, 2, 3)");
  EXPECT_TRUE(scene.ends[2].moment_in_body);
  EXPECT_EQ(scene.ends[3].fix, (std::array{true, false, false, false, false, true}));
  EXPECT_EQ(scene.ends[3].line, 22);
  EXPECT_EQ(*scene.contact,
            (std::vector<std::array<std::string, 2>>{{"tube", "heart"}, {"plain", "tube"}}));
  EXPECT_EQ(scene.glenn->rpa, "plain");
  EXPECT_EQ(scene.glenn->cut.point, Vec3(1, 2, 3));
  EXPECT_FALSE(scene.glenn->rotation_deg);
  EXPECT_EQ(scene.glenn->incision_length, 1.25);
  EXPECT_EQ(scene.glenn->cut_tilt_deg, -20);
  EXPECT_EQ(scene.glenn->ellipse->width, 4);
  EXPECT_FALSE(scene.glenn->ellipse->length);
  EXPECT_EQ(to_string(scene.glenn->keep), "near(7, 8, 9)");
  EXPECT_EQ(*scene.fidelity, "coupled");
}

// The scene `tubes` with other picks.
std::string with_picks(const std::string& cut, const std::string& incision,
                       const std::string& keep) {
  std::string text = tubes;
  for (const auto& [key, value] : {std::pair("cut", cut), {"incision", incision}, {"keep", keep}}) {
    const std::string begin = std::string("\n    ") + key + ": ";
    const auto at = text.find(begin) + begin.size();
    text.replace(at, text.find('\n', at) - at, value);
  }
  return text;
}

TEST_F(ReadScene, ReadsPicksByFractionAndEndsByFace) {
  const Scene scene = read(
      with_picks("{along: 0.77, to: {face: 12}}",
                 "{along: 0.4, around_deg: -90, from: end, to: {near: [1, 2, 3]}}", "{face: 7}"));
  EXPECT_EQ(scene.glenn->cut.along, 0.77);
  EXPECT_EQ(to_string(*scene.glenn->cut.to), "face(12)");
  EXPECT_FALSE(scene.glenn->cut.from);
  EXPECT_EQ(scene.glenn->incision.along, 0.4);
  EXPECT_EQ(scene.glenn->incision.around_deg, -90);
  EXPECT_EQ(to_string(*scene.glenn->incision.from), "end");
  EXPECT_EQ(to_string(*scene.glenn->incision.to), "near(1, 2, 3)");
  EXPECT_EQ(to_string(scene.glenn->keep), "face(7)");
}

// The scene is in cm, markups are in mm.
TEST_F(ReadScene, ReadsPicksFromMarkups) {
  write("picks.mrk.json", R"({"markups": [{"coordinateSystem": "RAS", "controlPoints": [
    {"label": "F-1", "position": [10, -20, 35]}, {"label": "slit", "position": [1, 2, 3]}]}]})");
  const Scene scene = read(with_picks("{markup: picks.mrk.json, label: F-1}",
                                      "{markup: picks.mrk.json, label: slit}", "start"));
  EXPECT_LT((scene.glenn->cut.point - Vec3(1, -2, 3.5)).norm(), 1e-12);
  EXPECT_EQ(scene.glenn->cut.space, "RAS");
  EXPECT_EQ(scene.glenn->cut.markup, folder / "picks.mrk.json");
  EXPECT_LT((scene.glenn->incision.point - Vec3(0.1, 0.2, 0.3)).norm(), 1e-12);
  const auto files = input_files(scene);
  EXPECT_EQ(std::count(files.begin(), files.end(), folder / "picks.mrk.json"), 2);
}

TEST_F(ReadScene, ReadsAnEndToEndJoin) {
  std::string text = tubes;
  const auto glenn = text.find("  glenn:"), end = text.find("fidelity:");
  text.replace(glenn, end - glenn, R"(  end_to_end:
    rims:
      - {vessel: plain, cut: [1, 2, 3], cut_tilt_deg: -20, keep: {near: [7, 8, 9]}}
      - {vessel: tube, end: {near: [4, 5, 6]}}
    rotation_deg: 12
)");
  const Scene scene = read(text);
  EXPECT_FALSE(scene.glenn);
  const EndToEndSpec& spec = scene.end_to_end.value();
  EXPECT_EQ(spec.rotation_deg, 12);
  EXPECT_EQ(spec.rims[0].vessel, "plain");
  EXPECT_EQ(spec.rims[0].cut.value().point, Vec3(1, 2, 3));
  EXPECT_EQ(spec.rims[0].cut_tilt_deg, -20);
  EXPECT_EQ(to_string(spec.rims[0].keep), "near(7, 8, 9)");
  EXPECT_FALSE(spec.rims[1].cut);
  EXPECT_EQ(to_string(spec.rims[1].end), "near(4, 5, 6)");
  EXPECT_EQ(spec.rims[1].line, spec.rims[0].line + 1);
  EXPECT_EQ(scene.joined(), (std::array<std::string, 2>{"plain", "tube"}));
}

// A text has neither a file nor lines that a reader could look up; what it says is the same.
TEST_F(ReadScene, ATextIsReadAsAFileIs) {
  const Scene scene = read_scene_text(tubes, folder), file = read(tubes);
  EXPECT_EQ(scene.text, tubes);
  EXPECT_EQ(file.text, tubes);
  EXPECT_TRUE(scene.file.empty());
  EXPECT_EQ(input_files(scene), (std::vector{folder / "heart.vtp", folder / "sub/plain.stl"}));
  EXPECT_EQ(*read_scene_text(tubes).vessel("heart").surface, "heart.vtp");
  EXPECT_EQ(scene.ends[1].move, file.ends[1].move);
  EXPECT_EQ(scene.glenn->keep.near, file.glenn->keep.near);
  EXPECT_EQ(scene.units.metres, file.units.metres);
  EXPECT_EQ(scene.ends[3].line + scene.vessels[2].line + scene.glenn->line + scene.fidelity_line,
            0);
}

TEST_F(ReadScene, WhatIsWrongWithATextIsSaidWithoutAPlace) {
  const auto said = [](const auto& reads) -> std::string {
    try {
      reads();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::string good = tubes;
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const std::string& text :
       {changed("around: 40", "around: some"), changed("law: svk", "lav: svk"),
        changed("fidelity: coupled", "extrapolate: false"), changed("rpa: plain", "rpa: plane")}) {
    const std::string of_text = said([&] { read_scene_text(text, folder); }),
                      of_file = said([&] { read(text); });
    ASSERT_GT(of_file.size(), of_text.size());
    EXPECT_EQ(of_text, of_file.substr(of_file.find(": ") + 2));
    EXPECT_EQ(of_text.find("scene.yaml"), std::string::npos) << of_text;
  }
  EXPECT_EQ(said([&] { read_scene_text(changed("  - name: tube", "\t- name: tube")); }),
            "line 4: found a tab in the indentation, expected spaces, as YAML asks for");
  EXPECT_EQ(said([&] { read_scene_text(""); }), "found an empty text, expected a scene");
}

TEST_F(ReadScene, ReadsRods) {
  const Scene scene = read(rods);
  const RodSpec& trunk = *scene.vessel("trunk").rod;
  EXPECT_EQ(trunk.tangent, Vec3::UnitZ());
  ASSERT_EQ(trunk.pieces.size(), 2U);
  Vec6 diagonal;
  diagonal << 5e6, 4e6, 1e7, 8.3e5, 8.2e5, 8.1e5;
  EXPECT_EQ(trunk.pieces[0].stiffness, Mat6(diagonal.asDiagonal()));
  Vec6 natural;
  natural << 0, 0, 1, 0, 0, 0.1;
  EXPECT_EQ(*trunk.pieces[0].natural, natural);
  EXPECT_EQ(trunk.pieces[1].stiffness(2, 5), 1);
  EXPECT_EQ((*trunk.pieces[1].end_stiffness)(5, 5), 6);
  EXPECT_FALSE(trunk.pieces[1].natural);
  const RodSpec& branch = *scene.vessel("branch").rod;
  EXPECT_EQ(*branch.parent, "trunk");
  EXPECT_EQ(branch.tangent, Vec3::UnitZ());  // continues straight from the parent's end
  EXPECT_EQ(scene.ends[1].end.at, 0.5);
  EXPECT_EQ(to_string(scene.ends[2].end), "at(0.25)");
}

TEST_F(ReadScene, SetsEAndGFreeOfEachOther) {
  std::string text = tubes;
  const std::string wall = "wall: {thickness: 1.0, young: 2.0, poisson: 0.25}";
  text.replace(text.find(wall), wall.size(),
               "wall: {thickness: 1.0, young: 2.0, poisson: 0.25, shear: 0.1}");
  const Scene scene = read(text);
  const Wall& free = *scene.vessel("plain").wall;
  EXPECT_FALSE(free.material.is_isotropic());
  EXPECT_EQ(free.material.shear_axial, 0.1);
  EXPECT_EQ(free.material.young_transverse, 2);
}

TEST_F(ReadScene, PressuresAreInStressUnits) {
  const auto pressure = [&](const std::string& unit) {
    std::string text = tubes;
    text.insert(text.find("    law: svk"),
                "    pressure: {scan: 5, after: -12}\n    axial_prestretch: 1.2\n");
    const std::string stress = "stress: kPa";
    text.replace(text.find(stress), stress.size(), stress + unit);
    const Scene scene = read(text);
    EXPECT_EQ(scene.vessel("tube").axial_prestretch, 1.2);
    return *scene.vessel("tube").pressure;
  };
  EXPECT_EQ(pressure("").scan, 5);
  EXPECT_EQ(pressure("").after, -12);
  EXPECT_EQ(pressure(", pressure: kPa").scan, 5);
  EXPECT_NEAR(pressure(", pressure: MPa").scan, 5e3, 1e-9);
  EXPECT_NEAR(pressure(", pressure: Pa").scan, 5e-3, 1e-15);
  EXPECT_NEAR(pressure(", pressure: mmHg").scan, 5 * 0.133322387415, 1e-12);
  EXPECT_FALSE(read(tubes).vessel("tube").pressure);
  EXPECT_EQ(read(tubes).vessel("tube").axial_prestretch, 1);
}

}  // namespace
}  // namespace vasorod
