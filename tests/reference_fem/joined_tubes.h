// Scenes for tests of joins: a vein of radius 2 joined in a T to the middle of an artery of radius
// 2.2, and two tubes end to end.
#pragma once

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include <vasorod/read_scene.h>

namespace vasorod::fem {

inline const std::string joined_tubes_text =
    "scene: t\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - name: vein\n    tube: {length: 14, radius: 2}\n"
    "    wall: {thickness: 0.5, young: 0.5, poisson: 0.4}\n    law: neo-hookean\n"
    "  - name: artery\n    tube: {length: 20, radius: 2.2, position: [-10, 0, 10.2], tangent: [1, "
    "0, 0], normal: [0, 0, 1]}\n"
    "    wall: {thickness: 0.5, young: 0.45, poisson: 0.4}\n    law: neo-hookean\n"
    "ends:\n"
    "  - {vessel: vein, end: start, hold: true}\n"
    "  - {vessel: artery, end: start, hold: true}\n"
    "  - {vessel: artery, end: end, hold: true}\n"
    "contact: []\n"
    "surgery:\n  glenn: {svc: vein, rpa: artery, cut: [2, 0, 8], incision: [0, 0, 8], "
    "rotation_deg: 0, keep: {near: [0, 0, 0]}}\n";

/// Two tubes end to end, of radius 2 and 1.8, the second from beyond a gap of 0.5 and 0.2 aside.
inline const std::string end_to_end_text =
    "scene: e\nfidelity: coupled\nunits: {length: mm, stress: MPa}\nvessels:\n"
    "  - name: wide\n    tube: {length: 14, radius: 2}\n"
    "    wall: {thickness: 0.3, young: 0.5, poisson: 0.4}\n    law: neo-hookean\n"
    "  - name: narrow\n    tube: {length: 8, radius: 1.8, position: [0.2, 0, 8.5]}\n"
    "    wall: {thickness: 0.3, young: 0.45, poisson: 0.4}\n    law: neo-hookean\n"
    "ends:\n"
    "  - {vessel: wide, end: start, hold: true}\n"
    "  - {vessel: narrow, end: end, hold: true}\n"
    "contact: []\n"
    "surgery:\n  end_to_end:\n    rims:\n"
    "      - {vessel: wide, cut: [2, 0, 8], keep: {near: [0, 0, 0]}}\n"
    "      - {vessel: narrow, end: start}\n"
    "    rotation_deg: 10\n";

inline std::string with(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

inline Scene scene_of_text(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      (std::string("vasorod_join_") +
       ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml");
  std::ofstream(file) << text;
  Scene scene = read_scene(file);
  std::filesystem::remove(file);
  return scene;
}

}  // namespace vasorod::fem
