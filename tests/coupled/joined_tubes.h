// Two tubes with a seam between their rims, for the tests of patches and of starts near a seam.
#pragma once

#include "coupled/coupled_contacts.h"
#include "coupled/coupled_path.h"

namespace vasorod::testing {

inline constexpr int joined_around = 24, joined_along = 18;
inline constexpr double joined_length = 30, joined_radius = 6, joined_thickness = 0.6;

/// The tubes are held at their far ends, the upper one pulled up by `pull`; a third one is apart.
/// They start closed and stretched evenly, each vertex a little beside its place.
inline CoupledProblem joined_tubes(double pull = 0) {
  const HeldTube half(joined_length, joined_radius, joined_thickness, joined_around, joined_along);
  CoupledProblem problem;
  HeldSection end = half.end();
  end.motion.move = Vec3(0, 0, pull);
  add_tube(problem, half, "lower", Vec3::Zero(), {half.start()});
  add_tube(problem, half, "upper", Vec3(0, 0, joined_length), {end});
  add_tube(problem, half, "aside", Vec3(40, 0, 0), {half.start(), half.end()});
  for (const int v : half.row(0))
    problem.surfaces.seams.push_back({1, v, 0, v + joined_along * joined_around});
  carry_by_sections(problem);
  CoupledStart& start = problem.start.emplace();
  for (size_t b = 0; b < 3; ++b) {
    const Points& rest = problem.surfaces.bodies[b].rest.points;
    Points& points = start.bodies.emplace_back().points = rest;
    points.col(0).array() += 0.01;
    if (b < 2) points.col(2) *= 1 + pull / (2 * joined_length);
    start.pressure.emplace_back(Eigen::VectorXd::Zero(rest.rows()));
  }
  return problem;
}

/// Builds a stack and puts it at its problem's start, as the solver does.
inline void put_at_start(CoupledStack& stack, CoupledPath& path) {
  stack.build();
  path.restart();
  path.advance(1);
  path.start_at_given();
}

}  // namespace vasorod::testing
