#include "accuracy/refinement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "accuracy/printed.h"

namespace vasorod::bench {
namespace {

using std::numbers::pi;

constexpr double radius = 10, length = 100, thickness = 1, nu = 0.3;
constexpr int finest = 240;  // vertices around of the structured reference mesh

/// Displacement on staggered rows at an angle and arc length, linear in both.
Vec3 displacement(const BentTube& bent, int around, double angle, double s) {
  const TubeMesh& mesh = bent.tube.mesh;
  const Eigen::Index rows = mesh.s.size() / around;
  const double at = s / length * static_cast<double>(rows - 1);
  const auto below = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(at), 0, rows - 2);
  const auto in_row = [&](Eigen::Index row) {
    double place = (angle - mesh.angle[row * around]) / (2 * pi) * around;
    place -= around * std::floor(place / around);
    const auto column = static_cast<Eigen::Index>(place);
    const auto of = [&](Eigen::Index k) -> Vec3 {
      const Eigen::Index v = row * around + k % around;
      return bent.answer.positions.row(v) - bent.tube.rest.points.row(v);
    };
    const double share = place - static_cast<double>(column);
    return Vec3((1 - share) * of(column) + share * of(column + 1));
  };
  const double share = at - static_cast<double>(below);
  return (1 - share) * in_row(below) + share * in_row(below + 1);
}

}  // namespace

BentTube::BentTube(TubeMesh mesh) : tube(std::move(mesh), length, radius, thickness, nu) {
  EndMotion end;
  end.change[4] = 0.5 * 0.471 * thickness / (radius * radius * std::sqrt(1 - nu * nu));
  answer = solve(tube, end);
}

double largest_distance(const BentTube& bent, const BentTube& reference, int around) {
  double far = 0;
  for (Eigen::Index v = 0; v < bent.tube.rest.points.rows(); ++v) {
    const Vec3 moved = bent.answer.positions.row(v) - bent.tube.rest.points.row(v);
    far = std::max(
        far, (moved - displacement(reference, around, bent.tube.mesh.angle[v], bent.tube.mesh.s[v]))
                 .norm());
  }
  return far;
}

std::vector<RefinedMesh> refined_meshes() {
  return {
      {"structured", [](int n) { return structured(length, radius, n); }, {40, 80, 160, finest}},
      {"shifted", [](int n) { return shifted(length, radius, n); }, {40, 80, 160, finest}},
      {"blue-noise", [](int n) { return blue_noise(length, radius, n); }, {40, 80, 160, finest}},
      {"long triangles",
       [](int n) { return structured(length, radius, n, 5); },
       {88, 176, 352, 528}}};
}

void refinement() {
  print_head(
      "Refinement: L 100, t 1, bent to half the Brazier curvature between rigid ends; against the "
      "structured "
      "mesh with " +
          std::to_string(finest) + " around",
      "| mesh | around | vertices | moment | to the reference | largest distance, % of R | order "
      "|");
  const BentTube reference(structured(length, radius, finest));
  for (const auto& [name, make, levels] : refined_meshes()) {
    std::vector<double> moments;
    for (const int around : levels) {
      const BentTube bent(make(around));
      moments.push_back(bent.answer.moment.y());
      std::printf("| %s | %d | %ld | %.5f | %+.3f %% | %.4f | ", name, around,
                  static_cast<long>(bent.tube.rest.points.rows()), moments.back(),
                  100 * (moments.back() / reference.answer.moment.y() - 1),
                  100 * largest_distance(bent, reference, finest) / radius);
      if (moments.size() == 3)
        std::printf("%.2f", std::log2((moments[1] - moments[0]) / (moments[2] - moments[1])));
      std::printf("%s |\n", remark(bent.answer.settled));
      std::fflush(stdout);
    }
  }
}

}  // namespace vasorod::bench
