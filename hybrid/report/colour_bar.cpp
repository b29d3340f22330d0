// The legend of a picture.
#include <algorithm>
#include <sstream>

#include "report/lettering.h"
#include "report/picture.h"

namespace vasorod {

namespace {

// Breaks text into lines of whole words, at most `width` wide unless a single word is wider.
std::vector<std::string> wrapped(const std::string& text, double width, double size) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && text_width(longer, size) > width)
      lines.push_back(word);
    else
      line = longer;
  }
  return lines;
}

}  // namespace

void draw_colour_bar(Picture& picture, const ColourScale& scale, const std::string& found) {
  constexpr Colour ink{0.48F, 0.48F, 0.50F};  // readable on white and on black
  const double size = picture.height / 22.0;
  const int top = static_cast<int>(0.2 * picture.height),
            bottom = static_cast<int>(0.86 * picture.height);
  const std::vector<double> ticks = scale.ticks();
  double widest = 0;
  for (const double tick : ticks) widest = std::max(widest, text_width(scale.text_at(tick), size));
  const int bar = static_cast<int>(size),
            right = static_cast<int>(picture.width - 0.8 * size - widest - 0.5 * size);
  const int left = right - bar;
  const auto row_of = [&](double value) {
    return bottom - (value - scale.low) / (scale.high - scale.low) * (bottom - top);
  };
  for (int row = top; row < bottom; ++row)
    draw_box(picture, left, row, right, row + 1,
             scale(scale.low + (bottom - row - 0.5) / (bottom - top) * (scale.high - scale.low)));
  for (const double tick : ticks) {
    const double row = row_of(tick);
    draw_box(picture, right, static_cast<int>(row - 0.5), right + static_cast<int>(0.3 * size),
             static_cast<int>(row - 0.5) + 1, ink);
    draw_text(picture, right + 0.5 * size, row + 0.36 * size, scale.text_at(tick), size, ink);
  }
  const std::vector<std::string> lines = wrapped(scale.title, 0.26 * picture.width, size);
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text(picture, picture.width - 0.8 * size - text_width(lines[k], size),
              top - (0.9 + 1.2 * static_cast<double>(lines.size() - 1 - k)) * size, lines[k], size,
              ink);
  constexpr double smaller = 0.8;  // letters
  const std::vector<std::string> notes = wrapped(found, 0.26 * picture.width, smaller * size);
  for (std::size_t k = 0; k < notes.size() && !found.empty(); ++k)
    draw_text(picture, picture.width - 0.8 * size - text_width(notes[k], smaller * size),
              bottom + 1.5 * size + 1.2 * static_cast<double>(k) * smaller * size, notes[k],
              smaller * size, ink);
}

}  // namespace vasorod
