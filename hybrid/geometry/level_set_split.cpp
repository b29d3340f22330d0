#include "geometry/level_set_split.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vasorod {
namespace {

class LevelSetSplit {
 public:
  LevelSetSplit(SurfaceEditor& editor, const std::vector<double>& f) : editor_(editor), f_(f) {
    // A vertex exactly on the level counts as above it, as in plane_sections.
    for (double& value : f_)
      if (value == 0) value = std::numeric_limits<double>::min();
  }

  void snap(const std::vector<std::array<int, 2>>& edges) {
    struct Candidate {
      double distance;
      int vertex, other;
    };
    std::vector<Candidate> candidates;
    for (const auto& [a, b] : edges)
      for (const auto& [v, w] : {std::pair{a, b}, std::pair{b, a}})
        candidates.push_back({crossing(v, w) * editor_.length(v, w), v, w});
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& l, const Candidate& r) {
      return l.distance != r.distance ? l.distance < r.distance
                                      : std::pair(l.vertex, l.other) < std::pair(r.vertex, r.other);
    });
    for (const auto& [distance, v, w] : candidates) {
      if (value(v) * value(w) >= 0 || crossing(v, w) * editor_.length(v, w) > editor_.snap())
        continue;
      if (editor_.on_boundary(v) || !stays_simple(v)) continue;
      const double t = crossing(v, w);
      if (editor_.move(v, {{v, 1 - t}, {w, t}})) put_on_curve(v);
    }
  }

  void split(const std::vector<std::array<int, 2>>& edges) {
    for (const auto& [a, b] : edges) {
      if (value(a) * value(b) >= 0) continue;
      const int m = editor_.split_edge(a, b, crossing(a, b));
      f_.push_back(0);
      on_curve_.insert(m);
    }
  }

  // Merges edges that are still too short: a vertex of the curve with the next one, or with an old
  // vertex beside the curve.
  void merge_short_edges() {
    bool changed = true;
    for (int round = 0; changed && round < 4; ++round) {
      changed = false;
      const std::vector<int> curve(on_curve_.begin(), on_curve_.end());
      for (const int v : curve) {
        if (editor_.triangles_of(v).empty()) continue;
        for (const int w : editor_.ring(v))
          if (editor_.length(v, w) < shortest_wanted(w) && merge(v, w)) {
            changed = true;
            break;
          }
      }
    }
  }

  std::vector<int> cycle() const {
    std::map<int, int> next;
    for (const int v : on_curve_)
      for (const int t : editor_.triangles_of(v)) {
        if (side(t) <= 0) continue;
        const auto& c = editor_.triangle(t);
        for (size_t k = 0; k < 3; ++k) {
          const int from = c[k], to = c[(k + 1) % 3];
          if (from != v || !on_curve_.contains(to)) continue;
          const int across = editor_.triangle_left_of(to, from);
          if (across < 0 || side(across) >= 0) continue;
          if (!next.emplace(from, to).second) return {};
        }
      }
    if (next.empty()) return {};
    std::vector<int> loop;
    const int start = next.begin()->first;
    for (int at = start;;) {
      loop.push_back(at);
      const auto found = next.find(at);
      if (found == next.end() || loop.size() > next.size()) return {};
      at = found->second;
      if (at == start) break;
    }
    return loop.size() == next.size() && loop.size() >= 3 ? loop : std::vector<int>{};
  }

  bool fixed(int a, int b) const { return on_curve_.contains(a) && on_curve_.contains(b); }

 private:
  double value(int v) const { return f_[static_cast<size_t>(v)]; }
  double crossing(int a, int b) const { return value(a) / (value(a) - value(b)); }

  void put_on_curve(int v) {
    f_[static_cast<size_t>(v)] = 0;
    on_curve_.insert(v);
  }

  // +1, -1, or 0 for a triangle with all corners on the curve.
  int side(int t) const {
    for (const int v : editor_.triangle(t))
      if (value(v) != 0) return value(v) > 0 ? 1 : -1;
    return 0;
  }

  // Whether the curve would stay simple, without a triangle in it, if v were on the curve. The
  // neighbours around v must then form one positive and one negative run, with at most single zeros
  // between them.
  bool stays_simple(int v) const {
    return simple_round(editor_.ring(v), -1) && neighbours_stay_simple(v);
  }

  bool simple_round(const std::vector<int>& ring, int as_zero) const {
    int changes = 0, previous = 0;
    const size_t n = ring.size();
    auto sign = [&](size_t k) {
      const int v = ring[k % n];
      return v == as_zero || value(v) == 0 ? 0 : (value(v) > 0 ? 1 : -1);
    };
    for (size_t k = 0; k < n; ++k)
      if (sign(k) != 0) previous = sign(k);
    for (size_t k = 0; k < n; ++k) {
      const int s = sign(k);
      if (s == 0 && sign(k + 1) == 0) return false;         // a triangle in the curve
      if (s == 0 && previous == sign(k + 1)) return false;  // the curve touches itself
      if (s == 0) continue;
      if (s != previous) ++changes;
      previous = s;
    }
    return changes == 2;
  }

  bool neighbours_stay_simple(int v) const {
    const auto& ring = editor_.ring(v);
    return std::none_of(ring.begin(), ring.end(), [&](int w) {
      return on_curve_.contains(w) && !simple_round(editor_.ring(w), v);
    });
  }

  // Short edges on the curve are worse than elsewhere: the seam copies them to the other vessel.
  double shortest_wanted(int w) const {
    return std::max(editor_.min_edge(), (on_curve_.contains(w) ? 1.2 : 0.6) * editor_.snap());
  }

  bool merge(int v, int w) {
    if (on_curve_.contains(w)) {
      // Along the curve only. The input's vertex stays.
      const int keep = std::min(v, w), gone = std::max(v, w);
      const int left = editor_.triangle_left_of(v, w), right = editor_.triangle_left_of(w, v);
      if (left < 0 || right < 0 || side(left) * side(right) >= 0) return false;
      if (!editor_.collapse(keep, gone, {{keep, 1.0}}) &&
          !editor_.collapse(keep, gone, {{gone, 1.0}}))
        return false;
      on_curve_.erase(gone);
      return true;
    }
    if (editor_.on_boundary(w)) return false;
    for (const int t :
         editor_.triangles_of(w)) {  // no triangle may end with all corners on the curve
      int zeros = 0;
      bool has_v = false;
      for (const int c : editor_.triangle(t)) {
        zeros += on_curve_.contains(c) ? 1 : 0;
        has_v = has_v || c == v;
      }
      if (!has_v && zeros >= 2) return false;
    }
    for (const int c : editor_.ring(w))
      if (c != v && on_curve_.contains(c) && !editor_.joined(c, v))
        return false;  // would touch the curve elsewhere
    if (v >= editor_.input_count() && w < editor_.input_count()) {
      if (!editor_.collapse(w, v, {{v, 1.0}})) return false;
      on_curve_.erase(v);
      put_on_curve(w);
      return true;
    }
    return editor_.collapse(v, w, {{v, 1.0}});
  }

  SurfaceEditor& editor_;
  std::vector<double> f_;
  std::set<int> on_curve_;
};

}  // namespace

std::vector<int> split_level_set(SurfaceEditor& editor, const std::vector<double>& f,
                                 const std::vector<std::array<int, 2>>& edges) {
  LevelSetSplit split(editor, f);
  split.snap(edges);
  split.split(edges);
  split.merge_short_edges();
  auto loop = split.cycle();
  if (!loop.empty()) editor.improve([&](int a, int b) { return split.fixed(a, b); });
  return loop;
}

std::vector<std::vector<int>> parts_beside(const SurfaceEditor& editor,
                                           const std::vector<int>& cycle) {
  std::set<std::pair<int, int>> walls;
  for (size_t k = 0; k < cycle.size(); ++k) {
    const int a = cycle[k], b = cycle[(k + 1) % cycle.size()];
    walls.insert({a, b});
    walls.insert({b, a});
  }
  std::vector<char> seen(static_cast<size_t>(editor.triangle_count()), 0);
  std::vector<std::vector<int>> parts;
  for (int seed = 0; seed < editor.triangle_count(); ++seed) {
    if (!editor.alive(seed) || seen[static_cast<size_t>(seed)]) continue;
    std::vector<int> part{seed};
    seen[static_cast<size_t>(seed)] = 1;
    for (size_t i = 0; i < part.size(); ++i) {
      const auto corners = editor.triangle(part[i]);
      for (size_t k = 0; k < 3; ++k) {
        const int a = corners[k], b = corners[(k + 1) % 3];
        if (walls.contains({a, b})) continue;
        const int across = editor.triangle_left_of(b, a);
        if (across < 0 || seen[static_cast<size_t>(across)]) continue;
        seen[static_cast<size_t>(across)] = 1;
        part.push_back(across);
      }
    }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace vasorod
