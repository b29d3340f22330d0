#include "geometry/isoline_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace vasorod {
namespace {

class Walker {
 public:
  Walker(SurfaceEditor& editor, const IsolineRequest& request)
      : editor_(editor), request_(request) {}

  IsolinePath run() {
    const int start = place_start();
    level_ = value(request_.across, start);
    path_.insert(start);
    IsolinePath result;
    std::vector<int> forward{start}, backward{start};
    result.forward = walk(forward, +1);
    const IsolineEnd forward_end = end_;
    const Vec3 forward_stop = stopped_at_;
    end_ = IsolineEnd::reached;
    result.backward = walk(backward, -1);
    if (forward_end != IsolineEnd::reached) {
      end_ = forward_end;
      stopped_at_ = forward_stop;
    }
    result.fits = 2 * std::min(result.forward, result.backward);
    result.vertices.assign(backward.rbegin(), backward.rend());
    result.start = static_cast<int>(backward.size()) - 1;
    result.vertices.insert(result.vertices.end(), forward.begin() + 1, forward.end());
    if (end_ == IsolineEnd::reached) tidy(result.vertices);
    result.end = end_;
    result.stopped_at = stopped_at_;
    return result;
  }

 private:
  // Where the isoline leaves the triangles around a vertex: at vertex a (b < 0), or on the edge a-b
  // at t.
  struct Exit {
    int a = -1, b = -1;
    double t = 0;
    Vec3 point = Vec3::Zero();
  };
  using Blend = SurfaceEditor::Blend;

  double value(const Eigen::VectorXd& field, int v) const {
    const VertexSource& source = editor_.source(v);
    double sum = 0;
    for (size_t k = 0; k < source.vertex.size(); ++k)
      sum += source.weight[k] * field[source.vertex[k]];
    return sum;
  }

  // Signed height over the isoline; zero for vertices of the path, by construction.
  double height(int v) const { return path_.contains(v) ? 0 : value(request_.across, v) - level_; }

  bool near_forbidden(int v) const { return !request_.allowed(editor_.source(v).dominant()); }

  static Blend blend_of(const Exit& exit) {
    if (exit.b < 0) return {{exit.a, 1.0}};
    return {{exit.a, 1 - exit.t}, {exit.b, exit.t}};
  }

  // Makes the start a vertex. In order of preference: move the nearest corner there; split an edge
  // and move the new vertex there; insert a new vertex.
  int place_start() {
    const auto corners = editor_.triangle(request_.triangle);
    Blend target;
    for (size_t k = 0; k < 3; ++k)
      target.emplace_back(corners[k], request_.barycentric[static_cast<int>(k)]);
    const Vec3 at = editor_.point(target);
    std::array<size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) {
      return (editor_.point(corners[i]) - at).norm() < (editor_.point(corners[j]) - at).norm();
    });
    for (const size_t k : order) {
      const int v = corners[k];
      if ((editor_.point(v) - at).norm() > editor_.snap() || editor_.on_boundary(v)) continue;
      if (editor_.move(v, target)) return v;
    }
    for (size_t k = 0; k < 3; ++k) {  // near the edge opposite to corner k?
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const Vec3 edge = editor_.point(b) - editor_.point(a);
      const double t = (at - editor_.point(a)).dot(edge) / edge.squaredNorm();
      const double distance = (at - editor_.point(a) - t * edge).norm();
      if (distance > 0.7 * editor_.snap() || t <= 0 || t >= 1 || editor_.triangle_left_of(b, a) < 0)
        continue;
      const int m = editor_.split_edge(a, b, t);
      editor_.move(
          m,
          target);  // if that folds a triangle the start stays on the edge, a fifth of an edge away
      return m;
    }
    return editor_.split_triangle(request_.triangle, request_.barycentric);
  }

  // The exits of the isoline around v that are not on the path yet.
  std::vector<Exit> exits(int v) const {
    std::vector<Exit> found;
    const auto ring = editor_.ring(v);
    const double zero = 1e-9 * editor_.mean_edge();
    for (size_t k = 0; k < ring.size(); ++k) {
      const int a = ring[k], b = ring[(k + 1) % ring.size()];
      const double fa = height(a), fb = height(b);
      if (std::abs(fa) <= zero) {
        if (!path_.contains(a)) found.push_back({a, -1, 0, editor_.point(a)});
        continue;
      }
      if (std::abs(fb) <= zero || fa * fb > 0) continue;
      Exit exit{a, b, fa / (fa - fb), Vec3::Zero()};
      exit.point = editor_.point(blend_of(exit));
      found.push_back(exit);
    }
    return found;
  }

  // The exit to continue with: at the start, the one in whose direction `along` changes with the
  // requested sense; later, straight ahead.
  std::optional<Exit> lead_on(int v, int previous, int sense) const {
    std::optional<Exit> best;
    double best_score = 0;
    for (const Exit& exit : exits(v)) {
      double score = 0;
      if (previous >= 0) {
        const Vec3 ahead = (editor_.point(v) - editor_.point(previous)).normalized();
        score = ahead.dot((exit.point - editor_.point(v)).normalized());
      } else {
        double there = 0;
        for (const auto& [w, weight] : blend_of(exit)) there += weight * value(request_.along, w);
        score = sense * (there - value(request_.along, v));
      }
      if (score > best_score) {
        best = exit;
        best_score = score;
      }
    }
    return best;
  }

  // Makes the exit a vertex of the path.
  int embed(const Exit& exit) {
    int next = exit.a;
    if (exit.b >= 0) {
      next = -1;
      const double whole = editor_.length(exit.a, exit.b);
      std::array<std::pair<double, int>, 2> ends{std::pair{exit.t * whole, exit.a},
                                                 std::pair{(1 - exit.t) * whole, exit.b}};
      if (ends[1].first < ends[0].first) std::swap(ends[0], ends[1]);
      for (const auto& [distance, v] : ends) {
        if (next >= 0 || distance > editor_.snap() || path_.contains(v) || editor_.on_boundary(v))
          continue;
        if (editor_.move(v, blend_of(exit))) next = v;
      }
      if (next < 0) next = editor_.split_edge(exit.a, exit.b, exit.t);
    }
    path_.insert(next);
    return next;
  }

  bool stop(IsolineEnd why, int at) {
    end_ = why;
    stopped_at_ = editor_.point(at);
    return false;
  }

  bool may_pass(const Exit& exit, int from) {
    if (editor_.on_boundary(exit.a) && (exit.b < 0 || editor_.on_boundary(exit.b)))
      return stop(IsolineEnd::boundary, from);
    if (near_forbidden(exit.a) || (exit.b >= 0 && near_forbidden(exit.b)))
      return stop(IsolineEnd::forbidden, from);
    return true;
  }

  // Slides the path's last vertex, `next`, to the distance `wanted` from v: back towards v, or
  // forward along the isoline.
  bool slide(int v, int next, double wanted, int sense) {
    const Vec3 from = editor_.point(v);
    const double now = editor_.length(v, next);
    if (std::abs(now - wanted) <= 1e-12 * editor_.mean_edge()) return true;
    if (wanted < now) return editor_.move(next, {{v, 1 - wanted / now}, {next, wanted / now}});
    const auto ahead = lead_on(next, v, sense);
    if (!ahead) return false;
    // On next + r (exit - next), where the distance from v is `wanted`.
    const Vec3 base = editor_.point(next) - from, step = ahead->point - editor_.point(next);
    const double a = step.squaredNorm(), b = base.dot(step),
                 c = base.squaredNorm() - wanted * wanted;
    const double r = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
    if (!(r >= 0 && r < 0.8)) return false;
    Blend target{{next, 1 - r}};
    for (const auto& [w, weight] : blend_of(*ahead)) target.emplace_back(w, r * weight);
    return editor_.move(next, target);
  }

  // The tip inside the triangles around v, at the distance `wanted` from v towards the exit.
  int place_tip(int v, const Exit& exit, double wanted) {
    const double r = wanted / (exit.point - editor_.point(v)).norm();
    Blend target{{v, 1 - r}};
    for (const auto& [w, weight] : blend_of(exit)) target.emplace_back(w, r * weight);
    for (const int corner : {exit.a, exit.b}) {
      if (corner < 0 || path_.contains(corner) || editor_.on_boundary(corner)) continue;
      if ((editor_.point(target) - editor_.point(corner)).norm() < editor_.snap() &&
          editor_.move(corner, target))
        return corner;
    }
    if (exit.b < 0) return editor_.split_edge(v, exit.a, r);
    const int t = editor_.triangle_left_of(exit.a, exit.b);
    Vec3 barycentric;
    for (size_t k = 0; k < 3; ++k) {
      const int corner = editor_.triangle(t)[k];
      barycentric[static_cast<int>(k)] =
          corner == v ? 1 - r : (corner == exit.a ? r * (1 - exit.t) : r * exit.t);
    }
    return editor_.split_triangle(t, barycentric);
  }

  // Ends the walk in `next`, whose distance is about what is `left`, if the length can be exact.
  bool finish(std::vector<int>& path, int next, double left, int sense) {
    const int v = path.back();
    const double now = editor_.length(v, next);
    if (slide(v, next, left, sense)) {
      path.push_back(next);
      return true;
    }
    if (now - left < editor_.min_edge()) return false;
    path_.erase(next);
    path.push_back(editor_.split_edge(v, next, left / now));
    path_.insert(path.back());
    return true;
  }

  // A new vertex of the path is close to an old one off the path: the old vertex replaces it.
  int absorb(int v) {
    if (v < editor_.input_count()) return v;
    int nearest = -1;
    for (const int w : editor_.ring(v))
      if (w < editor_.input_count() && !path_.contains(w) && !editor_.on_boundary(w) &&
          editor_.length(v, w) < short_step() &&
          (nearest < 0 || editor_.length(v, w) < editor_.length(v, nearest)))
        nearest = w;
    if (nearest < 0 || !editor_.collapse(nearest, v, {{v, 1.0}})) return v;
    path_.erase(v);
    path_.insert(nearest);
    return nearest;
  }

  // Removes slivers beside the path by flips, and replaces new vertices by close old ones.
  void tidy(std::vector<int>& path) {
    const auto fixed = [&](int a, int b) { return path_.contains(a) && path_.contains(b); };
    for (int round = 0; round < 2; ++round) {
      editor_.improve(fixed);
      for (int& v : path) v = absorb(v);
    }
    editor_.improve(fixed);
  }

  double short_step() const { return 0.8 * editor_.snap(); }
  // Short edges on the path are worse than elsewhere: the seam copies them to the other vessel.
  double short_on_path() const { return 1.2 * editor_.snap(); }

  // A step across the narrow corner of a triangle would leave a short edge. Removes the one of its
  // two vertices that surgery made. True if removed; the walk then continues at the end of `path`.
  bool shorten(std::vector<int>& path, int next, double& done) {
    const int v = path.back();
    if (next >= editor_.input_count()) {
      if (!editor_.collapse(v, next, {{v, 1.0}})) return false;
      path_.erase(next);
      return true;
    }
    if (path.size() < 2 || v < editor_.input_count()) return false;
    const int previous = path[path.size() - 2];
    const double last = editor_.length(previous, v);
    if (!editor_.collapse(next, v, {{next, 1.0}})) return false;
    path_.erase(v);
    path.back() = next;
    done += editor_.length(previous, next) - last;
    return true;
  }

  double walk(std::vector<int>& path, int sense) {
    double done = 0;
    const double total = request_.length / 2, margin = editor_.snap();
    // A path crosses each triangle once. The bound guards against invalid input functions.
    for (int guard = 2 * editor_.triangle_count(); guard > 0; --guard) {
      const int v = path.back(), previous = path.size() > 1 ? path[path.size() - 2] : -1;
      if (editor_.on_boundary(v)) {
        stop(IsolineEnd::boundary, v);
        return done;
      }
      const auto exit = lead_on(v, previous, sense);
      if (!exit) {
        stop(IsolineEnd::lost, v);
        return done;
      }
      const double step = (exit->point - editor_.point(v)).norm(), left = total - done;
      if (left < editor_.min_edge()) return done;
      if (step > left + margin) {
        const int tip = place_tip(v, *exit, left);
        path_.insert(tip);
        path.push_back(tip);
        return done + left;
      }
      if (!may_pass(*exit, v)) return done;
      const int next = embed(*exit);
      if (std::abs(step - left) <= margin && finish(path, next, left, sense)) return done + left;
      if (step >= left) {  // the tip cannot be moved back to its place
        path.push_back(next);
        return done + editor_.length(v, next);
      }
      if (editor_.length(v, next) < short_on_path() && shorten(path, next, done)) continue;
      path.push_back(next);
      done += editor_.length(v, next);
    }
    stop(IsolineEnd::lost, path.back());
    return done;
  }

  SurfaceEditor& editor_;
  const IsolineRequest& request_;
  double level_ = 0;
  std::set<int> path_;
  IsolineEnd end_ = IsolineEnd::reached;
  Vec3 stopped_at_ = Vec3::Zero();
};

}  // namespace

IsolinePath embed_isoline(SurfaceEditor& editor, const IsolineRequest& request) {
  return Walker(editor, request).run();
}

}  // namespace vasorod
