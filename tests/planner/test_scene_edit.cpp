#include <yaml-cpp/yaml.h>

#include <vasorod/error.h>

#include "planner/scene_edit.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

const SceneEdit cut_and_tilt{{{"cut", "{along: 0.8}"}, {"cut_tilt_deg", "5"}}, "paper"};

// What a text means, with sorted keys: an order of its own, so that only values count.
std::string meaning(const YAML::Node& node) {
  if (node.IsMap()) {
    std::map<std::string, std::string> sorted;
    for (const auto& entry : node) sorted[entry.first.Scalar()] = meaning(entry.second);
    std::string text = "{";
    for (const auto& [key, value] : sorted) text += key + ":" + value + ",";
    return text + "}";
  }
  if (node.IsSequence()) {
    std::string text = "[";
    for (const auto& item : node) text += meaning(item) + ",";
    return text + "]";
  }
  return node.IsNull() ? "~" : "'" + node.Scalar() + "'";
}

// Every value but those of the plan is as before, and those of the plan are the new ones.
void expect_only_the_plan_changed(const std::string& before, const EditedScene& edited) {
  YAML::Node old = YAML::Load(before), now = YAML::Load(edited.text);
  EXPECT_EQ(now["surgery"]["glenn"]["cut"]["along"].as<double>(), 0.8);
  EXPECT_EQ(now["surgery"]["glenn"]["cut_tilt_deg"].as<double>(), 5);
  EXPECT_EQ(now["fidelity"].Scalar(), "paper");
  EXPECT_FALSE(now["accuracy"].IsDefined());
  for (YAML::Node* tree : {&old, &now}) {
    YAML::Node glenn = YAML::Clone((*tree)["surgery"]["glenn"]), rest = YAML::Clone(*tree);
    glenn.remove("cut");
    glenn.remove("cut_tilt_deg");
    for (const char* key : {"fidelity", "accuracy", "surgery"}) rest.remove(key);
    (*tree) = YAML::Load("[]");
    (*tree).push_back(glenn);
    (*tree).push_back(rest);
  }
  EXPECT_EQ(meaning(now), meaning(old)) << edited.text;
}

TEST(SceneEdit, LineByLine) {
  const EditedScene edited = edited_scene(small_scene, cut_and_tilt);
  EXPECT_FALSE(edited.note);
  std::string wanted = with(small_scene, "cut: [3.3, 0, 10]        # above the artery",
                            "cut: {along: 0.8}        # was: above the artery");
  wanted = with(wanted, "incision: [0, 0, 4]\n", "incision: [0, 0, 4]\n    cut_tilt_deg: 5\n");
  wanted = with(wanted, "fidelity: skin   # quick", "fidelity: paper  # was: quick");
  EXPECT_EQ(edited.text, wanted);
  // A second edit does not say it twice.
  const EditedScene again = edited_scene(edited.text, {{{"cut", "{along: 0.7}"}}, std::nullopt});
  EXPECT_EQ(again.text, with(wanted, "{along: 0.8}", "{along: 0.7}"));
}

TEST(SceneEdit, NothingToChangeChangesNothing) {
  const EditedScene edited = edited_scene(small_scene, {});
  EXPECT_EQ(edited.text, small_scene);
  EXPECT_FALSE(edited.note);
}

TEST(SceneEdit, ValuesOfSeveralLines) {
  const std::string text = with(small_scene, "incision: [0, 0, 4]\n",
                                "incision:   # on top\n      along: 0.5\n"
                                "      # measured in the scan\n      around_deg: 0\n");
  const EditedScene edited =
      edited_scene(text, {{{"incision", "{along: 0.4, around_deg: 3}"}}, std::nullopt});
  EXPECT_FALSE(edited.note);
  EXPECT_EQ(edited.text, with(small_scene, "incision: [0, 0, 4]\n",
                              "incision: {along: 0.4, around_deg: 3}  # was: on top\n"
                              "      # measured in the scan\n"));
}

TEST(SceneEdit, OtherWaysToWriteAScene) {
  const std::string head = small_scene.substr(0, small_scene.find("scene: small"));
  const auto with_block = [](const char* from, const std::string& block) {
    const std::size_t at = small_scene.find(from);
    return with(small_scene, small_scene.substr(at, small_scene.find("fidelity") - at), block);
  };
  const std::string flow =
      with_block("  glenn:",
                 "  glenn: {svc: svc, rpa: rpa, cut: [3.3, 0, 10], incision: [0, 0, 4],\n"
                 "          keep: {near: [0, 0, 45]}}  # flow\n");
  const std::string of_flow = with_block(
      "surgery:",
      "surgery: {glenn: {svc: svc, rpa: rpa, cut: [3.3, 0, 10], incision: [0, 0, 4], keep: "
      "end}}\n");
  const std::string anchored =
      with(with(small_scene, "{near: [0, 0, 45]}", "&kept {near: [0, 0, 45]}"), "svc, end: end,",
           "svc, end: end, note: 1,");
  const std::string shared = with(with(small_scene, "  glenn:\n", "  glenn: &all\n"),
                                  "fidelity: skin", "study: *all\nfidelity: skin");
  const std::string first = with(with(small_scene, "fidelity: skin   # quick\n", ""),
                                 "scene: small", "fidelity: skin\nscene: small");
  const std::string accuracy = with(small_scene, "fidelity: skin   # quick", "accuracy: 0.01");
  const std::string quoted = with(small_scene, "    cut: [", "    'cut': [");
  const std::string hash = with(small_scene, "scene: small", "scene: 'a # b'");
  const std::string whole_flow =
      "{scene: x, units: {length: mm}, vessels: [], surgery: {glenn: {cut: [1, 2, 3], incision: "
      "[1, 2, 3]}}, fidelity: skin}";
  for (const std::string& text :
       {small_scene, flow, of_flow, anchored, shared, first, accuracy, quoted, hash, whole_flow}) {
    const EditedScene edited = edited_scene(text, cut_and_tilt);
    expect_only_the_plan_changed(text, edited);
    // The lines of other blocks stay, whatever has to be written anew.
    if (text != whole_flow && text != shared) {
      EXPECT_TRUE(edited.text.starts_with(head)) << edited.text;
    }
  }
  EXPECT_TRUE(edited_scene(flow, cut_and_tilt).note);
  EXPECT_TRUE(edited_scene(whole_flow, cut_and_tilt).note);
  EXPECT_FALSE(edited_scene(accuracy, cut_and_tilt).note);
}

TEST(SceneEdit, WindowsLinesStayWindowsLines) {
  std::string text;
  for (const char c : small_scene) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const EditedScene edited = edited_scene(text, cut_and_tilt);
  EXPECT_FALSE(edited.note);
  expect_only_the_plan_changed(text, edited);
  for (std::size_t at = edited.text.find('\n'); at != std::string::npos;
       at = edited.text.find('\n', at + 1))
    EXPECT_EQ(edited.text[at - 1], '\r');
}

TEST(SceneEdit, WhatIsNoSuchSceneIsSaid) {
  for (const char* text : {"", "[", "scene: x", "surgery: 3", "surgery: {end_to_end: {}}"})
    EXPECT_THROW(edited_scene(text, cut_and_tilt), InputError) << text;
}

}  // namespace
}  // namespace vasorod::planner
