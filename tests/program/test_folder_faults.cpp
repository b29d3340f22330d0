// What happens to a result folder when the program is killed, the disk is full or read-only, or
// somebody else writes there: the folder holds one whole result, the old or the new.
#include <algorithm>
#include <chrono>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "program/run_program.h"
#include "program/running_program.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

std::string scene(const std::string& fidelity) {
  return "scene: pulled\nunits: {length: mm, stress: MPa}\nvessels:\n"
         "  - name: tube\n    tube: {length: 60, radius: 6, around: 16, along: 24}\n"
         "    wall: {thickness: 0.6, young: 1.0, poisson: 0.3}\n"
         "ends:\n  - {vessel: tube, end: start, hold: true}\n"
         "  - {vessel: tube, end: end, move: [0, 0, 1]}\nfidelity: " +
         fidelity + "\n";
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

class FolderFaults : public ::testing::Test {
 protected:
  FolderFaults() {
    for (const std::string fidelity : {"rod", "skin"}) {
      std::ofstream(scratch / (fidelity + ".yaml")) << scene(fidelity);
      EXPECT_EQ(run_program(vasorod(solve(fidelity, scratch / ("whole-" + fidelity)))).exit_code,
                0);
    }
  }
  std::string solve(const std::string& fidelity, const fs::path& folder) const {
    return "solve '" + (scratch / (fidelity + ".yaml")).string() + "' --threads 1 -o '" +
           folder.string() + "'";
  }
  std::vector<std::string> words(const std::string& fidelity, const fs::path& folder) const {
    return {"solve",        (scratch / (fidelity + ".yaml")).string(), "--threads", "1", "-o",
            folder.string()};
  }
  // A copy of the whole result of a fidelity, as the old result.
  fs::path old_result(const std::string& fidelity, const std::string& name = "out/result") const {
    fs::path folder = scratch / name;
    fs::remove_all(folder.parent_path());
    fs::create_directories(folder.parent_path());
    fs::copy(scratch / ("whole-" + fidelity), folder, fs::copy_options::recursive);
    return folder;
  }
  // The fidelity of the result in `folder`, which must be whole: the files of an undisturbed run,
  // the fields byte by byte, and documents that end where they should.
  std::string whole_result(const fs::path& folder) const {
    const auto json = nlohmann::json::parse(contents_of(folder / "result.json"), nullptr, false);
    if (json.is_discarded()) {
      ADD_FAILURE() << folder << ": a damaged result.json";
      return "";
    }
    std::string fidelity = json.at("fidelity");
    const fs::path reference = scratch / ("whole-" + fidelity);
    EXPECT_EQ(names_in(folder), names_in(reference));
    for (const std::string& name : names_in(reference)) {
      if (!name.ends_with(".vtp") && !name.ends_with(".png")) continue;
      EXPECT_EQ(contents_of(folder / name), contents_of(reference / name)) << name;
    }
    const std::string page = contents_of(folder / "report.html");
    EXPECT_NE(page.rfind("</html>"), std::string::npos);
    return fidelity;
  }
  static bool has_sibling(const fs::path& folder) {
    return names_in(folder.parent_path()).size() > 1;
  }
  static void expect_refusal(const ProgramRun& run, const std::string& words) {
    EXPECT_EQ(run.exit_code, 3) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  }
  ScratchFolder scratch;
};

// At a random time of the whole run, and at a random time after it began to write.
TEST_F(FolderFaults, KilledAtAnyTimeTheOldOrTheNewResultIsWhole) {
  const auto begin = std::chrono::steady_clock::now();
  const fs::path out = old_result("rod");
  ASSERT_EQ(run_program(vasorod(solve("skin", out))).exit_code, 0);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - begin);
  std::mt19937 random(11);
  for (int round = 0; round < 24; ++round) {
    old_result("rod");
    RunningProgram program(words("skin", out));
    if (round % 2 == 0) {
      std::uniform_int_distribution<long> time(0, whole.count());
      std::this_thread::sleep_for(std::chrono::microseconds(time(random)));
    } else {
      for (int i = 0; i < 5000 && !has_sibling(out); ++i)
        std::this_thread::sleep_for(milliseconds(1));
      std::this_thread::sleep_for(std::chrono::microseconds(random() % 20'000));
    }
    program.kill_now();
    const std::string fidelity = whole_result(out);
    EXPECT_TRUE(fidelity == "rod" || fidelity == "skin") << fidelity;
  }
  // What the killed runs left beside it goes with the next run that ends.
  ASSERT_EQ(run_program(vasorod(solve("skin", out))).exit_code, 0);
  EXPECT_FALSE(has_sibling(out));
  EXPECT_EQ(whole_result(out), "skin");
}

TEST_F(FolderFaults, AFileThatGrowsTooLargeLeavesTheOldResult) {
  const fs::path out = old_result("rod");
  // 8 blocks of 512 bytes, less than the surface needs; the signal that comes with the limit would
  // end the program.
  expect_refusal(run_program("sh -c \"ulimit -f 8; " + vasorod(solve("skin", out)) + "\""),
                 "cannot be written");
  EXPECT_EQ(whole_result(out), "rod");
  EXPECT_FALSE(has_sibling(out));
}

// The command for a shell whose mounts end with it: root may mount, others in a namespace of users
// of their own. Empty where neither is allowed.
std::string own_mounts() {
  for (const char* command : {"unshare -m", "unshare -rm"})
    if (run_program(std::string(command) + " sh -c 'mount -t tmpfs none /mnt'").exit_code == 0)
      return command;
  return "";
}

TEST_F(FolderFaults, AFullDiskLeavesTheOldResult) {
  const std::string mounting = own_mounts();
  if (mounting.empty()) GTEST_SKIP() << "a small disk is a mount, which this user may not make";
  const fs::path disk = scratch / "disk";
  fs::create_directories(disk);
  const std::string old = (scratch / "whole-rod").string(), at = disk.string();
  // Filled up but for 40 kB, less than the new result needs.
  const auto run =
      run_program(mounting + " sh -c \"mount -t tmpfs -o size=4m none '" + at + "' && cp -r '" +
                  old + "' '" + at + "/result' && head -c 100000000 /dev/zero >'" + at +
                  "/filled' 2>/dev/null; truncate " + "-s -40960 '" + at + "/filled'; " +
                  vasorod(solve("skin", disk / "result")) + "; code=\\$?; diff -r '" + old + "' '" +
                  at + "/result' >&2; ls -A '" + at + "'; exit \\$code\"");
  expect_refusal(run, "No space left on device");
  EXPECT_EQ(run.out, "filled\nresult\n");
}

TEST_F(FolderFaults, AReadOnlyPlaceIsRefusedBeforeTheSolve) {
  const fs::path out = old_result("rod");
  const std::string parent = out.parent_path().string();
  ProgramRun run;
  if (geteuid() == 0) {  // whom permissions do not stop
    const std::string mounting = own_mounts();
    if (mounting.empty()) GTEST_SKIP() << "root may write anywhere, and cannot mount here";
    run = run_program(mounting + " sh -c \"mount --bind '" + parent + "' '" + parent +
                      "' && mount -o remount,bind,ro '" + parent + "' && " +
                      vasorod(solve("skin", out)) + "\"");
  } else {
    fs::permissions(parent, fs::perms::owner_read | fs::perms::owner_exec);
    run = run_program(vasorod(solve("skin", out)));
    fs::permissions(parent, fs::perms::owner_all);
  }
  expect_refusal(run, "cannot be written to");
  EXPECT_EQ(whole_result(out), "rod");
}

TEST_F(FolderFaults, OfTwoWritersOneResultStaysWhole) {
  const fs::path out = scratch / "out/result";
  for (int round = 0; round < 6; ++round) {
    if (round % 2 == 0)
      fs::remove_all(out.parent_path());
    else
      old_result("rod");
    RunningProgram first(words("rod", out)), second(words("skin", out));
    EXPECT_EQ(first.wait(), 0);
    EXPECT_EQ(second.wait(), 0);
    EXPECT_NE(whole_result(out), "");
    EXPECT_FALSE(has_sibling(out));
  }
}

TEST_F(FolderFaults, ForeignThingsInAFormerResultAreNamedAndKept) {
  const std::vector<std::function<void(const fs::path&)>> foreign{
      [](const fs::path& folder) { std::ofstream(folder / "notes.txt") << "mine"; },
      [](const fs::path& folder) { fs::create_directory(folder / "figures"); },
      [](const fs::path& folder) { fs::create_symlink("/etc/hostname", folder / "more.vtp"); },
      [](const fs::path& folder) { std::ofstream(folder / "result.json") << "{\"schema\": 1}"; },
      [](const fs::path& folder) { fs::remove(folder / "result.json"); }};
  for (const auto& change : foreign) {
    const fs::path out = old_result("rod");
    change(out);
    const std::set<std::string> before = names_in(out);
    expect_refusal(run_program(vasorod(solve("skin", out))), "expected");
    EXPECT_EQ(names_in(out), before);
    EXPECT_FALSE(has_sibling(out));
  }
}

}  // namespace
}  // namespace vasorod::testing
