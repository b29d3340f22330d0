#include <gtest/gtest.h>
#include <set>

#include <vasorod/read_scene.h>

#include "explore/option_names.h"
#include "program/small_glenn.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

class OptionNamesTest : public ScratchFolder {
 protected:
  // The name of the first option of the scene's text.
  std::string name_of(const std::string& text, const std::string& hash = "0") const {
    const Scene scene = read_scene(write("scene.yaml", text));
    const OptionNames names(scene, {{"svc.vtp", hash}, {"scene.yaml", "of no account"}});
    return names.of(options_of(scene, {}).front());
  }
};

std::string changed(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST_F(OptionNamesTest, ChangeWithWhatNumbersDependOnAndWithNothingElse) {
  const std::string scene = small_glenn("skin") + "explore: {rotation_deg: [10, 20]}\n";
  const std::string name = name_of(scene);
  EXPECT_EQ(name.size(), 16U);
  EXPECT_EQ(name.find_first_not_of("0123456789abcdef"), std::string::npos);
  // The same numbers.
  EXPECT_EQ(name_of("# a comment\n" + scene), name);
  EXPECT_EQ(name_of(changed(scene, "fidelity: skin", "fidelity: coupled")), name);
  EXPECT_EQ(name_of(changed(scene, "[10, 20]", "[10, 30, 40], best: 3, weights: {mouth: 2}")),
            name);
  // Other numbers.
  EXPECT_NE(name_of(changed(scene, "[10, 20]", "[11, 20]")), name);
  EXPECT_NE(name_of(changed(scene, "young: 0.5", "young: 0.6")), name);
  EXPECT_NE(name_of(changed(scene, "cut: [3.3, 0, 10]", "cut: [3.3, 0, 11]")), name);
  EXPECT_NE(name_of(scene, "1"), name);
}

TEST_F(OptionNamesTest, OfASceneWithoutAFileChangeWithItsText) {
  const std::string text = small_glenn("skin") + "explore: {rotation_deg: [10, 20]}\n";
  const auto name_of_text = [](const std::string& one) {
    const Scene scene = read_scene_text(one);
    return OptionNames(scene, {}).of(options_of(scene, {}).front());
  };
  EXPECT_EQ(name_of_text("# a comment\n" + text), name_of_text(text));
  EXPECT_NE(name_of_text(changed(text, "young: 0.5", "young: 0.6")), name_of_text(text));
}

TEST_F(OptionNamesTest, DependOnASurfacesBytesAndNotOnItsFolder) {
  const std::string tail = "explore: {rotation_deg: [10, 20]}\n";
  const auto scene = [&](const std::string& a, const std::string& b) {
    return "vessels: [{name: a, surface: " + a + "}, {name: b, surface: " + b + "}]\n" + tail;
  };
  Scene any = read_scene_text(small_glenn("skin") + tail);
  const Option option = options_of(any, {}).front();
  const auto name_of_text = [&](const std::string& text, const std::string& hash = "0") {
    any.text = text;
    return OptionNames(any, {{"a.vtp", hash}}).of(option);
  };
  const std::string name = name_of_text(scene("one/a.vtp", "b.vtp"));
  EXPECT_EQ(name_of_text(scene("/elsewhere/a.vtp", "two/b.vtp")), name);
  EXPECT_NE(name_of_text(scene("one/a.vtp", "b.vtp"), "1"), name);
  EXPECT_NE(name_of_text(scene("one/c.vtp", "b.vtp")), name);
  // Of one name in two folders, which is which counts.
  EXPECT_NE(name_of_text(scene("one/a.vtp", "two/a.vtp")),
            name_of_text(scene("two/a.vtp", "one/a.vtp")));
}

TEST_F(OptionNamesTest, DifferBetweenTheOptionsOfAScene) {
  const Scene scene = read_scene(write(
      "scene.yaml", small_glenn("skin") + "explore: {cut_along: {from: 0.1, to: 0.9, steps: 30}, "
                                          "rotation_deg: {from: -90, to: 90, steps: 30}}\n"));
  const OptionNames names(scene, {});
  std::set<std::string> all;
  const auto options = options_of(scene, {});
  for (const Option& option : options) all.insert(names.of(option));
  EXPECT_EQ(all.size(), options.size());
}

}  // namespace
}  // namespace vasorod::testing
