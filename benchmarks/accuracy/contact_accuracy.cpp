// Contact in `coupled`, printed as Markdown (docs/wall.md):
//   contact_accuracy [plate] [penalty] [refinement] [tubes] [ring]
// Without arguments, all of them. E 1, nu 0.3. The tubes (R 8, L 60, t 1.2, between rigid ends) are
// pressed by 3 onto a perpendicular rigid cylinder of radius 12, or onto another tube.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/collapsed_ring.h"
#include "accuracy/pressed_tubes.h"
#include "accuracy/printed.h"

namespace vasorod::bench {
namespace {

void plate() {
  print_head(
      "A short tube (R 8, t .2, L 4, ends held in the mean) sunk onto a plate: force over the thin "
      "ring's",
      "| around | vertices | sunk by | force / closed form | pressures' sum over the force |");
  for (const auto& [around, sink] :
       {std::pair{32, 0.1}, {64, 0.1}, {128, 0.1}, {64, 0.02}, {128, 0.02}, {128, 0.005}}) {
    const RingOnPlate ring = ring_on_plate(around, sink);
    std::printf("| %d | %d | %g | %.4f | %.9f%s |\n", around, ring.vertices, sink,
                ring.force / ring.closed_form, ring.pressure_sum / ring.force,
                remark(ring.settled));
    std::fflush(stdout);
  }
}

// Columns after the first. Misfits are relative to the force: of the sum of pressures along the
// normals and the supports; of the supports and the contact force; of the forces on the two bodies.
// Penetration is relative to the mean edge.
void row(const std::string& first, const PressedTubes& pressed, double reference) {
  std::printf("| %s | %d | %.6f | %+.3f %% | ", first.c_str(), pressed.vertices,
              pressed.force.norm(), 100 * (pressed.force.norm() / reference - 1));
  if (pressed.pressure_misfit) std::printf("%.1e", *pressed.pressure_misfit);
  std::printf(" | %.1e | %.1e | %.1e%s |\n", pressed.support_misfit, pressed.newton_misfit,
              pressed.penetration, remark(pressed.settled));
  std::fflush(stdout);
}

void penalty() {
  print_head("Pressed onto a cylinder, 48 around: the penalty",
             "| penalty times vertex area over k_b + k_s | vertices | force | to 10 | pressures "
             "and supports | "
             "force and "
             "supports | a's and b's | penetration / edge |");
  const double reference = pressed_on_cylinder(48, 10).force.norm();
  for (const double stiffness : {1.0, 3.0, 10.0, 30.0, 100.0})
    row(std::to_string(static_cast<int>(stiffness)), pressed_on_cylinder(48, stiffness), reference);
}

void refinement() {
  print_head("Pressed onto a cylinder: the mesh",
             "| around | vertices | force | to the finest | pressures and supports | force and "
             "supports | a's and "
             "b's | "
             "penetration / edge |");
  const PressedTubes finest = pressed_on_cylinder(134, 10);
  for (const int around : {34, 48, 67, 96}) {
    const PressedTubes pressed = pressed_on_cylinder(around, 10);
    row(std::to_string(around), pressed, finest.force.norm());
  }
  row("134", finest, finest.force.norm());
}

void tubes() {
  print_head("Two tubes that both yield, 3 into each other",
             "| tubes, around | vertices | force | to the finest | pressures and supports | force "
             "and supports | "
             "a's and b's | "
             "penetration / "
             "edge |");
  struct Case {
    std::string name;
    Meeting meeting;
    std::vector<int> around;
  };
  for (const Case& c :
       {Case{"across", Meeting::across, {30, 60}},
        {"side by side, soft ends", Meeting::side_by_side, {20, 24, 28, 30, 36, 48, 60}},
        {"side by side, rigid ends overlap", Meeting::side_by_side_rigid_ends, {30, 60}}}) {
    std::vector<PressedTubes> pressed;
    for (const int around : c.around) pressed.push_back(two_tubes(c.meeting, around));
    for (std::size_t i = 0; i < pressed.size(); ++i)
      row(c.name + ", " + std::to_string(c.around[i]), pressed[i], pressed.back().force.norm());
  }
}

void ring() {
  print_head("A ring collapsed by a pressure from outside: its area over the circle's",
             "| around | p R^3 / D | published | here | off by | wall against itself, over its "
             "length |");
  for (const auto& [around, all] :
       {std::pair{96, std::vector{3.5, 4.0, 5.0, 5.24689, 10.3360, 20.0, 40.0}},
        {128, {5.0, 10.3360, 40.0}}}) {
    const CollapsedRing collapsed(around);
    for (const double q : all) {
      const CoupledSolution solution = collapsed.at(q);
      const double area = collapsed.area_ratio(solution), published = published_area(q);
      std::printf(
          "| %d | %g | %.5f | %.5f | %.1f %% | %.3g%s |\n", around, q, published, area,
          100 * std::abs(area / published - 1),
          solution.surface.contacts.at(0).area / collapsed.length,
          remark(solution.status == Status::buckled && solution.smallest_curvature_positive));
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace vasorod::bench

int main(int count, char** arguments) {
  using namespace vasorod::bench;
  return run_parts({{"plate", plate},
                    {"penalty", penalty},
                    {"refinement", refinement},
                    {"tubes", tubes},
                    {"ring", ring}},
                   count, arguments);
}
