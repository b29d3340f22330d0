// Walls shared by the tests of tests/wall.
#pragma once

#include <cmath>
#include <random>

#include <vasorod/tube.h>

#include "straight_tube.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// A generated tube as a wall of thickness t; its axis is the fibre direction.
inline WallInput tube_wall(const TubeSpec& tube, double t, const Material& material,
                           bool glued_ends) {
  WallInput in;
  in.rest = tube_surface(tube);
  in.thickness = tube_thickness(tube, t);
  in.material = material;
  const Eigen::VectorXd s = tube_arc_lengths(tube);
  for (int i = 0; i < in.rest.triangles.rows(); ++i) {
    double middle = 0;
    for (int k = 0; k < 3; ++k) middle += s[in.rest.triangles(i, k)] / 3;
    in.axis.push_back(tube_axis(tube, middle).director(3));
  }
  if (glued_ends) {
    in.glued.assign(static_cast<size_t>(s.size()), 0);
    for (int i = 0; i < s.size(); ++i)
      in.glued[static_cast<size_t>(i)] =
          s[i] < 1e-9 * tube.length || s[i] > (1 - 1e-9) * tube.length;
  }
  return in;
}

inline TubeSpec tube(double length, double radius, int around, int along) {
  return testing::straight_tube(length, radius, around, along);
}

/// Uniform numbers in [-1, 1], the same in every run.
inline Eigen::VectorXd noise(Eigen::Index n, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(engine); });
}

}  // namespace vasorod
