// `vasorod init` as a user runs it: from surfaces to a scene that solves as it stands.
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vasorod/read_scene.h>
#include <vasorod/tube.h>

#include "obj_text.h"
#include "program/run_program.h"
#include "program/small_glenn.h"
#include "real_anatomy.h"

namespace vasorod::testing {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
  return " '" + path.string() + "'";
}

class Init : public ::testing::Test {
 protected:
  ProgramRun init(const std::vector<fs::path>& surfaces, const std::string& more = "") const {
    std::string command = "init" + more;
    for (const fs::path& surface : surfaces) command += quoted(surface);
    return run_program(vasorod(command + " -o" + quoted(scratch / "scene.yaml")));
  }
  // The result of the written scene.
  Json solved(const std::string& more = "") const {
    const ProgramRun run =
        run_program(vasorod("solve" + quoted(scratch / "scene.yaml") + " -o" +
                            quoted(scratch / "out") + " --no-report --threads 1" + more));
    EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
    return Json::parse(contents_of(scratch / "out" / "result.json"), nullptr, false);
  }
  fs::path write_obj(const std::string& name, const TriangleSurface& surface) const {
    std::ofstream(scratch / name) << obj_text(surface);
    return scratch / name;
  }
  // The vein and the artery of a scene of tubes, as files of their names.
  std::vector<fs::path> tubes() const {
    std::ofstream(scratch / "tubes.yaml") << small_glenn("skin");
    std::vector<fs::path> files;
    const Scene scene = read_scene(scratch / "tubes.yaml");
    for (const VesselSpec& vessel : scene.vessels)
      files.push_back(write_obj(vessel.name + ".obj", tube_surface(*vessel.tube)));
    return files;
  }
  void expect_refused(const ProgramRun& run, int exit_code, const std::string& words) const {
    EXPECT_EQ(run.exit_code, exit_code) << run.out;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  ScratchFolder scratch;
};

std::vector<fs::path> files_of(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) files.push_back(folder / (name + ".vtp"));
  return files;
}

// The operation that a solved proposal has: the vein comes to the artery without a large turn, on
// the whole length of its cut end.
void expect_operation(const Json& result) {
  EXPECT_EQ(result["status"], "converged");
  const Json& glenn = result["glenn"];
  EXPECT_LT(glenn["join"]["axis_turn_deg"].get<double>(), 60);
  EXPECT_LT(glenn["join"]["largest_gap"].get<double>(), 1e-9);
  EXPECT_NEAR(glenn["incision"]["perimeter_ratio"].get<double>(), 1, 5e-3);
}

TEST_F(Init, TwoTubesBecomeAShuntThatSolves) {
  const ProgramRun run = init(tubes());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* words :
       {"svc: superior vena cava, by its name, 2 ends, radius 3.3 to 3.3 mm, wall 0.39 mm",
        "rpa: pulmonary artery, by its name, 2 ends", "operation: cut of svc at (",
        "built, and it fits", "decide: units: mm is a guess", "decide: surface_is"})
    EXPECT_NE(run.out.find(words), std::string::npos) << words << '\n' << run.out;
  EXPECT_TRUE(run.out.ends_with((scratch / "scene.yaml").string() + "\n"));
  const Json result = solved();
  expect_operation(result);
  EXPECT_EQ(result["ends"].size(), 1u);  // at skin the vein's rod alone is solved
  const Json& pick = result["glenn"]["incision"]["pick"];
  EXPECT_NEAR(pick[0].get<double>(), 0, 2);
  EXPECT_NEAR(pick[2].get<double>(), 4, 0.5);
}

TEST_F(Init, TheBundledAnatomyBecomesAShuntThatSolves) {
  const ProgramRun run = init(files_of(fs::path(VASOROD_SOURCE_DIR) / "meshes" / "infant",
                                       {"svc", "pulmonary_artery", "aorta", "heart"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("heart: closed, an obstacle\n"), std::string::npos) << run.out;
  const Json result = solved();
  expect_operation(result);
  // benchmarks/cases/glenn/infant.yaml has them at (-10, -1.3, 1) and (-7.2, 8.5, 2.1).
  const Json &cut = result["glenn"]["cut"]["pick"], &pick = result["glenn"]["incision"]["pick"];
  EXPECT_LT((Vec3(cut[0], cut[1], cut[2]) - Vec3(-10, 2, 1)).norm(), 3.3);
  EXPECT_LT((Vec3(pick[0], pick[1], pick[2]) - Vec3(-7.2, 8.5, 2.1)).norm(), 3.3);
}

TEST_F(Init, RealAnatomyBecomesAShuntThatSolves) {
  const ProgramRun run = init(files_of(real_anatomy(), {"svc", "pulmonary_artery", "aorta"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("remeshed to"), std::string::npos);
  expect_operation(solved());
}

TEST_F(Init, OneVesselIsASceneThatRuns) {
  TubeSpec tube;
  tube.length = 60;
  tube.radius = 8;
  const fs::path file = write_obj("some vessel.obj", tube_surface(tube));
  ASSERT_EQ(init({file}, " --length-unit mm").exit_code, 0);
  const Json result = solved();
  EXPECT_EQ(result["status"], "converged");
  EXPECT_EQ(result.count("glenn"), 0u);
  EXPECT_EQ(result["vessels"].size(), 1u);
}

TEST_F(Init, AnExistingFileIsNotTouched) {
  const auto files = tubes();
  std::ofstream(scratch / "scene.yaml") << "years of work";
  expect_refused(init(files), 3, "scene.yaml: exists already, and init overwrites nothing");
  EXPECT_EQ(contents_of(scratch / "scene.yaml"), "years of work");
}

TEST_F(Init, BadInputIsOneSentence) {
  const auto files = tubes();
  const fs::path none = scratch / "none.vtp", text = scratch / "text.vtp";
  std::ofstream(text) << "no surface";
  fs::create_directory(scratch / "other");
  fs::copy_file(files[0], scratch / "other" / "svc.obj");
  expect_refused(init({none}), 2, "none.vtp: found no such file");
  expect_refused(init({files[0], text}), 2, "text.vtp");
  expect_refused(init({files[0], scratch / "other" / "svc.obj"}), 2, "found the name \"svc\"");
  expect_refused(init({fs::path(VASOROD_SOURCE_DIR) / "meshes/infant/heart.vtp"}), 2,
                 "heart.vtp: found a closed surface without an open end");
  expect_refused(init(files, " --length-unit inch"), 2, "inch");
  expect_refused(run_program(vasorod("init -o scene.yaml")), 2, "surfaces");
  expect_refused(run_program(vasorod("init" + quoted(files[0]))), 2, "output");
  expect_refused(run_program(vasorod("init" + quoted(files[0]) + " -o" +
                                     quoted(scratch / "absent" / "scene.yaml"))),
                 3, "absent: found no such folder");
  EXPECT_FALSE(fs::exists(scratch / "scene.yaml"));
}

}  // namespace
}  // namespace vasorod::testing
