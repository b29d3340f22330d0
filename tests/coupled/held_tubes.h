// Tubes held at both ends, for the tests of the coupled minimum.
#pragma once

#include <numbers>

#include <vasorod/tube.h>

#include "coupled/coupled_problem.h"
#include "geometry/rigid_motion.h"
#include "straight_tube.h"

namespace vasorod::testing {

/// A generated tube along z with its wall. E = 1.
struct HeldTube {
  TubeSpec tube;
  TriangleSurface surface;
  WallInput wall;
  HeldTube(double length, double radius, double thickness, int around, int along,
           double poisson = 0.3)
      : tube(straight_tube(length, radius, around, along)), surface(tube_surface(tube)) {
    wall.rest = surface;
    wall.thickness.setConstant(surface.points.rows(), thickness);
    wall.axis.assign(static_cast<size_t>(surface.triangles.rows()), Vec3::UnitZ());
    wall.material = Material::isotropic(1, poisson);
  }
  std::vector<int> row(int k) const {
    std::vector<int> ring(static_cast<size_t>(tube.around));
    for (int i = 0; i < tube.around; ++i) ring[static_cast<size_t>(i)] = k * tube.around + i;
    return ring;
  }
  HeldSection start() const {
    HeldSection section;
    section.label = "start";
    section.ring = row(0);
    return section;
  }
  HeldSection end() const {
    HeldSection section;
    section.label = "end";
    section.ring = row(tube.along);
    section.rest.position = Vec3(0, 0, tube.length);
    return section;
  }
};

inline HeldSection soft(HeldSection section) {
  section.rigid = false;
  return section;
}

/// The tube carried rigidly section by section by a straight axis with constant strain (v, u).
inline CarriedBody carried_by(const HeldTube& t, const Vec6& strain,
                              const std::vector<double>& sections) {
  CarriedBody body;
  body.points.resize(t.surface.points.rows(), 3);
  for (Eigen::Index i = 0; i < body.points.rows(); ++i) {
    const Vec3 p = t.surface.points.row(i);
    const Pose frame = exp_motion(p.z() * strain);
    body.points.row(i) = frame * Vec3(p.x(), p.y(), 0);
    body.rotations.push_back(frame.rotation);
  }
  for (const double s : sections) body.sections.push_back(exp_motion(s * strain));
  return body;
}

/// One tube between two sections; a constant strain change (v - (0, 0, 1), u) moves its end.
inline CoupledProblem bent(const HeldTube& t, const Vec6& change, HeldSection start,
                           HeldSection end) {
  const auto strain_at = [=](double time) {
    Vec6 strain = time * change;
    strain[2] += 1;
    return strain;
  };
  const Pose target = exp_motion(t.tube.length * strain_at(1));
  end.motion.rotate = log_rotation(target.rotation);
  end.motion.move = target.position - Vec3(0, 0, t.tube.length);
  CoupledProblem problem;
  SurfaceBody body;
  body.name = "tube";
  body.rest = t.surface;
  body.thickness = t.wall.thickness[0];
  body.offset = body.thickness / 2;
  body.k = {1, 0.1, 0.4 * body.thickness};
  problem.surfaces.bodies.push_back(body);
  problem.vessels.push_back(
      std::make_unique<CoupledVessel>(CoupledVessel{t.wall, {std::move(start), std::move(end)}}));
  problem.carried = [=](double time) {
    return std::vector<CarriedBody>{carried_by(t, strain_at(time), {0, t.tube.length})};
  };
  return problem;
}

}  // namespace vasorod::testing
