// What every surface solver is given: bodies carried by their rods, seams between them, pairs that
// may touch.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// One vessel's surface with what its solved rod says. Sizes: one entry per vertex.
struct SurfaceBody {
  std::string name;
  TriangleSurface rest;         ///< after surgery, rest configuration
  Points carried;               ///< p' [6]; empty: the body's rod has not moved
  std::vector<Mat3> rotations;  ///< R of [8]; empty: identity
  Coefficients k;  ///< of its springs; the scale of its forces for every solver; not for obstacles
  std::vector<char> fixed;  ///< vertices of rigid ends, kept at p'; empty: none
  double thickness = 0;     ///< t, length
  double offset =
      0;  ///< from the given surface to the wall's outer face: 0 outer, t/2 mid, t inner
  bool obstacle = false;  ///< never moves, only touched
};

/// Two vertices that a seam joins.
struct SeamPair {
  int body_a = 0, vertex_a = 0;
  int body_b = 0, vertex_b = 0;
};

struct BodyProblem {
  std::vector<SurfaceBody> bodies;
  std::vector<SeamPair> seams;
  std::vector<std::pair<int, int>> contacts;  ///< pairs of bodies that may touch
};

/// Throws InputError (one sentence) where a contact names a body that does not exist.
void check_contacts(const BodyProblem& problem);

/// All pairs of bodies of which at least one is no obstacle.
std::vector<std::pair<int, int>> all_contacts(const std::vector<SurfaceBody>& bodies);

}  // namespace vasorod
