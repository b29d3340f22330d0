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
  std::string title;  ///< with the unit

  /// Values outside [low, high] have the colour of the nearer end. Values that are not finite are
  /// grey.
  Colour operator()(double value) const;
  /// About five round values inside [low, high]; none in grey.
  std::vector<double> ticks() const;
};

/// The map's colours at equal steps, as 0xRRGGBB.
std::span<const std::uint32_t> colours_of(ColourMap map);

/// The value of a tick with no more digits than the ticks' step needs.
std::string tick_text(double value, double step);

/// A scale for the range of the values. Diverging scales are symmetric about `neutral`. A range
/// without width is widened.
ColourScale scale_for(ColourMap map, const std::string& title,
                      std::span<const Eigen::VectorXd* const> fields, double neutral = 0);

}  // namespace vasorod
