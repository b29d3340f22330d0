// The scene of small.yaml, opened.
#pragma once

#include <memory>
#include <string>

#include "data/whole_file.h"
#include "planner/opened_scene.h"
#include "planner/solve_jobs.h"
#include "scratch_folder.h"

namespace vasorod::planner {

inline const std::string small_scene = whole_file(VASOROD_SOURCE_DIR "/tests/planner/small.yaml");

/// `text` with one part replaced by another.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

class SmallScene : public ScratchFolder {
 protected:
  std::shared_ptr<const OpenedScene> opened(const std::string& text = small_scene) {
    return open_scene("s1", write("small.yaml", text));
  }
};

/// The status and the sentence of what is refused.
template <class Work>
Refusal refusal_of(Work&& work) {
  try {
    work();
  } catch (const Refusal& refusal) {
    return refusal;
  }
  ADD_FAILURE() << "nothing was refused";
  return {0, ""};
}

}  // namespace vasorod::planner
