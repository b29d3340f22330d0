#include "vessel/fork_reach.h"

#include <algorithm>
#include <array>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Half width of a section's band, in mean edges.
constexpr double band_edges = 1.2;
// Reaches from the fork to where a branch follows its own sections again: strains 3/2 as large.
constexpr double caught_up = 3;
// The fastest that a short branch catches up; faster, its reaches are shortened.
constexpr double fastest = 3;

// Arc length of the section that a branch's section at s follows.
class Catching {
 public:
  explicit Catching(const ForkReach& reach)
      : length_(reach.length), reach_{reach.start, reach.end} {
    const double sum = reach.start + reach.end, most = length_ * (1 - 1 / fastest);
    const double shortened = sum > most ? most / sum : 1;
    for (size_t k = 0; k < 2; ++k) {
      const double latest = sum > 0 ? length_ * reach_[k] / sum : 0;
      reach_[k] *= shortened;
      end_[k] = std::min(caught_up * reach_[k], latest);
    }
  }
  double operator()(double s) const {
    if (s < end_[0]) return from_fork(s, 0);
    if (length_ - s < end_[1]) return length_ - from_fork(length_ - s, 1);
    return s;
  }

 private:
  double from_fork(double s, size_t k) const {
    return std::max(0.0, s - reach_[k]) * end_[k] / (end_[k] - reach_[k]);
  }
  double length_;
  std::array<double, 2> reach_, end_{};
};

// The section of a branch at s that holds `point`, in the frame there.
RodCoordinates section_at(const RodTree& rod, const RodBranch& branch, double s,
                          const Vec3& point) {
  for (const int e : branch.elements) {
    const double length = rod.elements[index(e)].length;
    if (s <= length || e == branch.elements.back()) {
      s = std::min(s, length);
      return {e, s, frame_at(rod, rod.rest, e, s).inverse() * point};
    }
    s -= length;
  }
  return {};
}

}  // namespace

std::vector<ElementPlace> element_places(const RodTree& rod) {
  std::vector<ElementPlace> places(rod.elements.size());
  for (size_t b = 0; b < rod.branches.size(); ++b) {
    double s = 0;
    for (const int e : rod.branches[b].elements) {
      places[index(e)] = {b, s};
      s += rod.elements[index(e)].length;
    }
  }
  return places;
}

std::vector<ForkReach> fork_reach(const Vessel& vessel) {
  const RodTree& rod = vessel.rod;
  std::vector<ForkReach> reach(rod.branches.size());
  for (size_t b = 0; b < reach.size(); ++b)
    for (const int e : rod.branches[b].elements) reach[b].length += rod.elements[index(e)].length;
  if (rod.branches.size() == 1) return reach;
  const std::vector<ElementPlace> places = element_places(rod);
  const auto see = [&](int vertex, int neighbour) {
    const auto b = index(vessel.branch_of[index(vertex)]),
               other = index(vessel.branch_of[index(neighbour)]);
    if (b == other) return;
    const RodBranch &mine = rod.branches[b], &theirs = rod.branches[other];
    const RodCoordinates& at = vessel.binding[index(vertex)];
    const double s = places[index(at.element)].start + at.s;
    const auto meets = [&](int node) {
      return node == theirs.nodes.front() || node == theirs.nodes.back();
    };
    if (meets(mine.nodes.front()))
      reach[b].start = std::max(reach[b].start, s);
    else if (meets(mine.nodes.back()))
      reach[b].end = std::max(reach[b].end, reach[b].length - s);
  };
  const Triangles& triangles = vessel.surface.triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      see(triangles(t, k), triangles(t, (k + 1) % 3));
      see(triangles(t, (k + 1) % 3), triangles(t, k));
    }
  return reach;
}

double section_band(const RodElement& element, double mean_edge) {
  return std::max(band_edges * mean_edge, element.length);
}

std::vector<char> fork_elements(const Vessel& vessel) {
  const RodTree& rod = vessel.rod;
  std::vector<char> at_fork(rod.elements.size(), 0);
  if (rod.branches.size() == 1) return at_fork;
  const double mean_edge = mean_edge_length(vessel.surface);
  const std::vector<ForkReach> reach = fork_reach(vessel);
  const std::vector<ElementPlace> places = element_places(rod);
  for (size_t e = 0; e < at_fork.size(); ++e) {
    const auto [branch, start] = places[e];
    const double band = section_band(rod.elements[e], mean_edge);
    at_fork[e] = reach[branch].meets(start - band, start + rod.elements[e].length + band);
  }
  return at_fork;
}

std::vector<size_t> branches_within_forks(const Vessel& vessel) {
  const std::vector<char> at_fork = fork_elements(vessel);
  std::vector<size_t> within;
  for (size_t b = 0; b < vessel.rod.branches.size(); ++b) {
    const std::vector<int>& elements = vessel.rod.branches[b].elements;
    if (std::all_of(elements.begin(), elements.end(), [&](int e) { return at_fork[index(e)]; }))
      within.push_back(b);
  }
  return within;
}

void bind_wall(Vessel& vessel) {
  const RodTree& rod = vessel.rod;
  vessel.binding = vasorod::bind(rod, vessel.surface.points, vessel.branch_of);
  vessel.carry = vessel.binding;
  if (rod.branches.size() == 1) return;
  const std::vector<ElementPlace> places = element_places(rod);
  std::vector<Catching> catching;
  for (const ForkReach& reach : fork_reach(vessel)) catching.emplace_back(reach);
  for (size_t v = 0; v < vessel.carry.size(); ++v) {
    const RodCoordinates& at = vessel.binding[v];
    const ElementPlace& mine = places[index(at.element)];
    const double s = mine.start + at.s, followed = catching[mine.branch](s);
    if (followed == s) continue;
    vessel.carry[v] = section_at(rod, rod.branches[mine.branch], followed,
                                 vessel.surface.points.row(static_cast<Eigen::Index>(v)));
  }
}

}  // namespace vasorod
