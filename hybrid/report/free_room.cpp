#include "report/free_room.h"

#include <algorithm>
#include <limits>

#include "report/picture.h"

namespace vasorod {

FreeRoom::FreeRoom(const Picture& picture) : width_(picture.width), height_(picture.height) {
  sums_.assign(at(0, height_ + 1), 0);
  const std::uint8_t* alpha = picture.rgba.data() + 3;
  for (int row = 0; row < height_; ++row) {
    int line = 0;
    for (int column = 0; column < width_; ++column, alpha += 4) {
      line += *alpha > 0;
      sums_[at(column + 1, row + 1)] = sums_[at(column + 1, row)] + line;
    }
  }
}

void FreeRoom::take(const PixelBox& box) {
  taken_.push_back(box);
}

long FreeRoom::used(const PixelBox& box) const {
  const int left = std::clamp(box.left, 0, width_), right = std::clamp(box.right, 0, width_),
            top = std::clamp(box.top, 0, height_), bottom = std::clamp(box.bottom, 0, height_);
  const long whole = long{box.right - box.left} * (box.bottom - box.top),
             inside = long{right - left} * (bottom - top);
  long drawn = whole - inside;
  for (const PixelBox& other : taken_) {
    const int wide = std::min(box.right, other.right) - std::max(box.left, other.left),
              high = std::min(box.bottom, other.bottom) - std::max(box.top, other.top);
    if (wide > 0 && high > 0) drawn += long{wide} * high;
  }
  return drawn + sums_[at(right, bottom)] - sums_[at(left, bottom)] - sums_[at(right, top)] +
         sums_[at(left, top)];
}

bool FreeRoom::meets_taken(const Vec2& from, const Vec2& to) const {
  const int steps = 1 + static_cast<int>((to - from).norm());
  for (int k = 0; k <= steps; ++k) {
    const Vec2 at = from + (to - from) * k / steps;
    for (const PixelBox& box : taken_)
      if (at.x() >= box.left && at.x() < box.right && at.y() >= box.top && at.y() < box.bottom)
        return true;
  }
  return false;
}

std::optional<PixelBox> FreeRoom::nearest(int width, int height, const Vec2& place,
                                          int keep_off) const {
  const int step = std::max(1, height_ / 135);
  std::optional<PixelBox> best;
  double least = std::numeric_limits<double>::infinity();
  for (int top = keep_off; top + height <= height_ - keep_off; top += step)
    for (int left = keep_off; left + width <= width_ - keep_off; left += step) {
      const PixelBox box{left, top, left + width, top + height};
      const double away = (Vec2(left + 0.5 * width, top + 0.5 * height) - place).squaredNorm();
      if (away >= least || used(box) > 0) continue;
      least = away;
      best = box;
    }
  return best;
}

}  // namespace vasorod
