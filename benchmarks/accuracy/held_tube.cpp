#include "accuracy/held_tube.h"

#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <numbers>

namespace vasorod::bench {

using std::numbers::pi;

HeldTube::HeldTube(TubeMesh the_mesh, double length, double radius, double t, double nu,
                   double bend_deg)
    : thickness(t), poisson(nu), mesh(std::move(the_mesh)) {
  shape.length = length;
  shape.radius = radius;
  shape.bend_deg = bend_deg;
  rest = placed(mesh, shape);
}

double HeldTube::area() const {
  return 2 * pi * shape.radius * thickness;
}

double HeldTube::inertia() const {
  const double r = shape.radius;
  return pi * r * r * r * thickness * (1 + thickness * thickness / (4 * r * r));
}

namespace {

Vec6 rest_strain(const HeldTube& tube) {
  Vec6 strain = Vec6::Zero();
  strain[2] = 1;
  strain[4] = tube.shape.bend_deg * pi / 180 / tube.shape.length;
  return strain;
}

CarriedBody carried(const HeldTube& tube, const Vec6& strain) {
  CarriedBody body;
  body.points.resize(tube.rest.points.rows(), 3);
  const auto frame = [&](double s) { return exp_motion(s * strain); };
  const auto turned = [&](double s) {
    return Pose{frame(s).rotation * tube_axis(tube.shape, s).rotation.transpose(),
                frame(s).position};
  };
  for (Eigen::Index i = 0; i < body.points.rows(); ++i) {
    const double s = tube.mesh.s[i];
    const Vec3 across = Vec3(tube.rest.points.row(i)) - tube_axis(tube.shape, s).position;
    const Pose at = turned(s);
    body.rotations.push_back(at.rotation);
    body.points.row(i) = at.position + at.rotation * across;
  }
  body.sections = {turned(0), turned(tube.shape.length)};
  return body;
}

}  // namespace

WallInput wall_of(const HeldTube& tube) {
  WallInput wall;
  wall.rest = tube.rest;
  wall.thickness.setConstant(tube.rest.points.rows(), tube.thickness);
  for (Eigen::Index t = 0; t < tube.rest.triangles.rows(); ++t) {
    double middle = 0;
    for (int k = 0; k < 3; ++k) middle += tube.mesh.s[tube.rest.triangles(t, k)] / 3;
    wall.axis.push_back(tube_axis(tube.shape, middle).director(3));
  }
  wall.material = Material::isotropic(1, tube.poisson);
  return wall;
}

SurfaceBody body_of(const HeldTube& tube) {
  SurfaceBody body;
  body.name = "tube";
  body.rest = tube.rest;
  body.thickness = tube.thickness;
  body.offset = body.thickness / 2;
  body.k = {1, 0.1, 0.4 * body.thickness};
  return body;
}

HeldSection rim(const HeldTube& tube, double s) {
  HeldSection section;
  section.label = s > 0 ? "end" : "start";
  for (int i = 0; i < tube.mesh.s.size(); ++i)
    if (std::abs(tube.mesh.s[i] - s) < 1e-9 * tube.shape.length) section.ring.push_back(i);
  section.rest = tube_axis(tube.shape, s);
  return section;
}

bool settled(const CoupledSolution& solution) {
  return solution.status == Status::converged && solution.smallest_curvature_positive;
}

HeldAnswer solve(const HeldTube& tube, const EndMotion& motion) {
  const Vec6 strain = rest_strain(tube);
  CoupledVessel vessel;
  vessel.wall = wall_of(tube);
  HeldSection end = rim(tube, tube.shape.length);
  const Pose target = carried(tube, strain + motion.change).sections[1];
  end.motion.rotate = log_rotation(target.rotation);
  end.motion.move = target.position - end.rest.position;
  end.fixed = motion.held;
  end.force = motion.force;
  vessel.sections = {rim(tube, 0), end};

  CoupledProblem problem;
  problem.surfaces.bodies.push_back(body_of(tube));
  problem.vessels.push_back(std::make_unique<CoupledVessel>(std::move(vessel)));
  problem.carried = [&](double t) {
    return std::vector<CarriedBody>{carried(tube, strain + t * motion.change)};
  };
  const CoupledSolution solution = CoupledSolver(std::move(problem)).solve();
  return {settled(solution), solution.surface.bodies[0].positions, solution.sections[0][1].force,
          solution.sections[0][1].moment};
}

SectionMean section_mean(const HeldTube& tube, const Points& positions, double s) {
  const bool rows = tube.mesh.name == "structured" || tube.mesh.name == "long triangles";
  const Eigen::VectorXd& at = tube.mesh.s;
  SectionMean mean;
  mean.s = s;
  double window = 0.8 * tube.mesh.edge;
  if (rows) {
    window = 1e-9 * tube.shape.length;
    double nearest = std::numeric_limits<double>::max();
    for (Eigen::Index i = 0; i < at.size();
         ++i)  // vertices on the normal: every second row has one
      if (std::abs(tube.mesh.angle[i]) < 1e-9 && std::abs(at[i] - s) < nearest) {
        nearest = std::abs(at[i] - s);
        mean.s = at[i];
      }
  }
  std::vector<Eigen::Index> ring;
  for (Eigen::Index i = 0; i < at.size(); ++i)
    if (std::abs(at[i] - mean.s) <= window) ring.push_back(i);
  const Pose axis = tube_axis(tube.shape, mean.s);
  const double share = 1 / static_cast<double>(ring.size());
  Vec3 centre_rest = Vec3::Zero();
  for (const Eigen::Index i : ring) {
    centre_rest += share * Vec3(tube.rest.points.row(i));
    mean.centre += share * Vec3(positions.row(i));
  }
  Mat3 moment = Mat3::Zero();
  for (const Eigen::Index i : ring)
    moment += (Vec3(positions.row(i)) - mean.centre) *
              (Vec3(tube.rest.points.row(i)) - centre_rest).transpose();
  const Eigen::JacobiSVD<Mat3> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 sign = Mat3::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  mean.rotation = svd.matrixU() * sign * svd.matrixV().transpose();
  Vec3 low = Vec3::Zero(), high = low, low_rest = low, high_rest = low;
  for (const Eigen::Index i : ring) {
    const Vec3 rest = axis.rotation.transpose() * (Vec3(tube.rest.points.row(i)) - centre_rest);
    const Vec3 now = axis.rotation.transpose() * mean.rotation.transpose() *
                     (Vec3(positions.row(i)) - mean.centre);
    low = low.cwiseMin(now);
    high = high.cwiseMax(now);
    low_rest = low_rest.cwiseMin(rest);
    high_rest = high_rest.cwiseMax(rest);
    mean.radius += share * now.head<2>().norm() / rest.head<2>().norm();
  }
  const Vec3 ratio = (high - low).cwiseQuotient(high_rest - low_rest);
  mean.flattening = 1 - ratio.x();
  mean.widening = ratio.y() - 1;
  return mean;
}

}  // namespace vasorod::bench
