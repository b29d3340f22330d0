// Values to colours, with the marks of a legend.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// sRGB, each 0 to 1.
using Colour = std::array<float, 3>;

/// diverging: blue to red through grey, for values about a neutral one. sequential: pale yellow to
/// dark violet, for values from zero up. grey: for values that say nothing; its scale has no ticks.
enum class ColourMap { diverging, sequential, grey };

struct ColourScale {
  ColourMap map = ColourMap::sequential;
  double low = 0, high = 1;
  std::string title;     ///< with the unit
  double shown_per = 1;  ///< numbers at the ticks per unit of the values: mmHg for stresses

  /// Values outside [low, high] have the colour of the nearer end. Values that are not finite are
  /// grey.
  Colour operator()(double value) const;
  /// About five values inside [low, high] whose shown numbers are round; none in grey.
  std::vector<double> ticks() const;
  /// What stands at a tick.
  std::string text_at(double tick) const;
};

/// The map's colours at equal steps, as 0xRRGGBB.
std::span<const std::uint32_t> colours_of(ColourMap map);

/// The value of a tick with no more digits than the ticks' step needs.
std::string tick_text(double value, double step);

/// A scale for the range of the values, at least `reach` to each side of `neutral` that the map
/// has, so that harmless values are pale. Diverging scales are symmetric about `neutral`. A range
/// without width is widened.
ColourScale scale_for(ColourMap map, const std::string& title,
                      std::span<const Eigen::VectorXd* const> fields, double neutral = 0,
                      double reach = 0);

}  // namespace vasorod
