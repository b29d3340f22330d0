// Tubes pressed onto other bodies, for the tests of contact in the coupled minimum.
#pragma once

#include "coupled/held_tubes.h"

namespace vasorod::testing {

inline SurfaceBody body_of(const HeldTube& tube, const std::string& name, const Points& points) {
  SurfaceBody body;
  body.name = name;
  body.rest = {points, tube.surface.triangles};
  body.thickness = tube.wall.thickness[0];
  body.offset = body.thickness / 2;
  body.k = {1, 0.1, 0.4 * body.thickness};
  return body;
}

/// Adds a tube rotated by `turn`, then moved by `shift`, with the given sections (relative to the
/// tube along z from the origin).
inline void add_tube(CoupledProblem& problem, const HeldTube& tube, const std::string& name,
                     const Vec3& shift, std::vector<HeldSection> sections,
                     const Mat3& turn = Mat3::Identity()) {
  const Points points = (tube.surface.points * turn.transpose()).rowwise() + shift.transpose();
  problem.surfaces.bodies.push_back(body_of(tube, name, points));
  std::vector<char>& fixed = problem.surfaces.bodies.back().fixed;
  fixed.assign(static_cast<size_t>(points.rows()), 0);
  for (const HeldSection& s : sections)
    for (const int v : s.ring) fixed[static_cast<size_t>(v)] = s.rigid;
  WallInput wall = tube.wall;
  wall.rest.points = points;
  for (Vec3& axis : wall.axis) axis = turn * axis;
  for (HeldSection& s : sections) s.rest = {turn, turn * s.rest.position + shift};
  problem.vessels.push_back(
      std::make_unique<CoupledVessel>(CoupledVessel{std::move(wall), std::move(sections)}));
}

inline void add_obstacle(CoupledProblem& problem, const std::string& name,
                         const TriangleSurface& surface) {
  SurfaceBody body;
  body.name = name;
  body.rest = surface;
  body.obstacle = true;
  problem.surfaces.bodies.push_back(std::move(body));
  problem.vessels.emplace_back();
}

/// Starts every body in its rest shape, moved with its sections. All sections of a body must have
/// the same motion.
inline void carry_by_sections(CoupledProblem& problem) {
  std::vector<CarriedBody> full;
  std::vector<Vec3> moves;
  for (size_t b = 0; b < problem.vessels.size(); ++b)
    moves.push_back(problem.vessels[b] ? problem.vessels[b]->sections.front().motion.move
                                       : Vec3(0, 0, 0));
  std::vector<Points> rest;
  std::vector<std::vector<Vec3>> centers(problem.vessels.size());
  for (size_t b = 0; b < problem.vessels.size(); ++b) {
    rest.push_back(problem.surfaces.bodies[b].rest.points);
    if (problem.vessels[b])
      for (const HeldSection& s : problem.vessels[b]->sections)
        centers[b].push_back(s.rest.position);
  }
  problem.carried = [=](double t) {
    std::vector<CarriedBody> bodies(rest.size());
    for (size_t b = 0; b < rest.size(); ++b) {
      if (moves[b] == Vec3::Zero()) continue;
      bodies[b].points = rest[b].rowwise() + (t * moves[b]).transpose();
      bodies[b].rotations.assign(static_cast<size_t>(rest[b].rows()), Mat3::Identity());
      for (const Vec3& c : centers[b])
        bodies[b].sections.push_back({Mat3::Identity(), c + t * moves[b]});
    }
    return bodies;
  };
}

/// A plate in the plane x = height, its front towards +x.
inline TriangleSurface plate(double height, double half_width, double z0, double z1) {
  TriangleSurface s;
  s.points.resize(4, 3);
  s.points << height, -half_width, z0, height, half_width, z0, height, half_width, z1, height,
      -half_width, z1;
  s.triangles.resize(2, 3);
  s.triangles << 0, 1, 2, 0, 2, 3;
  return s;
}

}  // namespace vasorod::testing
