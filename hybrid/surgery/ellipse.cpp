#include "surgery/ellipse.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/level_set_split.h"
#include "geometry/triangle_surface.h"
#include "surgery/drawn_ellipse.h"
#include "surgery/incision_place.h"

namespace vasorod {
namespace {

using Chart = Eigen::MatrixX2d;

// The plane coordinates of the editor's vertices.
Vec2 plane_point(const SurfaceEditor& editor, const Chart& chart, int v) {
  const VertexSource& source = editor.source(v);
  Vec2 sum = Vec2::Zero();
  for (size_t k = 0; k < source.vertex.size(); ++k)
    sum += source.weight[k] * chart.row(source.vertex[k]).transpose();
  return sum;
}

// Makes the cycle's crossing of the x axis on one side (the sign of x) a vertex of it; returns that
// vertex.
int put_tip(SurfaceEditor& editor, const Chart& chart, std::vector<int>& cycle, double side) {
  for (size_t k = 0; k < cycle.size(); ++k) {
    const int a = cycle[k], b = cycle[(k + 1) % cycle.size()];
    const Vec2 from = plane_point(editor, chart, a), to = plane_point(editor, chart, b);
    if (side * (from.x() + to.x()) < 0 || (from.y() < 0) == (to.y() < 0)) continue;
    const double t = from.y() / (from.y() - to.y()), length = editor.length(a, b);
    const int nearest = t < 0.5 ? a : b;
    if (std::min(t, 1 - t) * length > editor.snap()) {
      const int tip = editor.split_edge(a, b, t);
      cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(k) + 1, tip);
      return tip;
    }
    editor.move(nearest, {{a, 1 - t}, {b, t}});  // where that folds a triangle, nearly on the axis
    return nearest;
  }
  return -1;
}

// Moves a vertex of the cycle to a point of the plane near it: the cycle's edges are chords, so
// that a vertex on one of them lies inside the ellipse.
void move_to(SurfaceEditor& editor, const Chart& chart, int v, const Vec2& to) {
  for (const int t : editor.triangles_of(v)) {
    const auto& corners = editor.triangle(t);
    const Vec2 a = plane_point(editor, chart, corners[0]);
    Eigen::Matrix2d sides;
    sides << plane_point(editor, chart, corners[1]) - a, plane_point(editor, chart, corners[2]) - a;
    if (!(std::abs(sides.determinant()) > 0)) continue;
    const Vec2 share = sides.inverse() * (to - a);
    if (!(share.minCoeff() >= 0 && share.sum() <= 1)) continue;
    editor.move(v,
                {{corners[0], 1 - share.sum()}, {corners[1], share.x()}, {corners[2], share.y()}});
    return;
  }
}

}  // namespace

double ellipse_perimeter(double length, double width) {
  // 4 a E(k) = 2 pi (a^2 - sum of 2^(n-1) c_n^2) / agm(a, b), c_0^2 = a^2 - b^2 (Abramowitz and
  // Stegun 17.6).
  double a = std::max(length, width) / 2, b = std::min(length, width) / 2;
  if (b <= 0) return 4 * a;
  double sum = a * a - (a * a - b * b) / 2;
  for (double power = 1; std::abs(a - b) > 1e-15 * a; power *= 2) {
    const double c = (a - b) / 2;
    sum -= power * c * c;
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2 * M_PI * sum / ((a + b) / 2);
}

double ellipse_length(double perimeter, double width) {
  double low = width, high = std::max(width, perimeter / 2);  // a circle, a slit
  for (int halving = 0; halving < 200 && high > low; ++halving) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (ellipse_perimeter(middle, width) < perimeter ? low : high) = middle;
  }
  return (low + high) / 2;
}

IncisionOutcome open_ellipse(const TriangleSurface& surface, const RodTree& rod,
                             const Binding& binding, const std::vector<int>& branch_of,
                             const Vec3& pick, double length, double width, double max_distance) {
  const IncisionPlace place = place_incision(surface, branch_of, pick, max_distance);
  const double smallest = smallest_ellipse * mean_edge_length(surface);
  if (!(std::min(length, width) >= smallest))
    throw InputError(place.where + ": an ellipse " + number_text(length, 4) + " long and " +
                     number_text(width, 4) +
                     " wide is too small for the vessel's triangles, expected at least " +
                     number_text(smallest, 4) + " both ways, or a slit");
  const DrawnEllipse drawn(surface, rod, binding, place, length, width);
  drawn.require_room();

  SurfaceEditor editor(surface);
  auto cycle = split_level_set(editor, drawn.value(), drawn.crossing_edges());
  const int first = cycle.empty() ? -1 : put_tip(editor, drawn.chart(), cycle, -1);
  const int other = cycle.empty() ? -1 : put_tip(editor, drawn.chart(), cycle, +1);
  if (first >= 0) move_to(editor, drawn.chart(), first, {-length / 2, 0});
  if (other >= 0) move_to(editor, drawn.chart(), other, {length / 2, 0});
  const std::set<int> on_cycle(cycle.begin(), cycle.end());
  editor.improve([&](int a, int b) { return on_cycle.contains(a) && on_cycle.contains(b); });
  const auto sides = parts_beside(editor, cycle);
  if (first < 0 || other < 0 || first == other || sides.size() != 2)
    throw InputError(place.where + ": the surface is too irregular there for an ellipse " +
                     drawn.size_text() + ", expected it remeshed");

  // The piece to take out has the triangles on the right of the cycle.
  const int kept_triangle = editor.triangle_left_of(cycle[0], cycle[1]);
  const bool second = std::binary_search(sides[1].begin(), sides[1].end(), kept_triangle);
  const auto kept = editor.part(sides[second ? 1 : 0]);
  std::vector<int> number(index(editor.vertex_count()), -1);
  for (size_t i = 0; i < kept.vertices.size(); ++i)
    number[index(kept.vertices[i])] = static_cast<int>(i);
  std::rotate(cycle.begin(), std::find(cycle.begin(), cycle.end(), first), cycle.end());

  IncisionOutcome outcome;
  outcome.surface = kept.surface;
  outcome.sources = kept.sources;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const int v : cycle) {
    outcome.rim.push_back(number[index(v)]);
    low = low.cwiseMin(plane_point(editor, drawn.chart(), v));
    high = high.cwiseMax(plane_point(editor, drawn.chart(), v));
  }
  outcome.other_tip =
      static_cast<int>(std::find(cycle.begin(), cycle.end(), other) - cycle.begin());
  outcome.pick = place.hit.point;
  outcome.length = high.x() - low.x();
  outcome.width = high.y() - low.y();
  outcome.perimeter = perimeter(outcome.surface.points, outcome.rim);
  outcome.removed_area = total_area(editor.part(sides[second ? 0 : 1]).surface);
  return outcome;
}

}  // namespace vasorod
