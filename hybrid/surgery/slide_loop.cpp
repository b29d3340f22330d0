#include "surgery/slide_loop.h"

#include <cmath>
#include <set>

#include "data/index.h"

namespace vasorod {
namespace {

// A vertex closer than this to its place, as a fraction of the loop's length, is there.
constexpr double there = 1e-13;
// A step that is refused is tried shorter, down to this share of the way.
constexpr double shortest_step = 0.2;
constexpr int most_sweeps = 30;

VertexSource source_at(const std::vector<int>& loop, const LoopCurve::Place& place) {
  const VertexSource a = VertexSource::original(loop[index(place.edge)]),
                     b = VertexSource::original(loop[index(place.edge + 1) % loop.size()]);
  return blend({&a, &b}, {1 - place.along, place.along});
}

}  // namespace

SlidLoop slide_loop(SurfaceEditor& editor, const std::vector<int>& loop, const LoopCurve& curve,
                    const std::vector<LoopTarget>& targets) {
  // No flip joins two vertices of the loop: such a triangle would close the opened loop.
  std::set<int> on_loop(loop.begin(), loop.end());
  const auto fixed = [&](int a, int b) { return on_loop.contains(a) && on_loop.contains(b); };

  // Where the sliding vertices are now and how far each has to go, in fractions of the length.
  std::vector<double> now(targets.size(), 0);
  for (size_t k = 0; k < targets.size(); ++k)
    if (targets[k].corner >= 0) now[k] = curve.position(targets[k].corner) / curve.length();
  const auto left = [&](size_t k) { return std::remainder(targets[k].fraction - now[k], 1.0); };
  const auto pending = [&](size_t k) {
    return targets[k].corner >= 0 && std::abs(left(k)) > there;
  };
  bool moving = true;
  for (int sweep = 0; moving && sweep < most_sweeps; ++sweep) {
    moving = false;
    for (size_t k = 0; k < targets.size(); ++k) {
      if (!pending(k)) continue;
      for (double step = 1; step >= shortest_step; step /= 2) {
        const double to = now[k] + step * left(k);
        const LoopCurve::Place place = curve.place(step == 1 ? targets[k].fraction : to);
        if (!editor.move(loop[index(targets[k].corner)], curve.at(place), source_at(loop, place)))
          continue;
        now[k] = step == 1 ? targets[k].fraction : to;
        moving = true;
        break;
      }
    }
    editor.improve(fixed);
  }
  SlidLoop result;
  for (size_t k = 0; k < targets.size(); ++k)
    if (pending(k)) result.refused.push_back(static_cast<int>(k));
  if (!result.refused.empty()) return result;

  const size_t n = targets.size();
  size_t first = 0;
  while (first < n && targets[first].corner < 0) ++first;
  result.vertices.assign(n, -1);
  for (size_t i = 0; i < n; ++i) {
    const size_t k = (first + i) % n;
    const LoopTarget& target = targets[k];
    if (target.corner >= 0) {
      result.vertices[k] = loop[index(target.corner)];
      continue;
    }
    size_t next = k;
    while (targets[next].corner < 0) next = (next + 1) % n;
    result.vertices[k] = editor.split_edge(result.vertices[(k + n - 1) % n],
                                           loop[index(targets[next].corner)], target.between);
  }
  on_loop.insert(result.vertices.begin(), result.vertices.end());
  editor.improve(fixed);
  return result;
}

}  // namespace vasorod
