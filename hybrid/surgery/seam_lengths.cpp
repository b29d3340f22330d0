#include "surgery/seam_lengths.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"

namespace vasorod {
namespace {

// Way from the first knot along the new polygon, per knot, and the whole length at the end.
std::vector<double> arc_lengths(const Points& polygon) {
  std::vector<double> along{0};
  for (Eigen::Index k = 0; k < polygon.rows(); ++k)
    along.push_back(along.back() + (polygon.row((k + 1) % polygon.rows()) - polygon.row(k)).norm());
  return along;
}

// The ways of knots first+1 .. last-1 for which their shares in the arc length between the knots
// `first` and `last` are those of `wanted`. One step of a fixed-point iteration; returns the
// largest change.
double redistribute(std::vector<double>& ways, const std::vector<double>& along,
                    const std::vector<double>& wanted, size_t first, size_t last) {
  const std::vector<double> before = ways;
  const auto way = [&](size_t k) { return k < before.size() ? before[k] : 1.0; };
  const double whole = along[last] - along[first], wanted_whole = wanted[last] - wanted[first];
  double change = 0;
  size_t at = first;
  for (size_t k = first + 1; k < last; ++k) {
    const double target = along[first] + whole * (wanted[k] - wanted[first]) / wanted_whole;
    while (at + 1 < last && along[at + 1] < target) ++at;
    const double t = (target - along[at]) / (along[at + 1] - along[at]);
    ways[k] = way(at) + t * (way(at + 1) - way(at));
    change = std::max(change, std::abs(ways[k] - before[k]));
  }
  return change;
}

}  // namespace

Points knot_points(const SeamCurve& curve, const std::vector<char>& slides,
                   const std::vector<double>& ways) {
  const auto n = static_cast<int>(ways.size());
  Points points(n, 3);
  for (int k = 0; k < n; ++k)
    if (slides[index(k)]) points.row(k) = curve.loop.at(curve.fraction(ways[index(k)]));
  for (int k = 0; k < n; ++k) {
    if (slides[index(k)]) continue;
    int before = k - 1, after = k + 1;
    while (!slides[index((before + n) % n)]) --before;
    while (!slides[index(after % n)]) ++after;
    const double begin = ways[index((before + n) % n)] - (before < 0),
                 end = ways[index(after % n)] + (after >= n);
    const double t = (ways[index(k)] - begin) / (end - begin);
    points.row(k) = (1 - t) * points.row((before + n) % n) + t * points.row(after % n);
  }
  return points;
}

SeamPlaces equal_shares(const SeamCurve& mouth, const SeamCurve& rim,
                        const std::vector<SeamKnot>& knots, int other_tip) {
  std::vector<char> on_mouth, on_rim;
  SeamPlaces places;
  size_t tip = 0;  // the knot at the other tip
  for (size_t k = 0; k < knots.size(); ++k) {
    on_mouth.push_back(knots[k].mouth >= 0);
    on_rim.push_back(knots[k].rim >= 0);
    places.mouth.push_back(knots[k].position);
    places.rim.push_back(knots[k].position);
    if (knots[k].rim == other_tip) tip = k;
  }
  // Each step reduces the error by the square of the angle between neighbouring edges.
  constexpr int most_steps = 100;
  constexpr double exact = 1e-14;
  for (int step = 0; step < most_steps; ++step) {
    const auto a = arc_lengths(knot_points(mouth, on_mouth, places.mouth));
    const auto b = arc_lengths(knot_points(rim, on_rim, places.rim));
    // On the rim, the banks keep their tips; on the mouth, the other tip divides like the banks.
    double change = redistribute(places.rim, b, a, 0, tip);
    change = std::max(change, redistribute(places.rim, b, a, tip, knots.size()));
    const double shift = b[tip] / b.back() - a[tip] / a.back();
    places.mouth[tip] += shift;
    if (std::max(change, std::abs(shift)) < exact) break;
  }
  return places;
}

}  // namespace vasorod
