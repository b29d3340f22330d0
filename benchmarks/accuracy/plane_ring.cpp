#include "accuracy/plane_ring.h"

#include <cmath>
#include <numbers>

#include "geometry/triangle_surface.h"
#include "numerics/cholesky.h"
#include "wall/wall_energy.h"

namespace vasorod::bench {

using std::numbers::pi;

double ring_energy(const HeldTube& tube) {
  const double radius = tube.shape.radius, length = tube.shape.length, t = tube.thickness;
  const WallInput in = wall_of(tube);
  WallEnergy wall(in);
  const auto nearest = [&](double angle) {
    Eigen::Index at = 0;
    (in.rest.points.rowwise() -
     Vec3(radius * std::cos(angle), radius * std::sin(angle), 0).transpose())
        .rowwise()
        .squaredNorm()
        .minCoeff(&at);
    return static_cast<std::size_t>(3 * at);
  };
  std::vector<char> held(static_cast<std::size_t>(wall.unknowns()), 0);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(wall.unknowns());
  const Eigen::VectorXd areas = vertex_areas(in.rest);
  for (int i = 0; i < wall.vertices(); ++i) {
    held[static_cast<std::size_t>(3 * i + 2)] = 1;
    const double angle = tube.mesh.angle[i];
    load.segment<3>(3 * i) = areas[i] / areas.sum() * 2 * pi * radius * length *
                             std::cos(2 * angle) * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  for (const std::size_t i : {nearest(0) + 1, nearest(pi / 2), nearest(pi) + 1}) held.at(i) = 1;
  const Eigen::SparseMatrix<double>& full = wall.hessian(wall.rest());
  std::vector<int> number(held.size(), -1);
  int n = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i]) number[i] = n++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), displacement(n);
  for (int c = 0; c < full.cols(); ++c) {
    const int column = number[static_cast<std::size_t>(c)];
    if (column < 0) continue;
    right[column] = load[c];
    for (Eigen::SparseMatrix<double>::InnerIterator it(full, c); it; ++it)
      if (const int row = number[static_cast<std::size_t>(it.row())]; row >= 0)
        entries.emplace_back(row, column, it.value());
  }
  Eigen::SparseMatrix<double> stiffness(n, n);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  Cholesky cholesky;
  cholesky.analyse(stiffness);
  if (!cholesky.factorise(stiffness)) return std::nan("");
  cholesky.solve(right.data(), displacement.data(), 1);
  const double d = t * t * t / (12 * (1 - tube.poisson * tube.poisson));
  return right.dot(displacement) / 2 / (length * pi * std::pow(radius, 5) / (18 * d));
}

}  // namespace vasorod::bench
