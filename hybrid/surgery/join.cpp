#include "surgery/join.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/loops.h"
#include "geometry/surface_editor.h"
#include "surgery/seam_knots.h"
#include "surgery/seam_lengths.h"
#include "surgery/slide_loop.h"

namespace vasorod {
namespace {

// Worst triangles that a slide may leave (EditTolerances::min_quality). The next one is tried where
// no choice of knots works with the one before.
constexpr double triangle_qualities[] = {0.35, 0.12, 0.02};
// Index of the other tip of a rim that has none.
constexpr int no_tip = -1;

// The vertices of both loops in the mouth's order from the first tip, and their indices in the
// loops.
struct Order {
  SeamCorners corners;
  std::vector<int> mouth, rim;  // index into the loop, per corner
};

Order order_of(const SeamCurve& mouth, const SeamCurve& rim, int other_tip) {
  Order order;
  const auto list = [](const SeamCurve& curve, std::vector<int>& at, std::vector<double>& ways) {
    const int n = curve.loop.count();
    std::vector<std::pair<double, int>> all;
    for (int k = 0; k < n; ++k) {
      const double ahead = curve.loop.position(k) / curve.loop.length() - curve.start;
      const double way = curve.reversed ? -ahead : ahead;
      all.emplace_back(way - std::floor(way), k);
    }
    std::sort(all.begin(), all.end());
    for (const auto& [way, k] : all) {
      ways.push_back(way);
      at.push_back(k);
    }
  };
  list(mouth, order.mouth, order.corners.mouth);
  list(rim, order.rim, order.corners.rim);
  order.corners.other_tip = static_cast<int>(
      std::find(order.rim.begin(), order.rim.end(), other_tip) - order.rim.begin());
  return order;
}

// A surface of the seam while its loop is changed.
struct Side {
  SurfaceEditor editor;
  SlidLoop loop;  // its vertices are per knot
};

Side divide(const TriangleSurface& surface, const std::vector<int>& loop, const SeamCurve& curve,
            const std::vector<int>& corners, const std::vector<SeamKnot>& knots,
            int SeamKnot::*corner, const std::vector<double>& ways,
            const EditTolerances& tolerances) {
  const size_t n = knots.size();
  std::vector<LoopTarget> targets(n);
  for (size_t k = 0; k < n; ++k) {
    LoopTarget& target = targets[k];
    target.fraction = curve.fraction(ways[k]);
    if (knots[k].*corner >= 0) {
      target.corner = corners[index(knots[k].*corner)];
      continue;
    }
    size_t next = k;
    while (knots[next % n].*corner < 0) ++next;
    const double before = k > 0 ? ways[k - 1] : ways[n - 1] - 1,
                 after = ways[next % n] + (next >= n ? 1 : 0);
    target.between = (ways[k] - before) / (after - before);
  }
  Side side{SurfaceEditor(surface, tolerances), {}};
  side.loop = slide_loop(side.editor, loop, curve.loop, targets);
  return side;
}

// Notes what the meshes refused. False: nothing is left to give up.
bool note_refusals(const std::vector<SeamKnot>& knots, const Side& mouth, const Side& rim,
                   int other_tip, SeamRefusals& refusals) {
  bool changed = false;
  for (const Side* side : {&mouth, &rim})
    for (const int k : side->loop.refused) {
      const SeamKnot& knot = knots[index(k)];
      if (knot.mouth >= 0 && knot.rim >= 0) {
        // The pair meets at the mouth's vertex, midway, at the rim's vertex, or not at all.
        const bool tip = knot.rim == 0 || knot.rim == other_tip;
        double& share = refusals.share[{knot.mouth, knot.rim}];
        changed |= share <= 1;
        share = tip ? 2 : share + 0.5;
        continue;
      }
      char& stays = knot.mouth >= 0 ? refusals.mouth_stays[index(knot.mouth)]
                                    : refusals.rim_stays[index(knot.rim)];
      changed |= stays == 0;
      stays = 1;
    }
  return changed;
}

Points rows_of(const Points& points, const std::vector<int>& rows) {
  Points result(static_cast<Eigen::Index>(rows.size()), 3);
  for (size_t k = 0; k < rows.size(); ++k)
    result.row(static_cast<Eigen::Index>(k)) = points.row(rows[k]);
  return result;
}

// The joined surfaces and their pairs, in the rim's order, which is the reverse of the mouth's.
void take(const Side& mouth, const Side& rim, const std::vector<SeamKnot>& knots, int other_tip,
          JoinOutcome& outcome) {
  // No vertex was removed: the editors' indices are the surfaces'.
  auto first_part = mouth.editor.whole(), second_part = rim.editor.whole();
  outcome.first = std::move(first_part.surface);
  outcome.first_sources = std::move(first_part.sources);
  outcome.second = std::move(second_part.surface);
  outcome.second_sources = std::move(second_part.sources);
  for (size_t k = 0; k < knots.size(); ++k) {
    const size_t at = (knots.size() - k) % knots.size();
    if (knots[at].rim == other_tip) outcome.other_tip = static_cast<int>(k);
    outcome.pairs.push_back({mouth.loop.vertices[at], rim.loop.vertices[at]});
  }
}

JoinOutcome matched(const TriangleSurface& first, const std::vector<int>& mouth,
                    const Points& mouth_start, const TriangleSurface& second,
                    const std::vector<int>& rim, const Points& rim_start, int other_tip) {
  if (mouth_start.rows() != static_cast<Eigen::Index>(mouth.size()) ||
      rim_start.rows() != static_cast<Eigen::Index>(rim.size()))
    throw std::logic_error("match_seam: one start position per vertex of a loop is needed");
  const LoopCurve mouth_curve(mouth_start), rim_curve(rim_start);
  JoinOutcome outcome;
  outcome.offset = opposite_offset(mouth_curve, rim_curve);
  outcome.rms_distance = std::sqrt(opposite_distance(mouth_curve, rim_curve, outcome.offset));

  const SeamCurve on_mouth{LoopCurve(rows_of(first.points, mouth)), outcome.offset, false},
      on_rim{LoopCurve(rows_of(second.points, rim)), 0, true};
  const Order order = order_of(on_mouth, on_rim, other_tip);
  for (const double quality : triangle_qualities) {
    SeamRefusals refusals{{}, std::vector<char>(mouth.size(), 0), std::vector<char>(rim.size(), 0)};
    EditTolerances tolerances;
    tolerances.min_quality = quality;
    while (true) {
      const auto knots = choose_knots(order.corners, refusals);
      const auto places = equal_shares(on_mouth, on_rim, knots, order.corners.other_tip);
      const Side above = divide(first, mouth, on_mouth, order.mouth, knots, &SeamKnot::mouth,
                                places.mouth, tolerances);
      const Side below =
          divide(second, rim, on_rim, order.rim, knots, &SeamKnot::rim, places.rim, tolerances);
      if (above.loop.refused.empty() && below.loop.refused.empty()) {
        take(above, below, knots, order.corners.other_tip, outcome);
        return outcome;
      }
      if (!note_refusals(knots, above, below, order.corners.other_tip, refusals)) break;
    }
  }
  throw InputError("seam near " + place_text(second.points.row(rim.front())) +
                   ": the triangles beside the cut or the incision are too irregular for pairs at "
                   "equal arc length, expected rounder ones, as `remesh` makes them");
}

}  // namespace

JoinOutcome match_seam(const TriangleSurface& first, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& second,
                       const std::vector<int>& rim, int other_tip) {
  return matched(first, mouth, mouth_start, second, rim, rows_of(second.points, rim), other_tip);
}

JoinOutcome match_seam(const TriangleSurface& first, const std::vector<int>& mouth,
                       const Points& mouth_start, const TriangleSurface& second,
                       const std::vector<int>& rim, const Points& rim_start) {
  return matched(first, mouth, mouth_start, second, rim, rim_start, no_tip);
}

WeldedSurface weld(const TriangleSurface& first, const TriangleSurface& second,
                   const std::vector<std::array<int, 2>>& pairs) {
  WeldedSurface welded;
  const auto first_count = first.points.rows();
  std::vector<int> number(static_cast<size_t>(second.points.rows()), -1);
  for (int v = 0; v < first_count; ++v) welded.origin.push_back({v, -1});
  for (const auto& [a, b] : pairs) {
    number[static_cast<size_t>(b)] = a;
    welded.origin[static_cast<size_t>(a)][1] = b;
  }
  for (int v = 0; v < second.points.rows(); ++v) {
    if (number[static_cast<size_t>(v)] >= 0) continue;
    number[static_cast<size_t>(v)] = static_cast<int>(welded.origin.size());
    welded.origin.push_back({-1, v});
  }
  welded.surface.points.resize(static_cast<Eigen::Index>(welded.origin.size()), 3);
  for (size_t i = 0; i < welded.origin.size(); ++i) {
    const auto [a, b] = welded.origin[i];
    auto row = welded.surface.points.row(static_cast<Eigen::Index>(i));
    if (a >= 0 && b >= 0)
      row = (first.points.row(a) + second.points.row(b)) / 2;
    else
      row = a >= 0 ? first.points.row(a) : second.points.row(b);
  }
  welded.surface.triangles.resize(first.triangles.rows() + second.triangles.rows(), 3);
  welded.surface.triangles.topRows(first.triangles.rows()) = first.triangles;
  for (int t = 0; t < second.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      welded.surface.triangles(first.triangles.rows() + t, k) =
          number[static_cast<size_t>(second.triangles(t, k))];
  return welded;
}

}  // namespace vasorod
