// Geometry of a link at its strain and stress, for one linear step: first and second derivative of
// log(g_i^-1 g_j), in one pass and without transcendental functions for small angles.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// At xi = (v, u) and stress s, all in the second node's body axes.
struct LinkGeometry {
  Mat3 j, b;  ///< right Jacobian Jr(xi) = (j, b; 0, j): d log = Jr^-1 d(body twist)
  /// Geometric stiffness (0, g12; g12^T, g22): the symmetric part of Jr^T d(Jr^-T s)/d xi.
  Mat3 g12, g22;
  Vec3 force, moment;  ///< Jr^-T s: wrench of the stress on the second node
};

LinkGeometry link_geometry(const Vec6& xi, const Vec6& stress);

}  // namespace vasorod
