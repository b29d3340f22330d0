#include "accuracy/collapsed_ring.h"

#include <cmath>
#include <map>
#include <utility>

#include <vasorod/tube.h>

namespace vasorod::bench {
namespace {

constexpr double radius = 10, thickness = 0.2, length = CollapsedRing::length;
constexpr int along = 4;
constexpr double line_contact = 10.3360, area_at_line_contact = 0.20943;

// Inside a ring of points in a plane z = const.
double area_of(const Points& ring) {
  double area = 0;
  for (Eigen::Index i = 0; i < ring.rows(); ++i) {
    const auto a = ring.row(i), b = ring.row((i + 1) % ring.rows());
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

HeldSection soft_end(const std::string& label, double z, int first, int around) {
  HeldSection section;
  section.label = label;
  section.rigid = false;
  section.rest.position = Vec3(0, 0, z);
  for (int i = 0; i < around; ++i) section.ring.push_back(first + i);
  return section;
}

}  // namespace

CollapsedRing::CollapsedRing(int points) : around(points) {
  TubeSpec tube;
  tube.length = length;
  tube.radius = radius;
  tube.around = around;
  tube.along = along;
  rest_ = tube_surface(tube);
  rest_.points.col(0) *= 1.0002;
  rest_.points.col(1) *= 0.9998;
}

CoupledProblem CollapsedRing::under(double q) const {
  WallInput wall;
  wall.rest = rest_;
  wall.thickness.setConstant(rest_.points.rows(), thickness);
  wall.axis.assign(static_cast<std::size_t>(rest_.triangles.rows()), Vec3::UnitZ());
  wall.material = Material::isotropic(1, 0);
  const double d = thickness * thickness * thickness / 12;
  CoupledProblem problem;
  problem.vessels.push_back(std::make_unique<CoupledVessel>(CoupledVessel{
      wall,
      {soft_end("start", 0, 0, around), soft_end("end", length, along * around, around)},
      LumenPressure{0, -q * d / (radius * radius * radius)}}));
  SurfaceBody body;
  body.name = "ring";
  body.rest = rest_;
  body.thickness = 1e-3;
  body.offset = body.thickness / 2;
  body.k = {1, 0.1, 0.4 * thickness};
  problem.surfaces.bodies.push_back(body);
  problem.surfaces.contacts = self_contacts(problem.surfaces.bodies);
  problem.carried = [rest = rest_](double) {
    CarriedBody still;
    still.points = rest.points;
    still.rotations.assign(static_cast<std::size_t>(rest.points.rows()), Mat3::Identity());
    still.sections = {Pose{}, Pose{Mat3::Identity(), Vec3(0, 0, length)}};
    return std::vector<CarriedBody>{still};
  };
  return problem;
}

CoupledSolution CollapsedRing::at(double q, bool guarded) const {
  CoupledProblem problem = under(q);
  problem.guarded = guarded;
  CoupledOptions options;
  options.times.clear();
  for (double before = 2.5; before < q; before += 1.5) options.times.push_back(before / q);
  options.times.push_back(1);
  return CoupledSolver(std::move(problem), options).solve();
}

Points CollapsedRing::middle(const CoupledSolution& solution) const {
  return solution.surface.bodies[0].positions.middleRows(along / 2 * around, around);
}

double CollapsedRing::area_ratio(const CoupledSolution& solution) const {
  return area_of(middle(solution)) / area_of(rest_.points.topRows(around));
}

double published_area(double q) {
  static const std::map<double, double> shares{
      {3.5, 0.74952}, {4, 0.56639}, {5, 0.31702}, {5.24689, 0.27095}};
  if (const auto found = shares.find(q); found != shares.end()) return found->second;
  return q < line_contact ? std::nan("")
                          : area_at_line_contact * std::pow(q / line_contact, -2. / 3);
}

}  // namespace vasorod::bench
