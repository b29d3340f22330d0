// Where a picture has room for what is written into it.
#pragma once

#include <optional>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

struct Picture;

/// A rectangle of pixels, [left, right) x [top, bottom).
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// The pixels that are still empty: those of the picture, less the boxes that were taken.
class FreeRoom {
 public:
  explicit FreeRoom(const Picture& picture);

  /// A box keeps its pixels for what is drawn there.
  void take(const PixelBox& box);

  /// How many pixels of the box are drawn or taken; those outside the picture count as taken, those
  /// both drawn and taken twice.
  long used(const PixelBox& box) const;

  /// Whether a straight line between two places meets a taken box.
  bool meets_taken(const Vec2& from, const Vec2& to) const;

  /// The empty box of this size whose middle is nearest to a place, on a grid of a few pixels; none
  /// where no empty one is left. `keep_off`: pixels to the edge of the picture.
  std::optional<PixelBox> nearest(int width, int height, const Vec2& place, int keep_off) const;

 private:
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ + 1) +
           static_cast<std::size_t>(column);
  }
  int width_, height_;
  std::vector<PixelBox> taken_;
  std::vector<int> sums_;  // of drawn pixels in the rectangle from the top left to here
};

}  // namespace vasorod
