// A valid scene, and what must be refused with one sentence when a part of it is replaced.
#pragma once

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "scratch_folder.h"

namespace vasorod::testing {

inline const std::string base = R"(scene: bad
units: {length: mm, stress: MPa}
vessels:
  - name: tube
    tube: {length: 100, radius: 10}
    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}
  - name: other
    tube: {length: 50, radius: 5, position: [30, 0, 0]}
    wall: {thickness: 1.0, young: 1.0, poisson: 0.3}
ends:
  - {vessel: tube, end: start, hold: true}
  - {vessel: tube, end: end, move: [1, 0, 0]}
contact: [[tube, other]]
surgery:
  glenn: {svc: tube, rpa: other, cut: [10, 0, 50], incision: [35, 0, 25], keep: {near: [0, 0, 100]}}
fidelity: paper
)";

/// Replaces the first occurrence of `from` by `to`. The sentence must contain all of `says`.
struct Bad {
  std::string what, from, to;
  std::vector<std::string> says;
};

/// The sentence with which the file is refused; empty if it is read.
inline std::string refusal(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Scenes in files of a folder of their own.
class BadScene : public ScratchFolder {
 protected:
  void expect_refused(const std::vector<Bad>& bads) const {
    for (const Bad& bad : bads) {
      SCOPED_TRACE(bad.what);
      std::string text = base;
      ASSERT_NE(text.find(bad.from), std::string::npos);
      text.replace(text.find(bad.from), bad.from.size(), bad.to);
      const auto file = write("scene.yaml", text);
      const std::string sentence = refusal(file);
      EXPECT_EQ(sentence.rfind(file.string() + ":", 0), 0U) << sentence;
      EXPECT_NE(sentence.find("found "), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(", expected "), std::string::npos) << sentence;
      EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
      for (const std::string& word : bad.says)
        EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
    }
  }
};

}  // namespace vasorod::testing
