// A ring under pressure from outside, which collapses and touches itself.
#pragma once

#include "coupled/coupled_problem.h"

namespace vasorod::bench {

/// A tube as thin as a ring with the pressure q D / R^3 from outside, between soft sections. R 10,
/// t 0.2, E 1, nu 0. Its faces touch where the middle surfaces do. It is oval by 2e-4 of its
/// radius, which decides the direction in which it collapses and moves its areas by 0.1 %.
class CollapsedRing {
 public:
  static constexpr double length = 2.3;

  explicit CollapsedRing(int around = 96);

  CoupledProblem under(double q) const;
  /// In steps of half a collapse pressure (q = 3). `guarded`: of CoupledProblem.
  CoupledSolution at(double q, bool guarded = false) const;

  /// The points of the middle section.
  Points middle(const CoupledSolution& solution) const;
  /// Area inside the middle section over that of the ring at rest.
  double area_ratio(const CoupledSolution& solution) const;

  const int around;  ///< points; four strips, near-equilateral for 96

 private:
  TriangleSurface rest_;
};

/// Areas over the circle's of Flaherty, Keller and Rubinow 1972, computed anew. Opposite walls
/// touch in a point at q = 5.24689, along a line from 10.3360 on; from there the area goes as
/// q^(-2/3).
double published_area(double q);

}  // namespace vasorod::bench
