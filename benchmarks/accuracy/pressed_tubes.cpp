#include "accuracy/pressed_tubes.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "accuracy/held_tube.h"
#include "geometry/triangle_surface.h"

namespace vasorod::bench {
namespace {

using std::numbers::pi;

constexpr double radius = 8, length = 60, thickness = 1.2, depth = 3, gap = 0.01,
                 cylinder_radius = 12;

// Adds a tube placed by `pose`, its ends moved by `move`.
void add_tube(CoupledProblem& problem, const HeldTube& tube, const char* name, const Pose& pose,
              const Vec3& move, bool rigid = true) {
  SurfaceBody body = body_of(tube);
  body.name = name;
  body.rest.points =
      (tube.rest.points * pose.rotation.transpose()).rowwise() + pose.position.transpose();
  CoupledVessel vessel;
  vessel.wall = wall_of(tube);
  vessel.wall.rest = body.rest;
  for (Vec3& axis : vessel.wall.axis) axis = pose.rotation * axis;
  body.fixed.assign(static_cast<std::size_t>(body.rest.points.rows()), 0);
  for (const double s : {0.0, tube.shape.length}) {
    HeldSection section = rim(tube, s);
    section.rigid = rigid;
    section.rest = {pose.rotation, pose * section.rest.position};
    section.motion.move = move;
    for (const int v : section.ring) body.fixed[static_cast<std::size_t>(v)] = rigid;
    vessel.sections.push_back(std::move(section));
  }
  problem.surfaces.bodies.push_back(std::move(body));
  problem.vessels.push_back(std::make_unique<CoupledVessel>(std::move(vessel)));
}

void add_obstacle(CoupledProblem& problem, TriangleSurface surface) {
  SurfaceBody body;
  body.name = "obstacle";
  body.rest = std::move(surface);
  body.obstacle = true;
  problem.surfaces.bodies.push_back(std::move(body));
  problem.vessels.emplace_back();
}

// Every body starts in its rest shape, moved by the common motion of its sections.
CoupledSolution solve_pressed(CoupledProblem problem, const CoupledOptions& options) {
  problem.surfaces.contacts = all_contacts(problem.surfaces.bodies);
  struct Moved {
    Points rest;
    std::vector<Vec3> centres;
    Vec3 move = Vec3::Zero();
  };
  std::vector<Moved> bodies;
  for (std::size_t b = 0; b < problem.vessels.size(); ++b) {
    bodies.push_back({problem.surfaces.bodies[b].rest.points, {}});
    if (!problem.vessels[b]) continue;
    for (const HeldSection& section : problem.vessels[b]->sections) {
      bodies.back().centres.push_back(section.rest.position);
      bodies.back().move = section.motion.move;
    }
  }
  problem.carried = [bodies](double t) {
    std::vector<CarriedBody> carried(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (bodies[b].move == Vec3::Zero()) continue;
      const Vec3 by = t * bodies[b].move;
      carried[b].points = bodies[b].rest.rowwise() + by.transpose();
      carried[b].rotations.assign(static_cast<std::size_t>(bodies[b].rest.rows()),
                                  Mat3::Identity());
      for (const Vec3& centre : bodies[b].centres)
        carried[b].sections.push_back({Mat3::Identity(), centre + by});
    }
    return carried;
  };
  return CoupledSolver(std::move(problem), options).solve();
}

PressedTubes judged(const CoupledSolution& solution, double mean_edge) {
  PressedTubes pressed;
  pressed.settled = settled(solution);
  const ContactSolution& contact = solution.surface.contacts.front();
  pressed.force = contact.force;
  const double size = contact.force.norm();
  Vec3 held = Vec3::Zero();
  bool obstacle = false;
  for (std::size_t b = 0; b < solution.sections.size(); ++b) {
    for (const SectionSolution& section : solution.sections[b]) held += section.force;
    if (solution.surface.bodies[b].modelled)
      pressed.vertices += static_cast<int>(solution.surface.bodies[b].positions.rows());
    else
      obstacle = true;
  }
  pressed.support_misfit = (held + (obstacle ? contact.force : Vec3(0, 0, 0))).norm() / size;
  pressed.newton_misfit =
      (solution.surface.bodies[0].contact + solution.surface.bodies[1].contact).norm() / size;
  pressed.penetration = std::max(0.0, -contact.smallest_gap) / mean_edge;
  return pressed;
}

}  // namespace

PressedTubes pressed_on_cylinder(int around, double stiffness) {
  const HeldTube tube(structured(length, radius, around), length, radius, thickness);
  CoupledProblem problem;
  add_tube(problem, tube, "tube", {}, Vec3(-depth, 0, 0));
  TubeSpec across;
  across.length = 60;
  across.radius = cylinder_radius;
  across.around = 144;
  across.along = 60;
  TriangleSurface cylinder = tube_surface(across);
  const double axis = -radius - thickness / 2 - gap - cylinder_radius;
  const Points p = cylinder.points;
  cylinder.points.col(0) = p.col(1).array() + axis;
  cylinder.points.col(1) = p.col(2).array() - across.length / 2;
  cylinder.points.col(2) = p.col(0).array() + length / 2;
  add_obstacle(problem, std::move(cylinder));
  CoupledOptions options;
  options.contact_stiffness = stiffness;
  const CoupledSolution solution = solve_pressed(std::move(problem), options);
  PressedTubes pressed = judged(solution, tube.mesh.edge);
  // The tube's pressures act along the normals of the cylinder.
  const BodySolution& body = solution.surface.bodies[0];
  const Eigen::VectorXd areas = vertex_areas(tube.rest);
  Vec3 sum = Vec3::Zero();
  for (const SectionSolution& section : solution.sections[0]) sum += section.force;
  for (Eigen::Index i = 0; i < areas.size(); ++i) {
    const Vec3 out(body.positions(i, 0) - axis, 0, body.positions(i, 2) - length / 2);
    sum += body.pressure[i] * areas[i] * out.normalized();
  }
  pressed.pressure_misfit = sum.norm() / pressed.force.norm();
  return pressed;
}

PressedTubes two_tubes(Meeting meeting, int around) {
  const bool rigid = meeting != Meeting::side_by_side;
  const HeldTube one(structured(length, radius, around), length, radius, thickness);
  const HeldTube other(structured(length, radius, around), length, radius, 0.8);
  CoupledProblem problem;
  const double apart = 2 * radius + 1 + gap;
  add_tube(problem, one, "one", {}, Vec3(-depth, 0, 0), rigid);
  // The other tube lies across, slightly off the middle.
  const Pose beside{Mat3::Identity(), Vec3(-apart, 0, 0)};
  const Pose across{exp_rotation(Vec3(pi / 2, 0, 0)), Vec3(-apart, 31, 29)};
  add_tube(problem, other, "other", meeting == Meeting::across ? across : beside, Vec3::Zero(),
           rigid);
  return judged(solve_pressed(std::move(problem), {}), one.mesh.edge);
}

RingOnPlate ring_on_plate(int around, double sink) {
  const double t = 0.2, width = 4;
  const HeldTube tube(structured(width, radius, around), width, radius, t, 0);
  CoupledProblem problem;
  add_tube(problem, tube, "ring", {}, Vec3(-sink - gap, 0, 0), false);
  TriangleSurface plate;
  const double x = -radius - t / 2 - gap;
  plate.points.resize(4, 3);
  plate.points << x, -30, -30, x, 30, -30, x, 30, 34, x, -30, 34;
  plate.triangles.resize(2, 3);
  plate.triangles << 0, 1, 2, 0, 2, 3;
  add_obstacle(problem, std::move(plate));
  const CoupledSolution solution = solve_pressed(std::move(problem), {});
  RingOnPlate ring;
  ring.settled = settled(solution);
  ring.vertices = static_cast<int>(tube.rest.points.rows());
  ring.force = solution.surface.contacts.front().force.x();
  ring.closed_form =
      sink * pi * (width * t * t * t / 12) / (std::pow(radius, 3) * (pi * pi / 12 - 11.0 / 16));
  ring.pressure_sum = solution.surface.bodies[0].pressure.dot(vertex_areas(tube.rest));
  return ring;
}

}  // namespace vasorod::bench
