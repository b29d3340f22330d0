// Two straight tubes whose every place can be written down: the vein of radius 3.3 stands on the z
// axis from z = 5 to 45, the artery of radius 4 lies on the x axis from -25 to 25.
#pragma once

#include <memory>
#include <string>

#include "planner/opened_scene.h"
#include "planner/solve_jobs.h"
#include "scratch_folder.h"

namespace vasorod::planner {

inline const std::string small_scene = R"(# the head of the file
scene: small
units: {length: mm, stress: MPa}   # as in the paper
vessels:
  - name: svc
    tube: {length: 40, radius: 3.3, around: 24, along: 50, position: [0, 0, 5]}
    wall: {thickness: 0.4, young: 0.5, poisson: 0.45}
  - name: rpa
    tube: {length: 50, radius: 4, around: 28, along: 60, position: [-25, 0, 0], tangent: [1, 0, 0],
           normal: [0, 0, 1]}
    wall: {thickness: 0.45, young: 0.45, poisson: 0.45}
ends:
  - {vessel: svc, end: end, hold: true}
  - {vessel: rpa, end: start, hold: true}
  - {vessel: rpa, end: end, hold: true}
surgery:
  # the operation
  glenn:
    svc: svc
    rpa: rpa
    cut: [3.3, 0, 10]        # above the artery
    incision: [0, 0, 4]
    keep: {near: [0, 0, 45]}
fidelity: skin   # quick
)";

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
