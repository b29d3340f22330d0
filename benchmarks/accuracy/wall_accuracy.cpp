// The wall of `coupled` against closed forms, printed as Markdown (docs/wall.md):
//   wall_accuracy [stretch] [twist] [shear] [ring] [bending] [curved] [refinement]
// Without arguments, all of them. Tubes R 10, E 1; t is the thickness.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "accuracy/bent_ring.h"
#include "accuracy/gauges.h"
#include "accuracy/plane_ring.h"
#include "accuracy/printed.h"
#include "accuracy/refinement.h"

namespace vasorod::bench {
namespace {

using std::numbers::pi;
constexpr double radius = 10;

/// Regular, shifted and blue-noise meshes with `around` vertices around.
std::vector<TubeMesh> meshes(double length, int around) {
  return {structured(length, radius, around), shifted(length, radius, around),
          blue_noise(length, radius, around)};
}

void stretch() {
  print_head("Stretch: L 100, t 1, ends glued, 48 around; strain and radius from the middle half",
             "| mesh | nu | stretched to | force / (E A strain) | narrowing / (nu strain) |");
  for (const TubeMesh& mesh : meshes(100, 48))
    for (const double nu : {0.0, 0.3, 0.45})
      for (const double by : {1e-4, 0.05}) {
        const HeldTube tube(mesh, 100, radius, 1, nu);
        EndMotion end;
        end.change[2] = by;
        const HeldAnswer answer = solve(tube, end);
        const auto [strain, wider] = middle_half(tube, answer.positions);
        std::printf("| %s | %g | %g | %.5f | ", mesh.name.c_str(), nu, 1 + by,
                    answer.force.z() / (tube.area() * strain));
        if (nu > 0)
          std::printf("%.5f", -wider / (nu * strain));
        else
          std::printf("narrowing %.0e of R", std::abs(wider));
        std::printf("%s |\n", remark(answer.settled));
      }
}

void twist() {
  print_head("Twist: L 100, t 1",
             "| mesh | around | surface shear | torque / (G J twist) | largest change of the "
             "radius / R |");
  for (const auto& [around, shear] : {std::pair{48, 3e-4}, {48, 3e-5}, {96, 3e-4}})
    for (const TubeMesh& mesh : meshes(100, around)) {
      const HeldTube tube(mesh, 100, radius, 1);
      EndMotion end;
      end.change[5] = shear / radius;
      const HeldAnswer answer = solve(tube, end);
      std::printf("| %s | %d | %.0e | %.6f | %.1e%s |\n", mesh.name.c_str(), around, shear,
                  answer.moment.z() / (tube.shear_modulus() * 2 * tube.inertia() * end.change[5]),
                  off_cylinder(tube, answer.positions), remark(answer.settled));
    }
}

void shear() {
  print_head(
      "Transverse force on the end of a cantilever: L 100, t 1, structured; from the sections "
      "between .4 and "
      ".6 L",
      "| around | E I, from the change of curvature | k of k G A | k, Cowper |");
  for (const int around : {24, 48}) {
    const HeldTube tube(structured(100, radius, around), 100, radius, 1);
    const ShearGauge gauge = transverse_force(tube);
    std::printf("| %d | %.5f | %.5f | %.5f%s |\n", around, gauge.bending, gauge.coefficient,
                cowper_coefficient(radius, 1, tube.poisson), remark(gauge.settled));
  }
}

void ring() {
  print_head(
      "Ring under cos 2 theta in plane strain: L 100, rims free; energy over the thin ring's",
      "| mesh | around | t/R .02 | t/R .05 | t/R .2 |");
  std::vector<std::pair<int, TubeMesh>> rows;
  for (const int around : {24, 48})
    for (TubeMesh& mesh : meshes(100, around)) rows.emplace_back(around, std::move(mesh));
  for (const int around : {48, 96}) rows.emplace_back(around, structured(100, radius, around, 5));
  for (const auto& [around, mesh] : rows) {
    std::printf("| %s | %d |", mesh.name.c_str(), around);
    for (const double t : {0.2, 0.5, 2.0})
      std::printf(" %.4f |", ring_energy({mesh, 100, radius, t}));
    std::printf("\n");
  }
}

void bending() {
  print_head(
      "Pure bending: L/R 40, t/R .1, ends glued; the turn is chosen so that the middle fifth has "
      "the "
      "curvature",
      "| mesh | around | k_b | M / (E I k) | ring | flattening | ring | widening | ring |");
  constexpr double length = 400, t = 1, nu = 0.3;
  std::vector<std::pair<int, TubeMesh>> cases;
  cases.emplace_back(32, structured(length, radius, 32));
  for (TubeMesh& mesh : meshes(length, 48)) cases.emplace_back(48, std::move(mesh));
  for (const auto& [around, mesh] : cases) {
    const HeldTube tube(mesh, length, radius, t, nu);
    const double unit = t / (radius * radius * std::sqrt(1 - nu * nu));
    double asked_over_got = 1;
    for (const double k_b : {0.1, 0.2, 0.3}) {
      const BentRing exact = bent_ring(radius, t, nu, k_b * unit);
      HeldAnswer answer;
      double got = 0;
      for (int again = 0; again < 4 && std::abs(got - k_b) > 1e-4; ++again) {
        answer = solve(tube, pure_bending(asked_over_got * k_b * unit));
        got = middle_curvature(tube, answer.positions) / unit;
        asked_over_got *= k_b / got;
      }
      const SectionMean middle = section_mean(tube, answer.positions, length / 2);
      std::printf("| %s | %d | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f | %.4f%s |\n",
                  mesh.name.c_str(), around, got, answer.moment.y() / (tube.inertia() * got * unit),
                  exact.moment / (pi * std::pow(radius, 3) * t * k_b * unit), middle.flattening,
                  exact.flattening, middle.widening, exact.widening, remark(answer.settled));
      std::fflush(stdout);
    }
  }
}

// A tube curved at rest bends more easily. If its section ovalises by cos 2 theta alone (von
// Karman), by the factor (12 l^2 + 10) / (12 l^2 + 1), l = t / (k0 R^2 sqrt(1 - nu^2)); if its
// section takes any shape, by the ring's factor.
void curved() {
  print_head(
      "Tubes curved at rest, bent a little in their plane: L/R 40; E I of the straight tube over "
      "the middle "
      "fifth's",
      "| mesh | around | angle at rest | t/R | l | softer by | ring | von Karman |");
  constexpr double length = 400, nu = 0.3;
  std::vector<std::pair<int, TubeMesh>> cases;
  cases.emplace_back(32, structured(length, radius, 32));
  cases.emplace_back(48, structured(length, radius, 48));
  cases.emplace_back(48, blue_noise(length, radius, 48));
  for (const auto& [around, mesh] : cases)
    for (const auto& [degrees, t] : {std::pair{90.0, 1.0}, {90.0, 0.5}, {180.0, 0.5}}) {
      const HeldTube tube(mesh, length, radius, t, nu, degrees);
      const double k0 = degrees * pi / 180 / length;
      const HeldAnswer answer = solve(tube, pure_bending(1e-4 * k0));
      const double l = t / (k0 * radius * radius * std::sqrt(1 - nu * nu));
      std::printf("| %s | %d | %g | %g | %.3f | %.4f | %.4f | %.4f%s |\n", mesh.name.c_str(),
                  around, degrees, t / radius, l,
                  middle_curvature(tube, answer.positions) * tube.inertia() / answer.moment.y(),
                  curved_tube_softening(radius, t, nu, k0), (12 * l * l + 10) / (12 * l * l + 1),
                  remark(answer.settled));
      std::fflush(stdout);
    }
}

}  // namespace
}  // namespace vasorod::bench

int main(int count, char** arguments) {
  using namespace vasorod::bench;
  return run_parts({{"stretch", stretch},
                    {"twist", twist},
                    {"shear", shear},
                    {"ring", ring},
                    {"bending", bending},
                    {"curved", curved},
                    {"refinement", refinement}},
                   count, arguments);
}
