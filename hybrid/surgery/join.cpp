#include "surgery/join.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "geometry/loops.h"
#include "geometry/surface_editor.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// A corner of one of the loops, by arc length from the start of the matching, counted along the
// mouth for both loops.
struct Corner {
  double position;  // length unit
  int index;        // into the loop
};

// A vertex of both loops. Index -1: the loop has no corner there, its edge is split at the
// position.
struct Knot {
  Corner mouth, rim;
};

// Pairs the corners of two stretches with common ends: first the two closest ones, in fractions of
// their stretches, if closer than `tolerance`; then the parts to the left and right of that pair.
// The remaining corners have no counterpart.
class Matching {
 public:
  Matching(double tolerance, std::vector<Knot>& knots) : tolerance_(tolerance), knots_(knots) {}

  void stretch(const Knot& from, const std::vector<Corner>& mouth, const std::vector<Corner>& rim,
               const Knot& to) {
    const double on_mouth = to.mouth.position - from.mouth.position,
                 on_rim = to.rim.position - from.rim.position;
    const double mean = (on_mouth + on_rim) / 2;
    const auto fraction = [](const Corner& c, double begin, double whole) {
      return (c.position - begin) / whole;
    };
    double closest = std::numeric_limits<double>::infinity();
    size_t best_mouth = 0, best_rim = 0;
    for (size_t i = 0; i < mouth.size(); ++i)
      for (size_t j = 0; j < rim.size(); ++j) {
        const double distance = mean * std::abs(fraction(mouth[i], from.mouth.position, on_mouth) -
                                                fraction(rim[j], from.rim.position, on_rim));
        if (distance >= closest) continue;
        closest = distance;
        best_mouth = i;
        best_rim = j;
      }
    if (closest < tolerance_) {
      const Knot knot{mouth[best_mouth], rim[best_rim]};
      const auto head = [](const std::vector<Corner>& all, size_t n) {
        return std::vector<Corner>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
      };
      const auto tail = [](const std::vector<Corner>& all, size_t n) {
        return std::vector<Corner>(all.begin() + static_cast<std::ptrdiff_t>(n) + 1, all.end());
      };
      stretch(from, head(mouth, best_mouth), head(rim, best_rim), knot);
      knots_.push_back(knot);
      stretch(knot, tail(mouth, best_mouth), tail(rim, best_rim), to);
      return;
    }
    std::vector<Knot> alone;
    for (const Corner& c : mouth)
      alone.push_back(
          {c, {from.rim.position + on_rim * fraction(c, from.mouth.position, on_mouth), -1}});
    for (const Corner& c : rim)
      alone.push_back(
          {{from.mouth.position + on_mouth * fraction(c, from.rim.position, on_rim), -1}, c});
    std::sort(alone.begin(), alone.end(),
              [](const Knot& l, const Knot& r) { return l.mouth.position < r.mouth.position; });
    knots_.insert(knots_.end(), alone.begin(), alone.end());
  }

 private:
  double tolerance_;
  std::vector<Knot>& knots_;
};

// The knots in the mouth's order, starting with a pair of corners.
std::vector<Knot> match(const LoopCurve& mouth, const LoopCurve& rim, double offset,
                        double tolerance) {
  // The rim's corners by arc length along the mouth: u = offset - w.
  const double length = (mouth.length() + rim.length()) / 2;
  std::vector<double> u(static_cast<size_t>(mouth.count())), w(static_cast<size_t>(rim.count()));
  for (int i = 0; i < mouth.count(); ++i)
    u[static_cast<size_t>(i)] = mouth.position(i) / mouth.length();
  for (int j = 0; j < rim.count(); ++j) {
    const double x = offset - rim.position(j) / rim.length();
    w[static_cast<size_t>(j)] = x - std::floor(x);
  }
  size_t first_mouth = 0, first_rim = 0;
  double closest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < u.size(); ++i)
    for (size_t j = 0; j < w.size(); ++j) {
      const double distance = std::abs(std::remainder(u[i] - w[j], 1.0));
      if (distance >= closest) continue;
      closest = distance;
      first_mouth = i;
      first_rim = j;
    }
  const auto after = [&](const std::vector<double>& all, size_t first, int direction) {
    std::vector<Corner> corners;
    const auto n = static_cast<int>(all.size());
    for (int k = 1; k < n; ++k) {
      const int index = ((static_cast<int>(first) + direction * k) % n + n) % n;
      const double x = all[static_cast<size_t>(index)] - all[first];
      corners.push_back({(x - std::floor(x)) * length, index});
    }
    return corners;
  };
  const Knot start{{0, static_cast<int>(first_mouth)}, {0, static_cast<int>(first_rim)}};
  const Knot end{{length, start.mouth.index}, {length, start.rim.index}};
  std::vector<Knot> knots{start};
  Matching(tolerance, knots)
      .stretch(start, after(u, first_mouth, +1), after(w, first_rim, -1), end);
  return knots;
}

// The shortest piece that would result from splitting a loop's edges.
double shortest_piece(const std::vector<Knot>& knots, Corner Knot::*loop, double length) {
  double shortest = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < knots.size(); ++k) {
    const Corner& a = knots[k].*loop;
    const Corner& b = knots[(k + 1) % knots.size()].*loop;
    if (a.index >= 0 && b.index >= 0) continue;
    shortest = std::min(shortest, b.position - a.position + (k + 1 == knots.size() ? length : 0));
  }
  return shortest;
}

// The vertex of every knot; splits the loop's edges where it has no corner.
std::vector<int> knot_vertices(SurfaceEditor& editor, const std::vector<int>& loop,
                               const std::vector<Knot>& knots, Corner Knot::*side, double length) {
  std::vector<int> vertices(knots.size(), -1);
  const size_t n = knots.size();
  for (size_t k = 0; k < n; ++k) {
    const Corner& here = knots[k].*side;
    if (here.index >= 0) {
      vertices[k] = loop[static_cast<size_t>(here.index)];
      continue;
    }
    size_t next =
        k + 1;  // the first knot is a corner of both loops, so knots exist before and after
    while ((knots[next % n].*side).index < 0) ++next;
    const double end = next >= n ? length : (knots[next].*side).position;
    const double begin = (knots[k - 1].*side).position;
    vertices[k] =
        editor.split_edge(vertices[k - 1], loop[static_cast<size_t>((knots[next % n].*side).index)],
                          (here.position - begin) / (end - begin));
  }
  return vertices;
}

Points rows_of(const Points& points, const std::vector<int>& rows) {
  Points result(static_cast<Eigen::Index>(rows.size()), 3);
  for (size_t k = 0; k < rows.size(); ++k)
    result.row(static_cast<Eigen::Index>(k)) = points.row(rows[k]);
  return result;
}

}  // namespace

JoinOutcome match_seam(const TriangleSurface& svc, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& rpa,
                       const std::vector<int>& rim, int other_tip) {
  if (mouth_start.rows() != static_cast<Eigen::Index>(mouth.size()))
    throw std::logic_error("match_seam: one start position per vertex of the mouth is needed");
  const LoopCurve mouth_curve(mouth_start), rim_curve(rows_of(rpa.points, rim));
  JoinOutcome outcome;
  outcome.offset = opposite_offset(mouth_curve, rim_curve);
  outcome.rms_distance = std::sqrt(opposite_distance(mouth_curve, rim_curve, outcome.offset));

  SurfaceEditor svc_editor(svc), rpa_editor(rpa);
  const double length = (mouth_curve.length() + rim_curve.length()) / 2;
  const double fine = std::min(svc_editor.mean_edge(), rpa_editor.mean_edge());
  const double coarse = std::max(svc_editor.mean_edge(), rpa_editor.mean_edge());
  // Where corners of one loop are close together, a short piece may remain on the other. Tries
  // several tolerances, and shifts by a fraction of an edge, and takes the first without a short
  // piece, or the best.
  std::vector<Knot> knots;
  double best = -1;
  for (const double shift : {0.0, 0.1, -0.1, 0.2, -0.2})
    for (const double factor : {0.3, 0.27, 0.33, 0.24, 0.36, 0.2, 0.4}) {
      if (best > 0.2) continue;
      auto trial = match(mouth_curve, rim_curve, outcome.offset + shift * fine / length,
                         std::max(factor * fine, 0.1 * coarse));
      const double worst =
          std::min(shortest_piece(trial, &Knot::mouth, length) / svc_editor.mean_edge(),
                   shortest_piece(trial, &Knot::rim, length) / rpa_editor.mean_edge());
      if (worst <= best) continue;
      best = worst;
      knots = std::move(trial);
    }

  const auto on_mouth = knot_vertices(svc_editor, mouth, knots, &Knot::mouth, length);
  const auto on_rim = knot_vertices(rpa_editor, rim, knots, &Knot::rim, length);
  const auto finish = [](SurfaceEditor& editor, const std::vector<int>& loop) {
    const std::set<int> on_loop(loop.begin(), loop.end());
    editor.improve([&](int a, int b) { return on_loop.contains(a) && on_loop.contains(b); });
    return editor.whole();  // no vertex was removed: the editor's indices are the surface's
  };
  auto svc_part = finish(svc_editor, on_mouth), rpa_part = finish(rpa_editor, on_rim);
  outcome.svc = std::move(svc_part.surface);
  outcome.svc_sources = std::move(svc_part.sources);
  outcome.rpa = std::move(rpa_part.surface);
  outcome.rpa_sources = std::move(rpa_part.sources);

  // In the rim's order, the reverse of the mouth's.
  const auto first = std::find(on_rim.begin(), on_rim.end(), rim.front()) - on_rim.begin();
  const auto n = static_cast<std::ptrdiff_t>(on_rim.size());
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const auto at = static_cast<size_t>(((first - k) % n + n) % n);
    if (on_rim[at] == rim[static_cast<size_t>(other_tip)]) outcome.other_tip = static_cast<int>(k);
    outcome.pairs.push_back({on_mouth[at], on_rim[at]});
  }
  return outcome;
}

WeldedSurface weld(const TriangleSurface& svc, const TriangleSurface& rpa,
                   const std::vector<std::array<int, 2>>& pairs) {
  WeldedSurface welded;
  const auto svc_count = svc.points.rows();
  std::vector<int> number(static_cast<size_t>(rpa.points.rows()), -1);
  for (int v = 0; v < svc_count; ++v) welded.origin.push_back({v, -1});
  for (const auto& [a, b] : pairs) {
    number[static_cast<size_t>(b)] = a;
    welded.origin[static_cast<size_t>(a)][1] = b;
  }
  for (int v = 0; v < rpa.points.rows(); ++v) {
    if (number[static_cast<size_t>(v)] >= 0) continue;
    number[static_cast<size_t>(v)] = static_cast<int>(welded.origin.size());
    welded.origin.push_back({-1, v});
  }
  welded.surface.points.resize(static_cast<Eigen::Index>(welded.origin.size()), 3);
  for (size_t i = 0; i < welded.origin.size(); ++i) {
    const auto [a, b] = welded.origin[i];
    auto row = welded.surface.points.row(static_cast<Eigen::Index>(i));
    if (a >= 0 && b >= 0)
      row = (svc.points.row(a) + rpa.points.row(b)) / 2;
    else
      row = a >= 0 ? svc.points.row(a) : rpa.points.row(b);
  }
  welded.surface.triangles.resize(svc.triangles.rows() + rpa.triangles.rows(), 3);
  welded.surface.triangles.topRows(svc.triangles.rows()) = svc.triangles;
  for (int t = 0; t < rpa.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      welded.surface.triangles(svc.triangles.rows() + t, k) =
          number[static_cast<size_t>(rpa.triangles(t, k))];
  return welded;
}

}  // namespace vasorod
