#include "report/annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "data/sentence.h"
#include "report/lettering.h"

namespace vasorod {

namespace {

constexpr Colour ink{0.48F, 0.48F, 0.50F};  // readable on white and on black

double letter_size(const Picture& picture) {
  return picture.height / 26.0;
}

double line_width(const Picture& picture) {
  return std::max(1.0, picture.height / 450.0);
}

std::string readable(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

PixelBox grown(const PixelBox& box, int by) {
  return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

// The empty box nearest to a place; without one, the box at the place itself.
PixelBox room_near(const FreeRoom& room, int width, int height, const Vec2& place, int keep_off) {
  if (const auto box = room.nearest(width, height, place, keep_off)) return *box;
  const int left = static_cast<int>(place.x()) - width / 2,
            top = static_cast<int>(place.y()) - height / 2;
  return {left, top, left + width, top + height};
}

struct Named {
  std::size_t body = 0;
  std::vector<Vec2> places;  // visible, away from the outline
};

// Visible places of every named body, on a coarse grid.
std::vector<Named> named_places(const Picture& picture, const std::vector<int>& bodies,
                                const std::vector<std::string>& names) {
  const int step = std::max(2, picture.height / 70), off = std::max(1, picture.height / 90);
  const auto body_at = [&](int column, int row) {
    return bodies[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                  static_cast<std::size_t>(column)];
  };
  std::vector<Named> found;
  for (std::size_t body = 0; body < names.size(); ++body)
    if (!names[body].empty()) found.push_back({body, {}});
  for (int row = off; row + off < picture.height; row += step)
    for (int column = off; column + off < picture.width; column += step) {
      const int body = body_at(column, row);
      if (body < 0 || body_at(column - off, row) != body || body_at(column + off, row) != body ||
          body_at(column, row - off) != body || body_at(column, row + off) != body)
        continue;
      for (Named& one : found)
        if (one.body == static_cast<std::size_t>(body)) one.places.emplace_back(column, row);
    }
  // The smallest has the fewest places to be named at.
  std::sort(found.begin(), found.end(),
            [](const Named& a, const Named& b) { return a.places.size() < b.places.size(); });
  return found;
}

struct Leader {
  PixelBox box;
  Vec2 from, to;
};

// The label's place with the shortest way to its body that crosses no other label.
std::optional<Leader> leader_of(const Named& named, const FreeRoom& room, const Picture& picture,
                                int width, int height) {
  const int step = std::max(4, picture.height / 45), edge = picture.height / 60;
  Vec2 low = named.places[0], high = low;
  for (const Vec2& place : named.places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const auto gap = [](double a, double b, double c, double d) {  // of [a, b] and [c, d]
    return std::max({0.0, c - b, a - d});
  };
  std::optional<Leader> best;
  double least = std::numeric_limits<double>::infinity();
  for (int top = edge; top + height <= picture.height - edge; top += step)
    for (int left = edge; left + width <= picture.width - edge; left += step) {
      const PixelBox box{left, top, left + width, top + height};
      const Vec2 apart(gap(box.left, box.right, low.x(), high.x()),
                       gap(box.top, box.bottom, low.y(), high.y()));
      if (apart.squaredNorm() >= least || room.used(grown(box, edge / 3)) > 0) continue;
      for (const Vec2& to : named.places) {
        const Vec2 from(std::clamp(to.x(), double(box.left), double(box.right)),
                        std::clamp(to.y(), double(box.top), double(box.bottom)));
        const double away = (to - from).squaredNorm();
        if (away >= least || room.meets_taken(from, to)) continue;
        least = away;
        best = Leader{box, from, to};
      }
    }
  return best;
}

}  // namespace

double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most * (1 + 1e-9)) return factor * power;
  return power;
}

void draw_labels(Picture& picture, FreeRoom& room, const std::vector<int>& bodies,
                 const std::vector<std::string>& names) {
  const double size = letter_size(picture);
  for (const Named& named : named_places(picture, bodies, names)) {
    constexpr std::size_t hardly_visible = 3;
    if (named.places.size() < hardly_visible) continue;
    const std::string text = readable(names[named.body]);
    const int width = static_cast<int>(std::ceil(text_width(text, size))),
              height = static_cast<int>(std::ceil(1.1 * size));
    const auto leader = leader_of(named, room, picture, width, height);
    if (!leader) continue;
    draw_line(picture, leader->from, leader->to, line_width(picture), ink);
    draw_text(picture, leader->box.left, leader->box.bottom - 0.28 * size, text, size, ink);
    room.take(grown(leader->box, static_cast<int>(0.3 * size)));
  }
}

void draw_scale_bar(Picture& picture, FreeRoom& room, const Camera& camera,
                    const std::string& length_unit) {
  const double size = letter_size(picture);
  const double per_unit = 0.5 * picture.height / camera.half_height;
  const double length = round_length(0.2 * picture.width / per_unit);
  const std::string text = number_text(length, 3) + " " + length_unit;
  const double bar = length * per_unit, wide = std::max(bar, text_width(text, size));
  const int edge = static_cast<int>(0.6 * size);
  const PixelBox box = room_near(room, static_cast<int>(wide) + 2, static_cast<int>(1.9 * size),
                                 Vec2(0, picture.height), edge);
  const double left = box.left + 1, line = box.bottom - 0.3 * size;
  const double thick = 2 * line_width(picture);
  draw_line(picture, {left, line}, {left + bar, line}, thick, ink);
  for (const double x : {left, left + bar})
    draw_line(picture, {x, line - 0.25 * size}, {x, line + 0.25 * size}, thick, ink);
  draw_text(picture, left + 0.5 * (bar - text_width(text, size)), line - 0.6 * size, text, size,
            ink);
  room.take(grown(box, static_cast<int>(0.4 * size)));
}

void draw_orientation(Picture& picture, FreeRoom& room, const Camera& camera,
                      const std::string& space) {
  if (space != "LPS" && space != "RAS") return;
  const double size = letter_size(picture), arm = 1.5 * size;
  const int side = static_cast<int>(2 * (arm + 1.1 * size));
  const PixelBox box =
      room_near(room, side, side, Vec2(0, picture.height), static_cast<int>(0.3 * size));
  const Vec2 middle(0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom));
  // The letters at the positive and the negative end of the space's axes.
  constexpr std::array<std::array<const char*, 2>, 3> lps{{{"L", "R"}, {"P", "A"}, {"S", "I"}}};
  constexpr double seen = 0.35;  // of the axis; the rest points along the line of sight
  std::vector<std::pair<Vec2, std::string>> ways;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {1.0, -1.0}) {
      const bool other = (sign < 0) != (space == "RAS" && k < 2);
      ways.emplace_back(Vec2(sign * camera.axes(0, k), -sign * camera.axes(1, k)),
                        lps[static_cast<std::size_t>(k)][other ? 1 : 0]);
    }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const auto& a, const auto& b) { return a.first.norm() > b.first.norm(); });
  std::vector<Vec2> places;
  for (const auto& [way, letter] : ways) {
    if (way.norm() < seen) break;
    const Vec2 at = middle + (arm * way.norm() + 0.6 * size) * way.normalized();
    // A shorter axis whose letter would lie on another one has none.
    if (std::any_of(places.begin(), places.end(),
                    [&](const Vec2& place) { return (place - at).norm() < size; }))
      continue;
    places.push_back(at);
    draw_line(picture, middle, middle + arm * way, line_width(picture), ink);
    draw_text(picture, at.x() - 0.5 * text_width(letter, size), at.y() + 0.36 * size, letter, size,
              ink);
  }
  room.take(box);
}

std::optional<Patch> small_patch(const std::vector<PatchSource>& sources, const ColourScale& scale,
                                 double at_rest, const Camera& camera) {
  const double enough = 0.02 * (scale.high - scale.low);
  const double far = 0.12 * camera.half_height, large = 0.2 * camera.half_height;
  double most = enough;
  Vec3 peak = Vec3::Zero();
  for (const PatchSource& source : sources)
    for (Eigen::Index i = 0; i < source.values->size(); ++i)
      if (const double value = std::abs((*source.values)[i] - at_rest); value > most) {
        most = value;
        peak = source.points->row(i);
      }
  if (!(most > enough)) return std::nullopt;
  Vec3 low = peak, high = peak;
  for (const PatchSource& source : sources)
    for (Eigen::Index i = 0; i < source.values->size(); ++i) {
      const Vec3 at = source.points->row(i);
      if (!(std::abs((*source.values)[i] - at_rest) > enough)) continue;
      if ((at - peak).norm() > 2 * large) continue;  // another patch
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  const double radius = 0.5 * (high - low).norm();
  if (radius > large) return std::nullopt;
  return Patch{0.5 * (low + high), std::max(radius, 0.5 * far)};
}

Camera close_up(const Patch& patch, const Camera& camera) {
  Camera near = camera;
  near.centre = patch.centre;
  near.half_height = 1.4 * patch.radius;
  near.shift = 0;
  return near;
}

void draw_inset(Picture& picture, FreeRoom& room, const Picture& inset, const Patch& patch,
                const Camera& camera) {
  const int edge = static_cast<int>(0.5 * letter_size(picture));
  PixelBox best{};
  long least = std::numeric_limits<long>::max();
  for (int top = edge; top + inset.height <= picture.height - edge; top += edge)
    for (int left = edge; left + inset.width <= picture.width - edge; left += edge) {
      const PixelBox box{left, top, left + inset.width, top + inset.height};
      if (const long used = room.used(grown(box, 2)); used < least) {
        least = used;
        best = box;
      }
    }
  if (least == std::numeric_limits<long>::max()) return;
  for (int row = 0; row < inset.height; ++row)
    std::copy_n(
        &inset.rgba[4 * static_cast<std::size_t>(row) * static_cast<std::size_t>(inset.width)],
        4 * static_cast<std::size_t>(inset.width),
        &picture.rgba[4 * (static_cast<std::size_t>(best.top + row) *
                               static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(best.left))]);
  const auto frame = [&](const Vec2& low, const Vec2& high) {
    const std::array<Vec2, 5> corners{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y()),
                                      low};
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
      draw_line(picture, corners[k], corners[k + 1], 1.5 * line_width(picture), ink);
  };
  const Vec2 low(best.left, best.top), high(best.right, best.bottom);
  frame(low, high);
  const Vec2 at = pixel_of(camera, patch.centre, picture.width, picture.height);
  const double half =
      0.5 * picture.height * close_up(patch, camera).half_height / camera.half_height;
  const Vec2 corner(half, half);
  frame(at - corner, at + corner);
  const Vec2 nearest = at.cwiseMax(low).cwiseMin(high), way = nearest - at;
  const double out = half / std::max(way.cwiseAbs().maxCoeff(), 1e-9);
  if (out < 1) draw_line(picture, at + out * way, nearest, line_width(picture), ink);
  room.take(grown(best, edge));
}

}  // namespace vasorod
