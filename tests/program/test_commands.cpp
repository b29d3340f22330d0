// The commands' interface to a shell: exit codes, one sentence on standard error, files written.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/run_program.h"
#include "program/same_with_threads.h"
#include "program/small_glenn.h"

namespace vasorod::testing {
namespace {

const std::string source = VASOROD_SOURCE_DIR;

// A straight tube pulled to 1.05 between rigid ends.
std::string pulled_tube(const std::string& fidelity) {
  return "scene: pulled\nunits: {length: mm, stress: MPa}\nvessels:\n"
         "  - name: tube\n    tube: {length: 100, radius: 10, around: 32, along: 50}\n"
         "    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}\n"
         "ends:\n  - {vessel: tube, end: start, hold: true}\n  - {vessel: tube, end: end, move: "
         "[0, 0, 5]}\n"
         "fidelity: " +
         fidelity + "\n";
}

int lines_in(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Commands, HelpAndVersionEndWithZero) {
  EXPECT_EQ(run_program(vasorod("--help")).exit_code, 0);
  const auto version = run_program(vasorod("--version"));
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_NE(version.out.find("vasorod 0."), std::string::npos);
}

TEST(Commands, WrongUsageIsOneSentenceAndTwo) {
  for (const char* arguments :
       {"", "solve", "paint x", "solve x -o y --fidelity glass", "solve x -o y --threads 0"}) {
    const auto run = run_program(vasorod(arguments));
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(lines_in(run.err), 1) << run.err;
  }
}

TEST(Commands, NumbersThatAreNoneAreRefusedInASentenceThatCanBeRead) {
  for (const char* arguments :
       {"solve x -o y --time-limit nan", "solve x -o y --time-limit inf",
        "solve x -o y --time-limit=-1", "fit x -o y --remesh nan", "fit x -o y --remesh 0"}) {
    const auto run = run_program(vasorod(arguments));
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(lines_in(run.err), 1) << run.err;
    EXPECT_NE(run.err.find("expected a number"), std::string::npos) << run.err;
    EXPECT_LT(run.err.size(), 160U) << run.err;
  }
}

TEST(Commands, AnUnknownCommandIsNamed) {
  const auto run = run_program(vasorod("paint x"));
  EXPECT_EQ(run.err,
            "vasorod: found the command \"paint\", expected solve, fit, prepare, init, explore, "
            "compare or draw\n");
}

TEST(Commands, DrawWritesThePictureThatIsAskedFor) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("skin");
  const auto quoted = [&](const std::string& name) {
    return " '" + (scratch / name).string() + "'";
  };
  ASSERT_EQ(run_program(vasorod("solve" + quoted("scene.yaml") + " -o" + quoted("out"))).exit_code,
            0);
  const std::string draw = "draw" + quoted("out") + " -o";
  const auto run =
      run_program(vasorod(draw + quoted("one.png") +
                          " --colour axial_stretch --range 1 1.1 --from 0 -1 0"
                          " --up 1 0 0 --mark 10 0 50 --mark -10 0 50 --size 320 200"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(contents_of(scratch / "one.png").substr(1, 3), "PNG");
  EXPECT_EQ(run_program(vasorod(draw + quoted("lettered.png") + " --lettering")).exit_code, 0);
  EXPECT_GT(contents_of(scratch / "lettered.png").size(), contents_of(scratch / "one.png").size());
  EXPECT_EQ(run_program(vasorod(draw + quoted("none/one.png"))).exit_code, 3);
  for (const std::string& wrong :
       {draw + quoted("one.jpg"), draw + quoted("two.png") + " --only vein",
        draw + quoted("two.png") + " --from 0 0 nan", draw + quoted("two.png") + " --mark 1 2",
        "draw" + quoted("nothing") + " -o" + quoted("two.png")}) {
    const auto refused = run_program(vasorod(wrong));
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_EQ(lines_in(refused.err), 1) << refused.err;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "two.png"));
}

TEST(Commands, AStandardOutputThatTakesNothingIsThree) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("rod");
  const std::string command = vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                      (scratch / "out").string() + "' --json");
  const auto run = run_program("sh -c \"" + command + " >/dev/full\"");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(lines_in(run.err), 1) << run.err;
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "result.json"));
}

TEST(Commands, APulledTubeAnswersWithEATimesStrain) {
  const ScratchFolder scratch;
  for (const std::string fidelity : {"rod", "skin", "paper", "section", "coupled"}) {
    std::ofstream(scratch / "scene.yaml") << pulled_tube(fidelity);
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / fidelity).string() + "' --json"));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "") << "silent in a pipe";
    const auto result = nlohmann::json::parse(run.out);
    EXPECT_EQ(result, nlohmann::json::parse(contents_of(scratch / fidelity / "result.json")));
    // E A (l - 1), A = 2 pi R t, up to the error of the mesh's polygon of 32 sides.
    const double exact = 1.0 * 2 * M_PI * 10 * 1 * 0.05;
    EXPECT_NEAR(result.at("ends")[1].at("force")[2].get<double>(), exact, 0.01 * exact);
    EXPECT_NEAR(result.at("ends")[0].at("force")[2].get<double>(), -exact, 0.01 * exact);
    // Rigid ends prevent the wall from narrowing. The wall therefore stretches slightly less beside
    // them and slightly more elsewhere.
    EXPECT_NEAR(result.at("metrics")[0].at("stretch")[1].get<double>(), 1.05,
                fidelity == "coupled" || fidelity == "section" ? 1e-3 : 1e-6);
    EXPECT_TRUE(result.at("validity").at("in_range").get<bool>());
    // Rods always have it; on a surface, `paper` computes it only on request.
    EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive").is_null(),
              fidelity == "paper");
  }
  const auto compared = run_program(vasorod("compare '" + (scratch / "skin").string() + "' '" +
                                            (scratch / "paper").string() + "' --json"));
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_TRUE(nlohmann::json::accept(compared.out));
}

TEST(Commands, AResultComparedWithItselfIsZeroApartEvenAtAnIncision) {
  const ScratchFolder scratch;
  const auto folder = (scratch / "out").string();
  ASSERT_EQ(run_program(vasorod("solve '" + source +
                                "/benchmarks/cases/glenn/infant.yaml' --fidelity skin -o '" +
                                folder + "'"))
                .exit_code,
            0);
  const auto run = run_program(vasorod("compare '" + folder + "' '" + folder + "' --json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto compared = nlohmann::json::parse(run.out);
  ASSERT_EQ(compared.at("vessels").size(), 3U);
  for (const auto& vessel : compared.at("vessels"))
    EXPECT_EQ(vessel.at("surface").at("largest"), 0) << vessel;
}

TEST(Commands, TwoRunsDifferInNothingButSeconds) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("paper");
  nlohmann::json runs[2];
  for (auto& result : runs) {
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / "out").string() + "' --json"));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    result = nlohmann::json::parse(run.out);
    result.erase("seconds");
  }
  EXPECT_EQ(runs[0], runs[1]);
}

// The width is in the file's head (ISO 15948: bytes 16 to 19, the first the largest).
TEST(Commands, PicturesHaveTheWidthThatIsAskedFor) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("skin");
  const std::string solve = "solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                            (scratch / "out").string() + "' --picture-width ";
  ASSERT_EQ(run_program(vasorod(solve + "1600")).exit_code, 0);
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "out"))
    if (entry.path().extension() == ".png") {
      const std::string bytes = contents_of(entry.path());
      int width = 0;
      for (std::size_t k = 16; k < 20; ++k)
        width = 256 * width + static_cast<unsigned char>(bytes.at(k));
      EXPECT_EQ(width, 1600) << entry.path();
      ++pictures;
    }
  EXPECT_GE(pictures, 4);
  EXPECT_EQ(run_program(vasorod(solve + "10")).exit_code, 2);
}

// All but pictures and page is the same, to the byte; what is printed names no page.
TEST(Commands, WithoutAReportNumbersAndFieldsAreTheSame) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("skin");
  std::string said[2];
  for (const bool report : {true, false}) {
    const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                         (scratch / (report ? "with" : "without")).string() + "'" +
                                         (report ? "" : " --no-report")));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    said[report ? 0 : 1] = run.out;
  }
  EXPECT_NE(said[0].find("with/report.html\n"), std::string::npos) << said[0];
  EXPECT_NE(said[1].find("without/result.json\n"), std::string::npos) << said[1];
  EXPECT_EQ(said[1].find("report.html"), std::string::npos) << said[1];
  int without_page = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "with")) {
    const std::string name = entry.path().filename();
    const auto other = scratch / "without" / name;
    if (name == "report.html" || entry.path().extension() == ".png") {
      EXPECT_FALSE(std::filesystem::exists(other)) << name;
      ++without_page;
    } else if (name == "result.json") {
      auto a = nlohmann::json::parse(contents_of(entry.path())),
           b = nlohmann::json::parse(contents_of(other));
      a.erase("seconds");
      b.erase("seconds");
      EXPECT_EQ(a, b);
    } else {
      EXPECT_EQ(contents_of(entry.path()), contents_of(other)) << name;
    }
  }
  EXPECT_GT(without_page, 1);
}

// Of a factor that is large enough to be shared: GlennCoupled.ThreadsChangeNoNumber.
TEST(Commands, ThreadsChangeNoNumber) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "small.yaml") << small_glenn("coupled");
  expect_threads_change_no_number("'" + (scratch / "small.yaml").string() + "'");
  expect_threads_change_no_number("'" + source +
                                  "/benchmarks/cases/glenn/infant.yaml' --fidelity paper");
}

TEST(Commands, ABareRodTreeHasThePublishedEnergy) {
  const ScratchFolder scratch;
  const auto run =
      run_program(vasorod("solve '" + source + "/benchmarks/cases/rod/b13-tree.yaml' -o '" +
                          (scratch / "out").string() + "' --json --threads 2"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = nlohmann::json::parse(run.out);
  EXPECT_EQ(result.at("certificate").at("smallest_curvature_positive"), true);
  EXPECT_EQ(result.at("environment").at("threads"), 2);
  EXPECT_NE(result.at("environment").at("blas"), "");
  EXPECT_TRUE(result.at("iterations").contains("surface"));
  double sum = 0;
  for (const char* part : {"read", "fit", "solve", "write"})
    sum += result.at("seconds").at(part).get<double>();
  EXPECT_NEAR(result.at("seconds").at("total").get<double>(), sum, 1e-9);
  for (const auto& metrics : result.at("metrics"))
    for (const char* extreme : {"smallest_stretch", "largest_stretch", "largest_curvature"})
      EXPECT_TRUE(metrics.at("where").contains(extreme)) << metrics;
  EXPECT_NEAR(result.at("energy").at("rod").get<double>(), 3.055132910623,
              2e-3);  // case B13 T1, order 2 in the elements
}

TEST(Commands, FitWritesTheCenterlineOfABranchedVessel) {
  const ScratchFolder scratch;
  const auto run = run_program(vasorod("fit '" + source + "/meshes/infant/aorta.vtp' -o '" +
                                       (scratch / "out").string() + "'"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "aorta_centerline.vtp"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "aorta.vtp"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "report.html"));
  // Five ends, each with its centre, radius and normal; nothing about twist or contact.
  std::size_t ends = 0;
  for (std::size_t at = run.out.find("\n  end "); at != std::string::npos;
       at = run.out.find("\n  end ", at + 1))
    ++ends;
  EXPECT_EQ(ends, 5U) << run.out;
  EXPECT_NE(run.out.find("aorta: length "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("radius "), std::string::npos);
  for (const char* nothing : {"twist", "contact", "converged"})
    EXPECT_EQ(run.out.find(nothing), std::string::npos) << run.out;
}

// A vessel's name becomes the names of its files, in XML too.
TEST(Commands, FitNamesItsVesselAsASceneCould) {
  const ScratchFolder scratch;
  std::filesystem::copy(source + "/meshes/infant/svc.vtp", scratch / "a&b <c.vtp");
  const auto run = run_program(vasorod("fit '" + (scratch / "a&b <c.vtp").string() + "' -o '" +
                                       (scratch / "out").string() + "'"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(scratch / "out" / "a_b__c.vtp"));
  EXPECT_EQ(contents_of(scratch / "out" / "scene.pvd").find('&'), std::string::npos);
}

TEST(Commands, SurfacesOfOneNameInTwoFoldersAreBothListed) {
  const ScratchFolder scratch;
  const std::filesystem::path infant = source + "/meshes/infant";
  for (const std::string name : {"svc", "aorta"}) {
    std::filesystem::create_directory(scratch / name);
    std::filesystem::copy(infant / (name + ".vtp"), scratch / name / "wall.vtp");
  }
  std::ofstream(scratch / "scene.yaml")
      << "scene: two\nunits: {length: mm, stress: MPa}\nvessels:\n"
         "  - {name: svc, surface: svc/wall.vtp, wall: {thickness: 0.5, young: 1, poisson: 0.3}}\n"
         "  - {name: aorta, surface: aorta/wall.vtp, role: obstacle}\n"
         "ends:\n  - {vessel: svc, end: start, hold: true}\nfidelity: rod\n";
  const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                       (scratch / "out").string() + "' --json"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto inputs = nlohmann::json::parse(run.out).at("environment").at("inputs");
  EXPECT_EQ(inputs.size(), 3U) << inputs;
  EXPECT_NE(inputs.at("svc/wall.vtp"), inputs.at("aorta/wall.vtp"));
}

TEST(Commands, AFolderThatIsNotOursIsLeftAlone) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << pulled_tube("rod");
  std::filesystem::create_directory(scratch / "mine");
  std::ofstream(scratch / "mine" / "thesis.txt") << "years of work";
  const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                       (scratch / "mine").string() + "'"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(lines_in(run.err), 1) << run.err;
  EXPECT_EQ(contents_of(scratch / "mine" / "thesis.txt"), "years of work");
}

}  // namespace
}  // namespace vasorod::testing
