#include "surgery/incision.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/closest_point.h"
#include "geometry/isoline_path.h"
#include "geometry/slit.h"

namespace vasorod {
namespace {

// Arc length of every vertex's section from the rod's root, extended by z beyond the rod's ends.
Eigen::VectorXd arc_length(const RodTree& rod, const Binding& binding) {
  std::vector<double> at_node(static_cast<size_t>(rod.node_count()), 0);
  for (const RodBranch& branch : rod.branches)
    for (size_t i = 0; i < branch.elements.size(); ++i)
      at_node[static_cast<size_t>(branch.nodes[i + 1])] =
          at_node[static_cast<size_t>(branch.nodes[i])] +
          rod.elements[static_cast<size_t>(branch.elements[i])].length;
  Eigen::VectorXd s(static_cast<Eigen::Index>(binding.size()));
  for (size_t v = 0; v < binding.size(); ++v) {
    const RodElement& element = rod.elements[static_cast<size_t>(binding[v].element)];
    s[static_cast<Eigen::Index>(v)] =
        at_node[static_cast<size_t>(element.first)] + binding[v].s + binding[v].local.z();
  }
  return s;
}

// y cos(theta0) - x sin(theta0) at every vertex, theta0 the angle at the hit.
Eigen::VectorXd half_plane_distance(const TriangleSurface& surface, const Binding& binding,
                                    const ClosestPoint::Hit& hit) {
  Vec2 there = Vec2::Zero();
  for (int k = 0; k < 3; ++k)
    there += hit.barycentric[k] *
             binding[static_cast<size_t>(surface.triangles(hit.triangle, k))].local.head<2>();
  there.normalize();
  Eigen::VectorXd across(static_cast<Eigen::Index>(binding.size()));
  for (size_t v = 0; v < binding.size(); ++v)
    across[static_cast<Eigen::Index>(v)] =
        there.x() * binding[v].local.y() - there.y() * binding[v].local.x();
  return across;
}

// Rounded down, so that the stated number fits.
std::string length_that_fits(double fits, double unit) {
  const auto rounded_down = [](double x) {
    const double digit = std::pow(10.0, std::floor(std::log10(std::max(x, 1e-300))) - 2);
    return number_text(std::floor(x / digit) * digit, 3);
  };
  if (!(unit > 0)) return rounded_down(fits);
  return rounded_down(fits) + ", `incision_length: " + rounded_down(fits / unit) + "`";
}

}  // namespace

IncisionOutcome open_incision(const TriangleSurface& surface, const RodTree& rod,
                              const Binding& binding, const std::vector<int>& branch_of,
                              const Vec3& pick, double length, double max_distance, double unit) {
  const std::string where = "incision at " + place_text(pick);
  const auto hit = ClosestPoint(surface).query(pick);
  if (std::abs(hit.signed_distance) > max_distance)
    throw InputError(where + ": the pick is " + number_text(std::abs(hit.signed_distance), 4) +
                     " off the vessel, expected at most its radius, " +
                     number_text(max_distance, 4));
  if (hit.on_boundary)
    throw InputError(where +
                     ": the pick lies at an open end of the vessel, expected one on its wall");

  SurfaceEditor editor(surface);
  if (!(length > 3 * editor.snap()))
    throw InputError(where + ": a length of " + number_text(length, 4) +
                     " is too short for the vessel's triangles, expected more than " +
                     number_text(3 * editor.snap(), 4));
  IsolineRequest request;
  request.across = half_plane_distance(surface, binding, hit);
  request.along = arc_length(rod, binding);
  request.triangle = hit.triangle;
  request.barycentric = hit.barycentric;
  request.length = length;
  int corner = 0;
  hit.barycentric.maxCoeff(&corner);
  const auto nearest = static_cast<size_t>(surface.triangles(hit.triangle, corner));
  request.allowed = [&](int v) {
    return branch_of.empty() || branch_of[static_cast<size_t>(v)] == branch_of[nearest];
  };
  for (int k = 0; k < 3; ++k)
    if (!request.allowed(surface.triangles(hit.triangle, k)))
      throw InputError(where +
                       ": the pick lies at a fork of the vessel, expected it on one branch");
  const auto path = embed_isoline(editor, request);
  if (path.end == IsolineEnd::boundary || path.end == IsolineEnd::forbidden)
    throw InputError(where + ": an incision of length " + number_text(length, 4) + " runs into " +
                     (path.end == IsolineEnd::boundary ? "an open end" : "a fork") +
                     " of the vessel near " + place_text(path.stopped_at) +
                     ", expected one of at most " + length_that_fits(path.fits, unit));
  if (path.end == IsolineEnd::lost)
    throw InputError(where + ": the direction along the vessel is lost near " +
                     place_text(path.stopped_at) +
                     ", expected a wall that runs along its centerline there");

  const Slit slit = open_slit(editor, path.vertices);

  const auto whole = editor.whole();
  std::vector<int> number(static_cast<size_t>(editor.vertex_count()), -1);
  for (size_t i = 0; i < whole.vertices.size(); ++i)
    number[static_cast<size_t>(whole.vertices[i])] = static_cast<int>(i);
  IncisionOutcome outcome;
  outcome.surface = whole.surface;
  outcome.sources = whole.sources;
  for (const int v : slit.rim) outcome.rim.push_back(number[static_cast<size_t>(v)]);
  outcome.other_tip = slit.other_tip;
  outcome.middle = path.start;
  outcome.pick = hit.point;
  outcome.length = path.backward + path.forward;
  return outcome;
}

}  // namespace vasorod
