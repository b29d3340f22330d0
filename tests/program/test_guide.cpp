// The commands of docs/guide.md do what the page says.
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

#include "program/run_program.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

// The lines of each fenced block in the section.
std::vector<std::vector<std::string>> blocks_of(const std::string& page,
                                                const std::string& section) {
  std::vector<std::vector<std::string>> blocks;
  std::istringstream text(page.substr(page.find("\n" + section + "\n") + section.size() + 2));
  bool inside = false;
  for (std::string line; std::getline(text, line) && !line.starts_with("## ");) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.emplace_back();
    } else if (inside) {
      blocks.back().push_back(line);
    }
  }
  return blocks;
}

TEST(Guide, TheCommandsFromSurfacesToASceneRun) {
  const fs::path source = VASOROD_SOURCE_DIR;
  const auto blocks =
      blocks_of(contents_of(source / "docs" / "guide.md"), "## From surfaces to a scene");
  ASSERT_EQ(blocks.size(), 2u);
  const ScratchFolder scratch;
  fs::create_symlink(source / "meshes", scratch / "meshes");
  std::string said;
  for (const std::string& command : blocks[0]) {
    ASSERT_TRUE(command.starts_with("vasorod ")) << command;
    const ProgramRun run = run_program("cd '" + (scratch / "").string() + "' && " +
                                       vasorod(command.substr(std::string("vasorod ").size())));
    EXPECT_EQ(run.exit_code, 0) << command << '\n' << run.err;
    said += run.out;
  }
  EXPECT_TRUE(fs::exists(scratch / "results" / "svc" / "report.html"));
  EXPECT_TRUE(fs::exists(scratch / "results" / "plan" / "report.html"));
  EXPECT_TRUE(fs::exists(scratch / "results" / "plan" / "picture_axial_stretch.png"));
  // The second block is from what `init` says; "..." stands for the rest of a line.
  for (const std::string& line : blocks[1])
    EXPECT_NE(said.find(line.substr(0, line.find(" ..."))), std::string::npos) << line;
}

}  // namespace
}  // namespace vasorod::testing
