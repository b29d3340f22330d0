// Small bodies that mark places in a picture.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// A closed sphere, 16 points around.
TriangleSurface ball(const Vec3& centre, double radius);

/// An open prism of eight sides from one point to another; they must differ.
TriangleSurface stick(const Vec3& from, const Vec3& to, double radius);

}  // namespace vasorod
