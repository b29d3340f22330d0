#include "geometry/plane_section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace vasorod {
namespace {

// Where the curve enters or leaves a triangle: the edge, as one number.
using EdgeKey = long long;

EdgeKey key_of(int i, int j) {
  return (static_cast<EdgeKey>(std::min(i, j)) << 32) | static_cast<EdgeKey>(std::max(i, j));
}

// A piece of the curve in one triangle.
struct Piece {
  int triangle;
  EdgeKey from, to;
};

Vec3 polygon_area_vector(const Points& p) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    const Vec3 a = p.row(i) - p.row(0), b = p.row((i + 1) % p.rows()) - p.row(0);
    sum += 0.5 * a.cross(b);
  }
  return sum;
}

double distance_to(const SectionLoop& loop, const Vec3& point) {
  double best = std::numeric_limits<double>::infinity();
  const Eigen::Index n = loop.points.rows();
  for (Eigen::Index i = 0; i < (loop.closed ? n : n - 1); ++i) {
    const Vec3 a = loop.points.row(i), b = loop.points.row((i + 1) % n);
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    best = std::min(best, (point - a - t * (b - a)).norm());
  }
  return best;
}

// The curves in those triangles that `each` calls its argument with, in the order of their indices.
template <class Each>
std::vector<SectionLoop> curves(const TriangleSurface& surface, const Vec3& point,
                                const Vec3& normal, Each&& each) {
  const auto height = [&](int v) {
    return (surface.points(v, 0) - point.x()) * normal.x() +
           (surface.points(v, 1) - point.y()) * normal.y() +
           (surface.points(v, 2) - point.z()) * normal.z();
  };
  std::vector<Piece> pieces;
  std::unordered_map<EdgeKey, size_t> starts, ends;  // edge -> the piece that starts or ends there
  each([&](int t) {
    std::array<bool, 3> above{};
    for (int k = 0; k < 3; ++k)
      above[static_cast<size_t>(k)] = height(surface.triangles(t, k)) >= 0;
    if (above[0] == above[1] && above[1] == above[2]) return;
    Piece piece{t, 0, 0};
    for (size_t k = 0; k < 3; ++k) {
      const size_t l = (k + 1) % 3;
      if (above[k] == above[l]) continue;
      const EdgeKey key = key_of(surface.triangles(t, static_cast<int>(k)),
                                 surface.triangles(t, static_cast<int>(l)));
      // The part above is on the left, seen from outside.
      (above[k] ? piece.from : piece.to) = key;
    }
    starts.emplace(piece.from, pieces.size());
    ends.emplace(piece.to, pieces.size());
    pieces.push_back(piece);
  });

  std::vector<char> done(pieces.size(), 0);
  std::vector<SectionLoop> loops;
  for (size_t seed = 0; seed < pieces.size(); ++seed) {
    if (done[seed]) continue;
    // Back to the beginning of an open curve, or once around a closed one.
    size_t first = seed;
    bool closed = false;
    for (auto before = ends.find(pieces[first].from); before != ends.end();
         before = ends.find(pieces[first].from)) {
      first = before->second;
      if (first == seed) {
        closed = true;
        break;
      }
    }
    SectionLoop loop;
    loop.closed = closed;
    std::vector<EdgeKey> keys{pieces[first].from};
    for (size_t at = first;;) {
      done[at] = 1;
      loop.triangles.push_back(pieces[at].triangle);
      const auto after = starts.find(pieces[at].to);
      if (closed && after->second == first) break;
      keys.push_back(pieces[at].to);
      if (after == starts.end()) break;
      at = after->second;
    }
    loop.points.resize(static_cast<Eigen::Index>(keys.size()), 3);
    for (size_t i = 0; i < keys.size(); ++i) {
      const int a = static_cast<int>(keys[i] >> 32), b = static_cast<int>(keys[i] & 0xffffffffLL);
      const double t = height(a) / (height(a) - height(b));
      loop.edges.push_back({a, b});
      loop.points.row(static_cast<Eigen::Index>(i)) =
          (1 - t) * surface.points.row(a) + t * surface.points.row(b);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

std::vector<SectionLoop> plane_sections(const TriangleSurface& surface, const Vec3& point,
                                        const Vec3& normal) {
  return curves(surface, point, normal, [&](const auto& see) {
    for (int t = 0; t < surface.triangles.rows(); ++t) see(t);
  });
}

PlaneSections::PlaneSections(const TriangleSurface& surface)
    : surface_(surface),
      boxes_(triangle_boxes(surface)),
      extent_(surface.points.rows() > 0 ? surface.points.cwiseAbs().maxCoeff() : 0) {}

std::vector<SectionLoop> PlaneSections::across(const Vec3& point, const Vec3& normal) const {
  // Boxes that the plane meets; more than rounding takes from it.
  const double slack = 1e-12 * (extent_ + point.cwiseAbs().maxCoeff());
  const Vec3 size = normal.cwiseAbs();
  std::vector<int> triangles;
  boxes_.visit(
      [&](const Box& box) {
        const double middle = (0.5 * (box.low + box.high) - point).dot(normal);
        return std::abs(middle) <= 0.5 * (box.high - box.low).dot(size) + slack;
      },
      [&](int t) { triangles.push_back(t); });
  std::sort(triangles.begin(), triangles.end());
  return curves(surface_, point, normal, [&](const auto& see) {
    for (const int t : triangles) see(t);
  });
}

int section_winding(const Points& polygon, const Vec3& center, const Vec3& normal) {
  double angle = 0;
  for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
    Vec3 a = polygon.row(i).transpose() - center,
         b = polygon.row((i + 1) % polygon.rows()).transpose() - center;
    a -= a.dot(normal) * normal;
    b -= b.dot(normal) * normal;
    angle += std::atan2(a.cross(b).dot(normal), a.dot(b));
  }
  return static_cast<int>(std::lround(angle / (2 * M_PI)));
}

int section_around(const std::vector<SectionLoop>& loops, const Vec3& point, const Vec3& normal) {
  int best = -1;
  double best_value = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < loops.size(); ++i) {
    if (!loops[i].closed || section_winding(loops[i].points, point, normal) == 0) continue;
    const double area = section_area(loops[i]);
    if (area < best_value) {
      best = static_cast<int>(i);
      best_value = area;
    }
  }
  if (best >= 0) return best;
  for (size_t i = 0; i < loops.size(); ++i) {
    const double distance = distance_to(loops[i], point);
    if (distance < best_value) {
      best = static_cast<int>(i);
      best_value = distance;
    }
  }
  return best;
}

double section_area(const SectionLoop& loop) {
  return polygon_area_vector(loop.points).norm();
}

Vec3 section_centroid(const SectionLoop& loop) {
  const Points& p = loop.points;
  Vec3 mean = p.colwise().mean();
  const Vec3 total = polygon_area_vector(p);
  const double area = total.norm();
  if (!(area > 0)) return mean;
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    const Vec3 a = p.row(i).transpose() - mean, b = p.row((i + 1) % p.rows()).transpose() - mean;
    sum += a.cross(b).dot(total) / (6 * area) * (a + b);
  }
  return mean + sum / area;
}

double section_perimeter(const SectionLoop& loop) {
  const Eigen::Index n = loop.points.rows();
  double sum = 0;
  for (Eigen::Index i = 0; i < (loop.closed ? n : n - 1); ++i)
    sum += (loop.points.row((i + 1) % n) - loop.points.row(i)).norm();
  return sum;
}

double inset_area(const SectionLoop& loop, double distance) {
  const double perimeter = section_perimeter(loop);
  if (2 * M_PI * distance >= perimeter) return 0;
  return std::max(0.0, section_area(loop) - distance * perimeter + M_PI * distance * distance);
}

}  // namespace vasorod
