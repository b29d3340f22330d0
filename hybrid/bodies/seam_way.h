// The way of a vessel that has to fold, from rest to its seam.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// A body as its rod carries it, from rest.
struct CarriedBody {
  Points points;                ///< p'; empty: at rest
  std::vector<Mat3> rotations;  ///< per vertex, from rest; empty: identity
  /// Per section: rotation from rest, position of its point; empty: at rest.
  std::vector<Pose> sections;
};

/// The way of a seam's first vertices to its second ones, for a vessel that has to fold: a closed
/// start of it would lie through itself, where contact cannot part walls.
struct SeamWay {
  /// Offset of each pair of the seam at time t (joining_energy.h), length; at time 1 zero.
  std::function<std::vector<Vec3>(double t)> offsets;
  double step = 1;  ///< longest step of the time
  /// The sentence for the certificate of a way that came to its end.
  static std::string note(int steps) {
    return "the seam was brought together along a way of " + std::to_string(steps) +
           " steps, as the vessel folds";
  }
};

}  // namespace vasorod
