#include "report/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "data/sentence.h"

namespace vasorod {

namespace {

// Moreland's cool-warm (2009), and the light part of matplotlib's magma (CC0) in reverse order, so
// that zero is pale.
constexpr std::array<std::uint32_t, 17> cool_warm{
    0x3b4cc0, 0x4e68d8, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2fe, 0xb9d0f9, 0xccd9ed, 0xdddcdc,
    0xecd3c5, 0xf5c4ac, 0xf7b093, 0xf4987a, 0xeb7d62, 0xdd5f4b, 0xca3b37, 0xb40426};
constexpr std::array<std::uint32_t, 17> magma{
    0xfcf0b2, 0xfed89a, 0xfec185, 0xfea772, 0xfc8e64, 0xf8765c, 0xf05f5e, 0xe24d66, 0xcf4070,
    0xba3878, 0xa5317e, 0x8e2a81, 0x792282, 0x651a80, 0x51127c, 0x3b0f70, 0x251255};
constexpr std::array<std::uint32_t, 2> greys{0xe4e4e4, 0x8a8a8a};

Colour colour_of(std::uint32_t rgb) {
  return {static_cast<float>(rgb >> 16 & 255U) / 255, static_cast<float>(rgb >> 8 & 255U) / 255,
          static_cast<float>(rgb & 255U) / 255};
}

// The largest of 1, 2, 5 times a power of ten that gives at least four steps.
double step_of(double width) {
  const double power = std::pow(10, std::floor(std::log10(width / 4)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= width / 4) return factor * power;
  return power;
}

}  // namespace

std::span<const std::uint32_t> colours_of(ColourMap map) {
  if (map == ColourMap::grey) return greys;
  return map == ColourMap::diverging ? std::span(cool_warm) : std::span(magma);
}

Colour ColourScale::operator()(double value) const {
  if (!std::isfinite(value)) return {0.5F, 0.5F, 0.5F};
  const auto colours = colours_of(map);
  const double at =
      std::clamp((value - low) / (high - low), 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  const auto t = static_cast<float>(at - static_cast<double>(first));
  const Colour a = colour_of(colours[first]), b = colour_of(colours[first + 1]);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

std::vector<double> ColourScale::ticks() const {
  if (map == ColourMap::grey) return {};
  const double step = step_of((high - low) * shown_per) / shown_per, slack = 1e-9 * (high - low);
  std::vector<double> values;
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k)
    values.push_back(k == 0 ? 0 : k * step);
  return values;
}

std::string ColourScale::text_at(double tick) const {
  return tick_text(tick * shown_per, step_of((high - low) * shown_per));
}

std::string tick_text(double value, double step) {
  const double size = std::max(std::abs(value), step);
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  if (value == 0) return "0";
  return digits > 4 || size >= 1e6 ? number_text(value, 3) : fixed_text(value, digits);
}

ColourScale scale_for(ColourMap map, const std::string& title,
                      std::span<const Eigen::VectorXd* const> fields, double neutral,
                      double reach) {
  double low = map == ColourMap::diverging ? neutral - reach : neutral, high = neutral + reach;
  for (const Eigen::VectorXd* field : fields)
    for (const double value : *field)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (map == ColourMap::diverging) {
    const double most = std::max(high - neutral, neutral - low);
    low = neutral - most;
    high = neutral + most;
  }
  // Without this, a field of constant value would show its rounding errors.
  if (high - low <= 1e-9 * std::max(1.0, std::abs(neutral))) {
    high = neutral + (map == ColourMap::diverging ? 0.01 : 1);
    low = map == ColourMap::diverging ? neutral - 0.01 : neutral;
  }
  return {map, low, high, title, 1};
}

}  // namespace vasorod
