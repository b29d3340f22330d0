#include "surgery/incision_place.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"

namespace vasorod {

IncisionPlace place_incision(const TriangleSurface& surface, const std::vector<int>& branch_of,
                             const Vec3& pick, double max_distance) {
  IncisionPlace place;
  place.where = "incision at " + place_text(pick);
  place.hit = closest_on(surface, pick);
  const double distance = std::abs(place.hit.signed_distance);
  if (distance > max_distance)
    throw InputError(place.where + ": the pick is " + number_text(distance, 4) +
                     " off the vessel, expected at most its radius, " +
                     number_text(max_distance, 4));
  if (place.hit.on_boundary)
    throw InputError(place.where +
                     ": the pick lies at an open end of the vessel, expected one on its wall");
  int corner = 0;
  place.hit.barycentric.maxCoeff(&corner);
  const auto nearest = index(surface.triangles(place.hit.triangle, corner));
  place.allowed.assign(index(surface.points.rows()), 1);
  for (size_t v = 0; v < branch_of.size(); ++v)
    place.allowed[v] = branch_of[v] == branch_of[nearest] ? 1 : 0;
  for (int k = 0; k < 3; ++k)
    if (!place.allowed[index(surface.triangles(place.hit.triangle, k))])
      throw InputError(place.where +
                       ": the pick lies at a fork of the vessel, expected it on one branch");
  return place;
}

Eigen::VectorXd arc_length(const RodTree& rod, const Binding& binding) {
  std::vector<double> at_node(index(rod.node_count()), 0);
  for (const RodBranch& branch : rod.branches)
    for (size_t i = 0; i < branch.elements.size(); ++i)
      at_node[index(branch.nodes[i + 1])] =
          at_node[index(branch.nodes[i])] + rod.elements[index(branch.elements[i])].length;
  Eigen::VectorXd s(static_cast<Eigen::Index>(binding.size()));
  for (size_t v = 0; v < binding.size(); ++v) {
    const RodElement& element = rod.elements[index(binding[v].element)];
    s[static_cast<Eigen::Index>(v)] =
        at_node[index(element.first)] + binding[v].s + binding[v].local.z();
  }
  return s;
}

std::string rounded_down(double length) {
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(length, 1e-300))) - 2);
  return number_text(std::floor(length / digit) * digit, 3);
}

}  // namespace vasorod
