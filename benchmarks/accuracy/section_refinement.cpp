// How fast the shape of fidelity section converges with its space: a tube of t / R 0.1, L / R 10,
// nu 0.3 between rigid ends, bent to half Brazier's curvature, in spaces with more and more spans
// and more and more harmonics, against the finest of both. Prints the table of
// benchmarks/baselines/sections_refinement.csv.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "accuracy/printed.h"
#include "geometry/rigid_motion.h"
#include "numerics/blas.h"
#include "sections/section_newton.h"

namespace vasorod::bench {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double length = 10, thickness = 0.1, nu = 0.3;  // over the radius and Young's modulus
constexpr int most_harmonics = 10, most_spans = 64;

struct Solved {
  SectionShape shape;
  Vec3 moment;
  int unknowns = 0;
  bool settled = false;
};

// The tube along z, each section moved by `pose` of its place along.
template <class PoseAt>
SectionShape tube(const SectionSpace& space, PoseAt&& pose) {
  SectionShape shape{space, MatrixXd(space.row_size(), space.along.count())};
  const VectorXd places = space.along.interpolation_points();
  for (int i = 0; i < space.along.count(); ++i) {
    Eigen::MatrixX3d row = Eigen::MatrixX3d::Zero(space.modes(), 3);
    row(1, 0) = row(2, 1) = 1;
    const Pose at = pose(length * places[i]);
    row *= at.rotation.transpose();
    row.row(0) += at.position.transpose();
    shape.coefficients.col(i) = row.reshaped();
  }
  return shape;
}

Solved solve(const SectionSpace& space) {
  const double curvature = 0.5 * 0.471 * thickness / std::sqrt(1 - nu * nu);
  const auto straight = [](double s) { return Pose{Mat3::Identity(), Vec3(0, 0, s)}; };
  const auto bent = [&](double s) {
    const double angle = curvature * s;
    return Pose{exp_rotation(Vec3(0, angle, 0)),
                Vec3((1 - std::cos(angle)) / curvature, 0, std::sin(angle) / curvature)};
  };
  SectionWall wall;
  wall.rest = tube(space, straight);
  wall.thickness = [](double) { return thickness; };
  wall.material = Material::isotropic(1, nu);
  HeldEnds ends;
  for (HeldSection& end : {std::ref(ends[0].emplace()), std::ref(ends[1].emplace())})
    end.rigid = true;
  const Pose moved = bent(length);
  ends[1]->rest = straight(length);
  ends[1]->motion.move = moved.position - ends[1]->rest.position;
  ends[1]->motion.rotate = {0, curvature * length, 0};
  SectionSystem system(wall, ends);
  system.set_time(1);
  VectorXd z = system.unknowns_of(tube(space, bent).coefficients, {straight(0), moved});
  SectionNewtonOptions options;
  options.tolerance = 1e-12;
  std::optional<BandMatrix> kept;
  Work work;
  const SectionNewtonSummary summary = minimise_sections(system, z, options, kept, work);
  const auto wrench = system.wrench(1, z, system.gradient(z));
  return {{space, system.coefficients(z)},
          wrench->moment,
          system.unknowns(),
          summary.status == SectionNewtonStatus::converged && summary.positive.value_or(false)};
}

// RMS distance of material points, over the radius.
double apart(const SectionShape& one, const SectionShape& other) {
  constexpr int along = 200, around = 48;
  double square = 0;
  for (int i = 0; i <= along; ++i)
    for (int k = 0; k < around; ++k) {
      const double u = double(i) / along, angle = 2 * std::numbers::pi * k / around;
      square += (one.point(u, angle) - other.point(u, angle)).squaredNorm();
    }
  return std::sqrt(square / ((along + 1) * around));
}

}  // namespace
}  // namespace vasorod::bench

int main() {
  using namespace vasorod;
  using namespace vasorod::bench;
  const OneCholmodThread one_thread;
  print_head("Refinement of sections", "| harmonics | spans | unknowns | rms | moment | settled |");
  const auto space = [](int harmonics, int spans) {
    return SectionSpace{harmonics, AxialBasis(spans, 3)};
  };
  const Solved finest = solve(space(most_harmonics, most_spans));
  const auto print = [&](int harmonics, int spans) {
    const Solved found = solve(space(harmonics, spans));
    std::printf("| %d | %d | %d | %.4g | %.4g | %d |\n", harmonics, spans, found.unknowns,
                apart(found.shape, finest.shape),
                (found.moment - finest.moment).norm() / finest.moment.norm(), found.settled);
  };
  for (const int spans : {6, 9, 13, 19, 28, 42}) print(most_harmonics, spans);
  for (const int harmonics : {2, 3, 4, 5, 6, 7, 8}) print(harmonics, most_spans);
  return finest.settled ? 0 : 1;
}
