// Standard streams that are closed or that nobody reads, and locales with a decimal comma.
#include <algorithm>
#include <clocale>
#include <gtest/gtest.h>
#include <locale>
#include <nlohmann/json.hpp>

#include <vasorod/predict.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "data/sentence.h"
#include "program/run_program.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

// The length has the digits and the fraction that a locale would write with its own marks.
const std::string pulled =
    "scene: pulled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - name: tube\n    tube: {length: 1234.5, radius: 45.5, around: 16, along: 40}\n"
    "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n"
    "ends:\n  - {vessel: tube, end: start, hold: true}\n"
    "  - {vessel: tube, end: end, move: [0, 0, 1.5]}\nfidelity: skin\n";

class StreamFaults : public ::testing::Test {
 protected:
  StreamFaults() { std::ofstream(scratch / "scene.yaml") << pulled; }
  std::string solve(const std::string& options = "") const {
    return vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                   (scratch / "out").string() + "' " + options);
  }
  nlohmann::json result() const {
    return nlohmann::json::parse(contents_of(scratch / "out" / "result.json"));
  }
  ScratchFolder scratch;
};

// A closed descriptor is the next one that is given out: to a file of the result.
TEST_F(StreamFaults, ClosedStreamsDoNotReachTheResult) {
  ASSERT_EQ(run_program(solve()).exit_code, 0);
  const std::string before = contents_of(scratch / "out" / "tube.vtp");
  const auto run_with = [&](const std::string& closed) {
    return run_program("sh -c \"" + solve("--json") + " " + closed + "\"");
  };
  EXPECT_EQ(run_with("<&-").exit_code, 0);
  EXPECT_EQ(run_with("2>&-").exit_code, 0);
  for (const std::string closed : {">&-", ">&- 2>&-", "<&- >&- 2>&-"}) {
    EXPECT_EQ(run_with(closed).exit_code, 3) << closed;
    EXPECT_EQ(result().at("status"), "converged");
    EXPECT_EQ(contents_of(scratch / "out" / "tube.vtp"), before);
  }
}

TEST_F(StreamFaults, APipeThatNobodyReadsIsThreeAndTheResultIsWritten) {
  // The reader ends at once, the result is far longer than a pipe holds.
  const fs::path code = scratch / "code";
  const auto run = run_program("sh -c \"(" + solve("--json --fidelity rod") + "; echo \\$? >'" +
                               code.string() + "') | true\"");
  EXPECT_EQ(contents_of(code), "3\n") << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find("standard output"), std::string::npos) << run.err;
  EXPECT_EQ(result().at("status"), "converged");
}

TEST_F(StreamFaults, AFullStandardErrorChangesNothing) {
  const auto run = run_program("sh -c \"" + solve() + " 2>/dev/full\"");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(
      run_program("sh -c \"" + vasorod("solve missing.yaml -o x") + " 2>/dev/full\"").exit_code, 2);
}

// A decimal comma and grouped digits, for every stream that is made from now on.
class Comma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(StreamFaults, ADecimalCommaOfTheCallersLocaleChangesNoFile) {
  const auto written = [&](const std::string& name) {
    Result result = predict(read_scene(scratch / "scene.yaml"), {});
    write_result_folder(result, scratch / name);
  };
  written("classic");
  // C's own, where the system has one of these.
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "nl_NL.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new Comma));  // the locale owns it
  std::ostringstream marked;
  marked << 1234.5;
  ASSERT_EQ(marked.str(), "1.234,5");
  EXPECT_EQ(number_text(1234.5), "1234.5");
  EXPECT_EQ(fixed_text(1234.5, 2), "1234.50");
  written("comma");
  std::locale::global(before);
  std::setlocale(LC_ALL, c_before.c_str());
  const auto without_seconds = [&](const std::string& name) {
    auto json = nlohmann::json::parse(contents_of(scratch / name / "result.json"));
    json.erase("seconds");
    return json;
  };
  EXPECT_EQ(without_seconds("comma"), without_seconds("classic"));
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(scratch / "classic")) {
    const std::string name = entry.path().filename().string();
    if (name == "result.json" || name == "report.html") continue;  // they state the seconds
    EXPECT_EQ(contents_of(scratch / "comma" / name), contents_of(entry.path())) << name;
    ++compared;
  }
  EXPECT_GE(compared, 4);
  EXPECT_EQ(contents_of(scratch / "comma" / "report.html").find("1.234,5"), std::string::npos);
}

TEST_F(StreamFaults, TheEnvironmentsLocaleChangesNothing) {
  ASSERT_EQ(run_program("LC_ALL=C " + solve()).exit_code, 0);
  auto c = result();
  ASSERT_EQ(run_program("LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 " + solve()).exit_code, 0);
  auto german = result();
  c.erase("seconds");
  german.erase("seconds");
  EXPECT_EQ(german, c);
}

}  // namespace
}  // namespace vasorod::testing
