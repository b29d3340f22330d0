#include "surgery/incision.h"

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/isoline_path.h"
#include "geometry/slit.h"
#include "geometry/triangle_surface.h"
#include "surgery/incision_place.h"

namespace vasorod {
namespace {

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

// The length that fits, and the key that gives it.
std::string length_that_fits(double fits, double unit) {
  if (!(unit > 0)) return rounded_down(fits);
  return rounded_down(fits) + ", `incision_length: " + rounded_down(fits / unit) + "`";
}

}  // namespace

IncisionOutcome open_incision(const TriangleSurface& surface, const RodTree& rod,
                              const Binding& binding, const std::vector<int>& branch_of,
                              const Vec3& pick, double length, double max_distance, double unit) {
  const IncisionPlace place = place_incision(surface, branch_of, pick, max_distance);
  const std::string& where = place.where;
  const ClosestPoint::Hit& hit = place.hit;

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
  request.allowed = [&](int v) { return place.allowed[index(v)] != 0; };
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
  outcome.perimeter = perimeter(outcome.surface.points, outcome.rim);
  return outcome;
}

}  // namespace vasorod
