#include "surgery/cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/level_set_split.h"
#include "geometry/plane_section.h"
#include "geometry/surface_editor.h"
#include "geometry/triangle_surface.h"
#include "surgery/cap.h"

namespace vasorod {
namespace {

const SectionLoop& curve_to_cut(const std::vector<SectionLoop>& curves, const Pose& section,
                                const Vec3& pick) {
  const Vec3 normal = section.director(3);
  if (curves.empty())
    throw InputError("cut at " + place_text(pick) +
                     ": the section's plane misses the vessel, expected it to cross it");
  int index = section_around(curves, section.position, normal);
  const auto encloses = [&](int i) {
    return curves[static_cast<size_t>(i)].closed &&
           section_around({curves[static_cast<size_t>(i)]}, section.position, normal) == 0;
  };
  if (!encloses(index)) index = section_around(curves, pick, normal);
  const SectionLoop& curve = curves[static_cast<size_t>(index)];
  if (!curve.closed)
    throw InputError("cut at " + place_text(pick) +
                     ": the section's plane runs into an open end of the vessel, expected a "
                     "section clear of its ends");
  return curve;
}

// The boundary loop of a part that contains only the cycle's vertices.
std::vector<int> mouth_of(const SurfaceEditor::Part& part, const std::vector<int>& loop) {
  const std::set<int> on_loop(loop.begin(), loop.end());
  for (auto& boundary : boundary_loops(part.surface.triangles))
    if (on_loop.contains(part.vertices[static_cast<size_t>(boundary.front())]) &&
        boundary.size() == loop.size())
      return boundary;
  return {};
}

}  // namespace

CutOutcome cut_vessel(const TriangleSurface& surface, const Pose& section, const Vec3& pick,
                      const Vec3& keep_near) {
  const Vec3 normal = section.director(3);
  const std::string where = "cut at " + place_text(pick);
  const auto ends = boundary_loops(surface.triangles);
  if (ends.empty())
    throw InputError(where + ": the vessel has no open end, expected at least one to keep");
  const auto curves = plane_sections(surface, section.position, normal);
  const SectionLoop& curve = curve_to_cut(curves, section, pick);

  std::vector<char> at_end(static_cast<size_t>(surface.points.rows()), 0);
  for (const auto& end : ends)
    for (const int v : end) at_end[static_cast<size_t>(v)] = 1;
  for (const int t : curve.triangles)
    for (int k = 0; k < 3; ++k)
      if (at_end[static_cast<size_t>(surface.triangles(t, k))])
        throw InputError(where +
                         ": the cut comes within one triangle of an open end of the vessel near " +
                         place_text(surface.points.row(surface.triangles(t, k))) +
                         ", expected a section clear of its ends");

  const Eigen::VectorXd height = (surface.points.rowwise() - section.position.transpose()) * normal;
  const std::vector<double> f(height.begin(), height.end());
  SurfaceEditor editor(surface);
  auto loop = split_level_set(editor, f, curve.edges);
  if (loop.empty()) {  // too coarse or irregular for snapping: cut exactly, without snapping
    EditTolerances exact;
    exact.snap = 0;
    editor = SurfaceEditor(surface, exact);
    loop = split_level_set(editor, f, curve.edges);
  }
  if (loop.empty())
    throw InputError(
        where + ": the surface is too irregular there to be cut cleanly, expected it remeshed");

  const auto parts = parts_beside(editor, loop);
  if (parts.size() != 2)
    throw InputError(where + ": the cut leaves the vessel in " + std::to_string(parts.size()) +
                     (parts.size() == 1 ? " part" : " parts") +
                     ", expected it to divide the vessel in two");

  // The part with the end to keep. The cut never changes vertices of an end.
  size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  Vec3 kept_end = Vec3::Zero();
  for (size_t i = 0; i < ends.size(); ++i) {
    Vec3 center = Vec3::Zero();
    for (const int v : ends[i])
      center += surface.points.row(v).transpose() / static_cast<double>(ends[i].size());
    if ((center - keep_near).norm() >= best) continue;
    best = (center - keep_near).norm();
    nearest = i;
    kept_end = center;
  }
  const int kept_triangle = editor.triangles_of(ends[nearest].front()).front();
  const bool second = std::binary_search(parts[1].begin(), parts[1].end(), kept_triangle);
  const auto kept = editor.part(parts[second ? 1 : 0]), stump = editor.part(parts[second ? 0 : 1]);

  CutOutcome outcome;
  outcome.mouth = mouth_of(kept, loop);
  const auto stump_mouth = mouth_of(stump, loop);
  if (outcome.mouth.empty() || stump_mouth.empty())
    throw InputError(
        where +
        ": the cut does not leave one clean mouth, expected a section clear of forks and ends");
  outcome.kept = kept.surface;
  outcome.kept_sources = kept.sources;
  outcome.perimeter = perimeter(kept.surface.points, outcome.mouth);
  SectionLoop polygon;
  polygon.points.resize(static_cast<Eigen::Index>(outcome.mouth.size()), 3);
  for (size_t k = 0; k < outcome.mouth.size(); ++k)
    polygon.points.row(static_cast<Eigen::Index>(k)) = kept.surface.points.row(outcome.mouth[k]);
  outcome.center = section_centroid(polygon);
  // The surface is on the left of the loop, so the area vector points into the surface.
  outcome.normal =
      area_vector(kept.surface.points, outcome.mouth).dot(normal) > 0 ? Vec3(-normal) : normal;

  const double radius = outcome.perimeter / (2 * M_PI);
  if ((kept_end - outcome.center).norm() < 0.25 * radius)
    throw InputError(where + ": the cut would leave nothing of the vessel, only " +
                     number_text((kept_end - outcome.center).norm(), 4) +
                     " up to the kept end, expected at least a quarter of its radius " +
                     number_text(radius, 4));

  auto capped = close_planar_hole(stump.surface, stump_mouth);
  outcome.stump = std::move(capped.surface);
  outcome.stump_sources = compose(capped.sources, stump.sources);
  return outcome;
}

}  // namespace vasorod
