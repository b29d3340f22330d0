#include "vessel/axis_route.h"

#include <algorithm>

#include "data/index.h"

namespace vasorod {
namespace {

// Elements from the node up to the root, nearest first.
std::vector<int> up_from(const RodTree& rod, int node) {
  std::vector<int> into(rod.rest.size(), -1);
  for (size_t e = 0; e < rod.elements.size(); ++e)
    into[index(rod.elements[e].second)] = static_cast<int>(e);
  std::vector<int> up;
  while (into[index(node)] >= 0) {
    up.push_back(into[index(node)]);
    node = rod.elements[index(up.back())].first;
  }
  return up;
}

}  // namespace

AxisRoute::AxisRoute(const RodTree& rod, int from_node, int to_node) : rod_(&rod) {
  std::vector<int> back = up_from(rod, from_node), onward = up_from(rod, to_node);
  while (!back.empty() && !onward.empty() && back.back() == onward.back()) {
    back.pop_back();
    onward.pop_back();
  }
  std::reverse(onward.begin(), onward.end());
  for (const auto& [elements, backwards] : {std::pair(&back, true), std::pair(&onward, false)})
    for (const int e : *elements) {
      pieces_.push_back({e, backwards, length_});
      length_ += rod.elements[index(e)].length;
    }
}

AxisRoute::AxisRoute(const Vessel& vessel, const RouteEnds& ends)
    : AxisRoute(vessel.rod, vessel.ends[index(ends[0])].node, vessel.ends[index(ends[1])].node) {}

AxisPlace AxisRoute::at(double distance) const {
  const double wanted = std::clamp(distance, 0.0, length_);
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), wanted,
                       [](double value, const Piece& piece) { return value < piece.start; });
  const Piece& piece = *(after - 1);
  const double whole = rod_->elements[index(piece.element)].length,
               within = std::clamp(wanted - piece.start, 0.0, whole);
  return {piece.element, piece.backwards ? whole - within : within};
}

std::optional<double> AxisRoute::distance_to(const AxisPlace& place) const {
  for (const Piece& piece : pieces_)
    if (piece.element == place.element) {
      const double whole = rod_->elements[index(piece.element)].length;
      return piece.start + (piece.backwards ? whole - place.s : place.s);
    }
  return std::nullopt;
}

int farthest_end(const Vessel& vessel, int end) {
  int farthest = end;
  double length = -1;
  for (size_t k = 0; k < vessel.ends.size(); ++k) {
    if (static_cast<int>(k) == end) continue;
    const double here = AxisRoute(vessel, {end, static_cast<int>(k)}).length();
    // Ends that are as far away to rounding: the first one, on every machine.
    if (here <= length * (1 + 1e-9)) continue;
    farthest = static_cast<int>(k);
    length = here;
  }
  return farthest;
}

std::vector<int> other_ends(const Vessel& vessel, int end) {
  std::vector<int> others{farthest_end(vessel, end)};
  for (int k = 0; k < static_cast<int>(vessel.ends.size()); ++k)
    if (k != end && k != others.front()) others.push_back(k);
  return others;
}

}  // namespace vasorod
