// A small Glenn shunt of two generated tubes, in the model's range and solved within seconds.
#pragma once

#include <string>

namespace vasorod::testing {

inline std::string small_glenn(const std::string& fidelity) {
  return R"(scene: small-glenn
units: {length: mm, stress: MPa}
vessels:
  - name: svc
    tube: {length: 40, radius: 3.3, around: 24, along: 50, position: [0, 0, 5]}
    wall: {thickness: 0.4, young: 0.5, poisson: 0.45}
  - name: rpa
    tube: {length: 50, radius: 4, around: 28, along: 60, position: [-25, 0, 0], tangent: [1, 0, 0], normal: [0, 0, 1]}
    wall: {thickness: 0.45, young: 0.45, poisson: 0.45}
ends:
  - {vessel: svc, end: end, hold: true}
  - {vessel: rpa, end: start, hold: true}
  - {vessel: rpa, end: end, hold: true}
surgery:
  glenn: {svc: svc, rpa: rpa, cut: [3.3, 0, 10], incision: [0, 0, 4], keep: {near: [0, 0, 45]}}
fidelity: )" +
         fidelity + "\n";
}

}  // namespace vasorod::testing
