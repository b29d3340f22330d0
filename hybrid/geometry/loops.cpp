#include "geometry/loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vasorod {
namespace {

// The first search of an offset compares the loops at this many points each.
constexpr int sample_count = 180;

double modulo_one(double x) {
  return x - std::floor(x);
}

}  // namespace

LoopCurve::LoopCurve(Points corners) : corners_(std::move(corners)), position_{0} {
  const Eigen::Index n = corners_.rows();
  for (Eigen::Index k = 0; k < n; ++k)
    position_.push_back(position_.back() + (corners_.row((k + 1) % n) - corners_.row(k)).norm());
}

LoopCurve::Place LoopCurve::place(double fraction) const {
  const double s = modulo_one(fraction) * length(), corner = 1e-12 * length();
  const auto after = std::upper_bound(position_.begin() + 1, position_.end() - 1, s);
  const auto k = static_cast<int>(after - position_.begin()) - 1;
  if (s - position(k) <= corner) return {k, 0};
  if (position(k + 1) - s <= corner) return {(k + 1) % count(), 0};
  return {k, (s - position(k)) / (position(k + 1) - position(k))};
}

Vec3 LoopCurve::at(const Place& place) const {
  return (1 - place.along) * corners_.row(place.edge) +
         place.along * corners_.row((place.edge + 1) % corners_.rows());
}

Vec3 LoopCurve::at(double fraction) const {
  return at(place(fraction));
}

double opposite_distance(const LoopCurve& a, const LoopCurve& b, double offset) {
  // Both points move along straight edges between the corners of either loop, so the squared
  // distance is a parabola there and Simpson's rule is exact.
  std::vector<double> corners;
  corners.reserve(static_cast<std::size_t>(a.count() + b.count()) + 1);
  for (int k = 0; k < a.count(); ++k) corners.push_back(a.position(k) / a.length());
  for (int k = 0; k < b.count(); ++k)
    corners.push_back(modulo_one(offset - b.position(k) / b.length()));
  std::sort(corners.begin(), corners.end());
  corners.push_back(corners.front() + 1);
  const auto squared = [&](double u) { return (a.at(u) - b.at(offset - u)).squaredNorm(); };
  double sum = 0, before = squared(corners.front());
  for (size_t k = 0; k + 1 < corners.size(); ++k) {
    const double after = squared(corners[k + 1]),
                 middle = squared((corners[k] + corners[k + 1]) / 2);
    sum += (corners[k + 1] - corners[k]) * (before + 4 * middle + after) / 6;
    before = after;
  }
  return sum;
}

double opposite_offset(const LoopCurve& a, const LoopCurve& b) {
  // At offsets that are multiples of the sample spacing, both loops use the same samples.
  std::vector<Vec3> on_a, on_b;
  for (int i = 0; i < sample_count; ++i) {
    on_a.push_back(a.at(static_cast<double>(i) / sample_count));
    on_b.push_back(b.at(static_cast<double>(i) / sample_count));
  }
  int best = 0;
  double best_sum = std::numeric_limits<double>::infinity();
  for (int offset = 0; offset < sample_count; ++offset) {
    double sum = 0;
    for (int i = 0; i < sample_count; ++i)
      sum += (on_a[static_cast<size_t>(i)] -
              on_b[static_cast<size_t>((offset - i + sample_count) % sample_count)])
                 .squaredNorm();
    if (sum < best_sum) {
      best_sum = sum;
      best = offset;
    }
  }
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = (best - 1.0) / sample_count, high = (best + 1.0) / sample_count;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = opposite_distance(a, b, left), at_right = opposite_distance(a, b, right);
  while (high - low > 1e-9) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = opposite_distance(a, b, left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = opposite_distance(a, b, right);
    }
  }
  return modulo_one((low + high) / 2);
}

}  // namespace vasorod
