#include "predict/memory_need.h"

#include <algorithm>
#include <numeric>

#include "data/sentence.h"

namespace vasorod {
namespace {

// Bytes per vertex, and per element of a bare rod: a third to four fifths of measured peaks.
// `coupled`: 48 kB with 4,300 vertices, 61 kB with 17,000; entries of the factor per vertex grow
// with the logarithm of the size. `paper`: 4.2 kB with a million vertices, `skin`: 0.85 kB with
// 120,000. Rods: 3.1 kB per element between 100,000 and 300,000.
constexpr double coupled_vertex = 30e3, paper_vertex = 2e3, other_vertex = 500, rod_element = 1e3;

// Nothing moves the others unless they are touched, and obstacles never.
bool is_solved(const Scene& scene, const VesselSpec& vessel) {
  if (vessel.role == Role::obstacle) return false;
  if (const auto joined = scene.joined())
    if (vessel.name == (*joined)[0] || vessel.name == (*joined)[1]) return true;
  return std::any_of(scene.ends.begin(), scene.ends.end(), [&](const EndCondition& end) {
    return end.vessel == vessel.name && (end.move || end.rotate_deg || end.force || end.moment);
  });
}

std::string gigabytes(double bytes) {
  return number_text(bytes / 1e9, 3) + " GB";
}

}  // namespace

double least_memory(const VesselSpec& vessel, const std::string& fidelity, double size) {
  if (vessel.rod) return rod_element * size;
  if (fidelity == "coupled") return coupled_vertex * size;
  return (fidelity == "paper" ? paper_vertex : other_vertex) * size;
}

std::vector<double> stated_sizes(const Scene& scene) {
  std::vector<double> sizes;
  for (const VesselSpec& vessel : scene.vessels) {
    sizes.push_back(0);
    if (vessel.tube) sizes.back() = double(vessel.tube->around) * (vessel.tube->along + 1);
    if (vessel.rod)
      for (const RodPiece& piece : vessel.rod->pieces) sizes.back() += piece.elements;
  }
  return sizes;
}

void require_memory(const Scene& scene, const std::string& fidelity,
                    const std::vector<double>& sizes, std::optional<double> limit) {
  if (!limit) return;
  std::vector<double> needs;
  for (std::size_t v = 0; v < scene.vessels.size(); ++v) {
    const VesselSpec& vessel = scene.vessels[v];
    const bool solved = vessel.rod || is_solved(scene, vessel);
    needs.push_back(least_memory(vessel, solved ? fidelity : "skin", sizes[v]));
  }
  const double all = std::accumulate(needs.begin(), needs.end(), 0.0);
  if (!(all > *limit)) return;
  const auto v =
      static_cast<std::size_t>(std::max_element(needs.begin(), needs.end()) - needs.begin());
  const VesselSpec& vessel = scene.vessels[v];
  throw TooLarge((scene.file.empty() ? "" : scene.file.string() + ": ") + "vessel " + vessel.name +
                 ": found " + number_text(sizes[v], 10) + (vessel.rod ? " elements" : " vertices") +
                 ", with which fidelity " + fidelity + " takes at least " + gigabytes(all) +
                 " of memory for the scene, expected at most the " + gigabytes(*limit) +
                 " that this process may have: " +
                 (vessel.rod ? "fewer elements" : "a coarser mesh or a cheaper fidelity"));
}

}  // namespace vasorod
