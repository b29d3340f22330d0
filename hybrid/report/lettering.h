// Text in a picture.
#pragma once

#include <string>

#include "report/picture.h"

namespace vasorod {

/// Width in pixels of UTF-8 text whose em is `size` pixels.
double text_width(const std::string& text, double size);

/// Draws UTF-8 text with its base line starting at (x, y), pixels from the top left. ASCII and − ·
/// ² ° ≤ ≥ are known; other characters are drawn as ?.
void draw_text(Picture& picture, double x, double y, const std::string& text, double size,
               const Colour& colour);

/// A straight line, `width` pixels wide, from one place to another; pixels from the top left.
void draw_line(Picture& picture, const Vec2& from, const Vec2& to, double width,
               const Colour& colour);

/// Covers the box [left, right) x [top, bottom) with a colour.
void draw_box(Picture& picture, int left, int top, int right, int bottom, const Colour& colour);

}  // namespace vasorod
