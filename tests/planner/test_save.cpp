#include <vasorod/read_scene.h>

#include "data/whole_file.h"
#include "planner/hand_made_result.h"
#include "planner/save.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

using Save = SmallScene;

std::size_t files_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST_F(Save, OnlyPlainNames) {
  for (const char* name : {"a.yaml", "Plan_2-b.v3.yaml", "_x.yaml", "9.yaml"})
    EXPECT_NO_THROW(check_name(name, ".yaml")) << name;
  for (const std::string name : {"", ".yaml", "..", "../a.yaml", "a/b.yaml", "/a.yaml", "a.yml",
                                 ".a.yaml", "-a.yaml", "a b.yaml", "a\\b.yaml", "a\nb.yaml"})
    EXPECT_EQ(refusal_of([&] { check_name(name, ".yaml"); }).status, 400) << name;
  EXPECT_EQ(refusal_of([&] { check_name(std::string("a\0.yaml", 7), ".yaml"); }).status, 400);
  EXPECT_EQ(refusal_of([&] { check_name(std::string(97, 'a') + ".yaml", ".yaml"); }).status, 400);
}

TEST_F(Save, ASavedSceneIsReadAsThePlan) {
  const auto scene = opened();
  Plan plan = *scene->plan;
  plan.cut_along = 1.0 / 3;
  const Json answer = save_scene(*scene, plan, "rod", "saved.yaml", false);
  EXPECT_EQ(answer["file"], (folder / "saved.yaml").string());
  EXPECT_TRUE(answer["note"].is_null());
  const Scene saved = read_scene(folder / "saved.yaml");
  EXPECT_EQ(saved.glenn->cut.along, 1.0 / 3);
  EXPECT_EQ(saved.fidelity, "rod");
  EXPECT_EQ(files_in(folder), 2U);
}

TEST_F(Save, AFileIsWrittenOverOnlyWhenAsked) {
  const auto scene = opened();
  write("there.yaml", "mine");
  const auto save = [&](bool overwrite) {
    save_scene(*scene, *scene->plan, "skin", "there.yaml", overwrite);
  };
  EXPECT_EQ(refusal_of([&] { save(false); }).status, 409);
  EXPECT_EQ(whole_file(folder / "there.yaml"), "mine");
  save(true);
  EXPECT_EQ(whole_file(folder / "there.yaml"), small_scene);
  std::filesystem::create_directory(folder / "dir.yaml");
  for (const bool overwrite : {false, true})
    EXPECT_EQ(
        refusal_of([&] { save_scene(*scene, *scene->plan, "skin", "dir.yaml", overwrite); }).status,
        409);
  std::filesystem::create_symlink("/nowhere/at/all", folder / "link.yaml");
  EXPECT_EQ(
      refusal_of([&] { save_scene(*scene, *scene->plan, "skin", "link.yaml", false); }).status,
      409);
  EXPECT_EQ(files_in(folder), 4U);
}

TEST_F(Save, AResultIsKeptOnce) {
  const auto stored = hand_made();
  keep_result(*stored, folder, "kept");
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "kept" / "report.html"));
  EXPECT_EQ(refusal_of([&] { keep_result(*stored, folder, "kept"); }).status, 409);
  EXPECT_EQ(refusal_of([&] { keep_result(*stored, folder, "../kept"); }).status, 400);
}

}  // namespace
}  // namespace vasorod::planner
