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

/// Blue to red through grey, for what has a neutral value; pale yellow to black violet, for what
/// starts at zero.
enum class ColourMap { diverging, sequential };

struct ColourScale {
  ColourMap map = ColourMap::sequential;
  double low = 0, high = 1;
  std::string title;  ///< with the unit

  /// Values outside [low, high] have the colour of the nearer end; what is not a number is grey.
  Colour operator()(double value) const;
  /// Round values inside [low, high], about five, and their text.
  std::vector<double> ticks() const;
};

/// The map's colours at equal steps, as 0xRRGGBB.
std::span<const std::uint32_t> colours_of(ColourMap map);

/// The value of a tick with no more digits than the ticks' step needs.
std::string tick_text(double value, double step);

/// A scale from the values' range: diverging scales are symmetric about `neutral`; a range of no
/// width is widened.
ColourScale scale_for(ColourMap map, const std::string& title,
                      std::span<const Eigen::VectorXd* const> fields, double neutral = 0);

}  // namespace vasorod
