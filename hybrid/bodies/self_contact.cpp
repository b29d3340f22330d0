#include "bodies/self_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>
#include <unordered_set>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/ray_hits.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Walls face each other if their normals are opposite within 60 degrees.
constexpr double facing = -0.5;
// Edges along the surface within which a mesh can only be bent, not folded onto itself.
constexpr double bent_edges = 4;
// Walls farther through each other than this many mean edges are not held to be in contact.
constexpr double deepest = 1;
// A gap in mean edges at which walls that press on each other count as closed.
constexpr double settled = 5e-4;

}  // namespace

// The wall that a vertex faces.
struct SelfContact::Meeting {
  int triangle = -1;  // -1: none
  std::array<int, 3> corner{};
  Vec3 weight = Vec3::Zero(), normal = Vec3::Zero();  // normal: towards the vertex, unit
  double height = 0;                                  // over the tangent plane there, length
  double clear = 0;  // along the ray to the first wall that is not the vertex's own, length
};

// Vertices within a distance along the edges at rest, found where they are asked for.
class SelfContact::Neighbours {
 public:
  Neighbours(const TriangleSurface& rest, double limit)
      : points_(rest.points), limit_(limit), edges_(index(rest.points.rows())) {
    for (const Edge& e : edges_of(rest.triangles)) {
      const double length = (rest.points.row(e.a) - rest.points.row(e.b)).norm();
      edges_[index(e.a)].emplace_back(e.b, length);
      edges_[index(e.b)].emplace_back(e.a, length);
      if (e.boundary()) on_rim_.insert({e.a, e.b});
    }
  }

  bool on_rim(int vertex) const { return on_rim_.contains(vertex); }

  /// Whether b is within the limit of a along the edges.
  bool are(int a, int b) const {
    if (!near(a, b, limit_)) return false;
    auto found = within_.find(a);
    if (found == within_.end()) found = within_.emplace(a, around(a)).first;
    return found->second.contains(b);
  }

  /// Whether they were within two limits of each other, straight.
  bool belong_together(int a, int b) const { return near(a, b, 2 * limit_); }

 private:
  bool near(int a, int b, double distance) const {
    return (points_.row(a) - points_.row(b)).norm() <= distance;
  }

  std::unordered_set<int> around(int source) const {
    std::unordered_map<int, double> distance{{source, 0.0}};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0.0, source);
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) continue;
      for (const auto& [w, length] : edges_[index(v)]) {
        const double way = d + length;
        if (way > limit_) continue;
        const auto known = distance.find(w);
        if (known != distance.end() && known->second <= way) continue;
        distance[w] = way;
        queue.emplace(way, w);
      }
    }
    std::unordered_set<int> vertices;
    for (const auto& [v, d] : distance) vertices.insert(v);
    return vertices;
  }

  Points points_;
  double limit_;
  std::vector<std::vector<std::pair<int, double>>> edges_;
  std::unordered_set<int> on_rim_;
  mutable std::unordered_map<int, std::unordered_set<int>> within_;
};

SelfContact::SelfContact(ContactSide side, double thickness, double stiffness)
    : FoundContacts(2 * side.rest.points.rows()),
      side_(std::move(side)),
      offset_{thickness - side_.offset, side_.offset},
      stiffness_(stiffness),
      area_(vertex_areas(side_.rest)),
      edge_(mean_edge_length(side_.rest)),
      neighbours_(std::make_unique<Neighbours>(
          side_.rest,
          std::max(bent_edges * edge_, std::numbers::pi * std::max(offset_[0], offset_[1])))),
      opposite_(2 * index(side_.rest.points.rows()), -1),
      never_(opposite_.size(), 0) {
  settled_ = settled * edge_;
  for (int i = 0; i < side_.rest.points.rows(); ++i) {
    const bool out = !side_.excluded.empty() && side_.excluded[index(i)];
    if (area_[i] > 0 && !neighbours_->on_rim(i) && !out) continue;
    never_[2 * index(i)] = never_[2 * index(i) + 1] = std::numeric_limits<double>::infinity();
  }
}

SelfContact::SelfContact(SelfContact&&) noexcept = default;
SelfContact& SelfContact::operator=(SelfContact&&) noexcept = default;
SelfContact::~SelfContact() = default;

SelfContact::Meeting SelfContact::meeting(const RayHits& rays, const TriangleSurface& now,
                                          const Points& normals, int vertex, bool outside,
                                          double farthest) const {
  Meeting found;
  found.clear = farthest;
  const Vec3 from = now.points.row(vertex), normal = normals.row(vertex);
  const double sign = outside ? 1 : -1;
  for (const RayHit& hit : rays.along(from, sign * normal, farthest)) {
    std::array<int, 3> corner{};
    for (int k = 0; k < 3; ++k) corner[index(k)] = now.triangles(hit.triangle, k);
    if (std::any_of(corner.begin(), corner.end(),
                    [&](int v) { return neighbours_->are(vertex, v); }))
      continue;
    found.clear = std::min(found.clear, hit.distance);
    if (std::any_of(corner.begin(), corner.end(), [&](int v) {
          return neighbours_->on_rim(v) || (!side_.excluded.empty() && side_.excluded[index(v)]);
        }))
      continue;
    const Vec3 at = from + sign * hit.distance * normal;
    const Vec3 weight = closest_in_triangle(at, now.points.row(corner[0]),
                                            now.points.row(corner[1]), now.points.row(corner[2]));
    Vec3 there = Vec3::Zero();
    for (int k = 0; k < 3; ++k) there += weight[k] * normals.row(corner[index(k)]).transpose();
    if (!(there.norm() > 0.1) || there.normalized().dot(normal) > facing) continue;
    found.triangle = hit.triangle;
    found.corner = corner;
    found.weight = weight;
    found.normal = sign * there.normalized();
    found.height = found.normal.dot(from - at);
    break;
  }
  return found;
}

// What the gap lacks at rest already.
double SelfContact::allowance(const Meeting& meeting, int vertex, bool outside) const {
  Vec3 at = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    at += meeting.weight[k] * side_.rest.points.row(meeting.corner[index(k)]).transpose();
  const double apart = (Vec3(side_.rest.points.row(vertex)) - at).norm();
  return std::min(0.0, apart - 2 * offset_[outside ? 1 : 0]);
}

void SelfContact::refresh(const Points& slave, const Points&, double reach) {
  begin();
  // Two walls come together by at most twice the largest motion.
  double nearer = searched_.rows() == slave.rows()
                      ? 2 * (slave - searched_).rowwise().norm().maxCoeff()
                      : std::numeric_limits<double>::infinity();
  if (nearer > reach / 2) {
    searched_ = slave;
    clearance_ = never_;
    nearer = 0;
  }
  if (std::all_of(clearance_.begin(), clearance_.end(),
                  [nearer](double clearance) { return clearance > nearer; })) {
    std::fill(opposite_.begin(), opposite_.end(), -1);
    end();
    return;
  }
  const TriangleSurface now{slave, side_.rest.triangles};
  const Points normals = vertex_normals(now);
  const RayHits rays(now);
  std::vector<int> opposite(opposite_.size(), -1);
  for (int i = 0; i < slave.rows(); ++i) {
    for (const bool outside : {false, true}) {
      const auto slot = [&](bool side) { return 2 * index(i) + (side ? 1 : 0); };
      double& clearance = clearance_[slot(outside)];
      // Both sides: the path's next start may carry a wall through the one that it faced.
      if (std::min(clearance, clearance_[slot(!outside)]) > nearer) continue;
      const double faces = 2 * offset_[outside ? 1 : 0];
      const double farthest = 4 * (reach + faces);
      Meeting met = meeting(rays, now, normals, i, outside, farthest);
      // What is seen at a distance may be half as far away: it faces at 60 degrees.
      if (nearer == 0) clearance = met.clear / 2 - faces - reach;
      if (met.triangle < 0) continue;
      bool side = outside;
      // The wall that it faced on the other side: they have passed through each other since.
      if (const int last = opposite_[slot(!outside)];
          last >= 0 && opposite_[slot(outside)] < 0 && met.height < deepest * edge_ &&
          neighbours_->belong_together(last, met.corner[0])) {
        side = !outside;
        met.normal = -met.normal;
        met.height = -met.height;
      }
      const double slack = 2 * offset_[side ? 1 : 0] + allowance(met, i, side);
      if (met.height - slack > reach || opposite[slot(side)] >= 0) continue;
      opposite[slot(side)] = met.corner[0];
      add({i, met.corner, met.weight, met.normal, slack, area_[i] / 2, stiffness_, 0},
          static_cast<Eigen::Index>(slot(side)));
    }
  }
  opposite_ = std::move(opposite);
  end();
}

}  // namespace vasorod
