#include "report/lettering.h"

#include <algorithm>
#include <cmath>

#include "report/glyphs.h"

namespace vasorod {

namespace {

constexpr double units = 64;  // per em
constexpr int space_advance = 20;

// The glyph of a character, or that of ? where there is none.
const Glyph& glyph_of(char32_t character) {
  const auto find = [](char32_t wanted) {
    return std::find_if(glyphs.begin(), glyphs.end(),
                        [&](const Glyph& glyph) { return glyph.character == wanted; });
  };
  const auto* const found = find(character);
  return found == glyphs.end() ? *find(U'?') : *found;
}

// Characters of UTF-8 text; a byte that is not UTF-8 becomes ?.
std::u32string characters(const std::string& text) {
  std::u32string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t length = byte < 0x80       ? 1
                               : byte >> 5 == 6  ? 2
                               : byte >> 4 == 14 ? 3
                               : byte >> 3 == 30 ? 4
                                                 : 0;
    char32_t value = length == 1 ? byte : length > 1 ? byte & (0xFFU >> (length + 1)) : U'?';
    for (std::size_t k = 1; k < length; ++k)
      value = i + k < text.size() ? value << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3FU)
                                  : U'?';
    result += value;
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

using Contour = std::vector<Vec2>;

std::vector<Contour> contours_of(const Glyph& glyph, double x, double y, double size) {
  std::vector<Contour> contours(1);
  for (const char* at = glyph.contours; *at; ++at) {
    if (*at == ' ') {
      contours.emplace_back();
      continue;
    }
    const int across = at[0] - '#' - 4, up = at[1] - '#' - 18;
    contours.back().emplace_back(x + across * size / units, y - up * size / units);
    ++at;
  }
  return contours;
}

void blend(Picture& picture, int column, int row, const Colour& colour, double cover) {
  if (column < 0 || row < 0 || column >= picture.width || row >= picture.height || cover <= 0)
    return;
  std::uint8_t* pixel =
      &picture.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(column))];
  const double under = pixel[3] / 255.0 * (1 - cover), alpha = cover + under;
  for (std::size_t k = 0; k < 3; ++k)
    pixel[k] = static_cast<std::uint8_t>(
        std::lround((255 * colour[k] * cover + pixel[k] * under) / alpha));
  pixel[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
}

// Fills by the even-odd rule. A pixel's coverage is exact horizontally and sampled on four lines
// vertically.
void fill(Picture& picture, const std::vector<Contour>& contours, const Colour& colour) {
  constexpr int lines = 4;
  Vec2 low = contours[0][0], high = low;
  for (const Contour& contour : contours)
    for (const Vec2& point : contour) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  const int left = static_cast<int>(std::floor(low.x()));
  std::vector<double> cover;
  std::vector<double> crossings;
  for (int row = static_cast<int>(std::floor(low.y())); row <= high.y(); ++row) {
    cover.assign(static_cast<std::size_t>(std::floor(high.x()) - left + 1), 0);
    for (int line = 0; line < lines; ++line) {
      const double y = row + (line + 0.5) / lines;
      crossings.clear();
      for (const Contour& contour : contours)
        for (std::size_t i = 0; i < contour.size(); ++i) {
          const Vec2 &a = contour[i], &b = contour[(i + 1) % contour.size()];
          if ((a.y() <= y) != (b.y() <= y))
            crossings.push_back(a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()));
        }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        for (std::size_t column = 0; column < cover.size(); ++column) {
          const double pixel = left + static_cast<double>(column);
          cover[column] +=
              std::max(0.0, std::min(crossings[k + 1], pixel + 1) - std::max(crossings[k], pixel)) /
              lines;
        }
    }
    for (std::size_t column = 0; column < cover.size(); ++column)
      blend(picture, left + static_cast<int>(column), row, colour, std::min(1.0, cover[column]));
  }
}

}  // namespace

double text_width(const std::string& text, double size) {
  int advance = 0;
  for (const char32_t character : characters(text)) {
    advance += character == U' ' ? space_advance : glyph_of(character).advance;
  }
  return advance * size / units;
}

void draw_text(Picture& picture, double x, double y, const std::string& text, double size,
               const Colour& colour) {
  for (const char32_t character : characters(text)) {
    if (character == U' ') {
      x += space_advance * size / units;
      continue;
    }
    const Glyph& glyph = glyph_of(character);
    fill(picture, contours_of(glyph, x, y, size), colour);
    x += glyph.advance * size / units;
  }
}

void draw_line(Picture& picture, const Vec2& from, const Vec2& to, double width,
               const Colour& colour) {
  const Vec2 way = to - from;
  if (!(way.norm() > 0)) return;
  const Vec2 along = 0.5 * width * way.normalized(), across(-along.y(), along.x());
  const Vec2 begin = from - along, end = to + along;
  fill(picture, {{begin - across, end - across, end + across, begin + across}}, colour);
}

void draw_box(Picture& picture, int left, int top, int right, int bottom, const Colour& colour) {
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column) blend(picture, column, row, colour, 1);
}

}  // namespace vasorod
