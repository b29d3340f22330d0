// The conditions on a surface before anything is computed on it. Each check throws InputError: one
// sentence that begins with `file`, gives the coordinates of the place and says what was expected.
#pragma once

#include <string>

#include <vasorod/scene.h>
#include <vasorod/types.h>

namespace vasorod {

/// At most two triangles at an edge, in opposite directions; one fan of triangles at a point; one
/// component.
void check_manifold(const std::string& file, const TriangleSurface& surface);

/// A deformable vessel: two or more open ends of six or more edges, no handle. An obstacle may be
/// closed.
void check_ends(const std::string& file, const TriangleSurface& surface, Role role);

/// Triangles counter-clockwise seen from outside: the volume with flat lids over the ends is
/// positive.
void check_outward(const std::string& file, const TriangleSurface& surface);

/// No triangle crosses another (CGAL, exact predicates), none has zero area.
void check_self_intersections(const std::string& file, const TriangleSurface& surface);

/// Volume with a fan from each end's centre as its lid, length^3; negative for an inverted surface.
double lidded_volume(const TriangleSurface& surface);

/// Twice the volume (ends closed) over the area: the radius of a tube, 2/3 of the radius of a ball.
double typical_radius(const TriangleSurface& surface);

/// A typical radius of 0.5 to 50 mm; otherwise the message says which unit would fit.
void check_unit(const std::string& file, const TriangleSurface& surface, const Units& units);

}  // namespace vasorod
