// Input of every surface solver: bodies placed by their rods, seams between bodies, and pairs of
// bodies that may touch.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// The surface of one vessel with the placement given by its solved rod. All arrays have one entry
/// per vertex.
struct SurfaceBody {
  std::string name;
  TriangleSurface rest;  ///< after surgery, rest configuration
  /// p' [6]: positions to which the rod's sections move the vertices; empty: the rod has not moved.
  Points carried;
  std::vector<Mat3> rotations;  ///< R of [8]; empty: identity
  /// Coefficients of its springs; every solver scales the body's forces by them. Unused for
  /// obstacles.
  Coefficients k;
  std::vector<char> fixed;  ///< vertices of rigid ends, kept at p'; empty: none
  double thickness = 0;     ///< t, length
  /// Distance from the given surface to the outer face of the wall: 0 outer, t/2 mid, t inner
  /// surface.
  double offset = 0;
  bool obstacle = false;  ///< does not move; other bodies can touch it
  bool edged = false;     ///< an obstacle whose edges pass between the vertices of a wall
  /// Its rim is on its way to its seam: vertices of an obstacle with `edged` that are behind it do
  /// not touch the wall.
  bool open_mouth = false;
};

/// Two vertices that a seam joins.
struct SeamPair {
  int body_a = 0, vertex_a = 0;
  int body_b = 0, vertex_b = 0;
};

/// Bodies, seams and pairs of bodies that may touch.
struct BodyProblem {
  std::vector<SurfaceBody> bodies;
  std::vector<SeamPair> seams;
  /// Pairs of bodies that may touch; a body and itself: its wall may touch itself.
  std::vector<std::pair<int, int>> contacts;

  /// Whether two different bodies may touch.
  bool may_meet() const;
};

/// Throws InputError (one sentence) where a contact names a body that does not exist.
void check_contacts(const BodyProblem& problem);

/// All pairs of bodies except pairs of two obstacles; none of a body and itself.
std::vector<std::pair<int, int>> all_contacts(const std::vector<SurfaceBody>& bodies);

/// Every body that is no obstacle with itself.
std::vector<std::pair<int, int>> self_contacts(const std::vector<SurfaceBody>& bodies);

}  // namespace vasorod
