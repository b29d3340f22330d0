#include "reference_fem/hole_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vasorod::fem {
namespace {

/// Arc length of an ellipse from the end of its shorter half axis, to the angle whose sine is the
/// share of the longer half axis.
double arc(double longer, double shorter, double angle) {
  const double ratio = shorter / longer;
  return longer * std::ellint_2(std::sqrt(std::max(0.0, 1 - ratio * ratio)), angle);
}

}  // namespace

double HoleChart::perimeter() const {
  return 4 * arc(std::max(half_length, half_width), std::min(half_length, half_width),
                 std::numbers::pi / 2);
}

Vec2 HoleChart::rim(double share) const {
  const bool long_hole = half_length >= half_width;
  const double longer = std::max(half_length, half_width),
               shorter = std::min(half_length, half_width),
               wanted = (long_hole ? 1 - share : share) * perimeter() / 4;
  double low = 0, high = std::numbers::pi / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle_angle = 0.5 * (low + high);
    (arc(longer, shorter, middle_angle) < wanted ? low : high) = middle_angle;
  }
  const double angle = share == 0 || share == 1
                           ? ((share == 0) == long_hole ? std::numbers::pi / 2 : 0)
                           : 0.5 * (low + high);
  const Vec2 point(longer * std::sin(angle), shorter * std::cos(angle));
  return long_hole ? point : Vec2(point[1], point[0]);
}

// A quarter of the strip in lengths from the middle: x along, y around. The line across the tube
// through the tip leaves it at 45 degrees, between rim and first line, and turns straight. Beside
// the hole, the block between the four lines is filled by transfinite interpolation.
Vec2 HoleChart::place(double share, double fraction) const {
  const double side = fraction < middle ? -1 : 1, lip = share > 0.5 ? -1 : 1;
  const double v = 2 * (lip < 0 ? 1 - share : share), x = std::abs(fraction - middle) * line,
               end = (side < 0 ? middle : 1 - middle) * line;
  const double turn = std::min(half_width, 0.5 * (end - half_length));
  const auto across = [&](double t) {  // from the tip
    return Vec2(half_length - turn * std::expm1(-t * half_around / turn), t * half_around);
  };
  Vec2 point;
  if (x <= half_length) {
    const double u = x / half_length;
    const Vec2 bottom = rim(1 - u), top(u * across(1)[0], half_around),
               left(0, half_width + v * (half_around - half_width)), right = across(v);
    point = (1 - v) * bottom + v * top + (1 - u) * left + u * right -
            ((1 - u) * (1 - v) * Vec2(0, half_width) + u * (1 - v) * across(0) +
             (1 - u) * v * Vec2(0, half_around) + u * v * across(1));
  } else {
    const double w = (x - half_length) / (end - half_length);
    point = (1 - w) * across(v) + w * Vec2(end, v * half_around);
  }
  const double around = 0.5 * point[1] / half_around;
  return {lip < 0 ? 1 - around : around, middle + side * point[0] / line};
}

}  // namespace vasorod::fem
