#include "bodies/contact_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/normal_foot.h"
#include "bodies/reach.h"
#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Outer faces touch with opposite normals. If the dot product of the normals exceeds this value,
// the wall is the far side of a vessel, not a wall in contact.
constexpr double facing_same_way = 0.2;

// Where two vessels are joined, a wall farther inside than this many mean edges of its own surface
// has come in through the mouth, which is open to it.
constexpr double through_the_mouth = 3;
// The same where walls meet right up to their seam, to which they come in small steps: what seems
// deeper is a wall whose side is mistaken.
constexpr double through_the_seam = 1.5;
// The same once they have been parted (walls_are_parted()).
constexpr double through_parted_walls = 0.6;

struct Feature {
  bool valid = false;
  bool swallowed = false;  // inside, facing the same way
  std::array<int, 3> vertex{};
  Vec3 weight, normal;
  double distance = 0;  // along the interpolated normal
  double offset = 0;    // from the master's surface to its outer face there
};

double offset_at(const ContactSide& side, int vertex) {
  return side.share.empty() ? side.offset : side.share[index(vertex)] * side.offset;
}

Feature facing_feature(const ClosestPoint& finder, NormalsOnDemand& normal_of,
                       const ContactSide& side, const Vec3& point, const Vec3& point_normal,
                       const ClosestPoint::Hit& hit) {
  Feature feature;
  if (hit.on_boundary) return feature;
  const NormalFoot foot = normal_foot(finder, normal_of, point, hit);
  feature.weight = foot.weight;
  for (int k = 0; k < 3; ++k) {
    const int v = finder.surface().triangles(foot.triangle, k);
    if (side.left_out(v) && !side.met_up_to_seam) return feature;
    feature.vertex[index(k)] = v;
    feature.offset += foot.weight[k] * offset_at(side, v);
  }
  if (foot.normal.norm() < 0.1) return feature;  // a fold: no outside
  feature.normal = foot.normal.normalized();
  feature.distance = foot.height;
  if (feature.normal.dot(point_normal) > facing_same_way) {
    feature.swallowed = hit.signed_distance < 0;
    return feature;
  }
  feature.valid = true;
  return feature;
}

}  // namespace

ContactPair::ContactPair(ContactSide slave, ContactSide master, double stiffness)
    : FoundContacts(slave.wall.rest().points.rows(), slave.wall.mean_edge()),
      slave_(std::move(slave)),
      master_(std::move(master)),
      stiffness_(stiffness),
      deepest_(slave_.joined
                   ? (slave_.met_up_to_seam ? through_the_seam : through_the_mouth) * edge_
                   : std::numeric_limits<double>::infinity()),
      slave_rest_normal_(slave_.wall.at_rest()),
      master_rest_normal_(master_.wall.at_rest()),
      looked_(index(slave_.wall.rest().points.rows())),
      master_then_(master_.wall.rest().points),
      allowance_(index(slave_.wall.rest().points.rows()),
                 std::numeric_limits<double>::quiet_NaN()) {}

void ContactPair::walls_are_parted() {
  if (slave_.joined && slave_.met_up_to_seam) deepest_ = through_parted_walls * edge_;
}

bool ContactPair::is_clear(int vertex, const Vec3& place, double margin) const {
  const Looked& last = looked_[index(vertex)];
  return last.distance - (place - last.place).norm() - (travel_ - last.travel) > margin;
}

double ContactPair::allowance(int vertex) {
  double& value = allowance_[static_cast<size_t>(vertex)];
  if (std::isnan(value)) {
    const ClosestPoint& master = master_.wall.at_rest();
    const Vec3 place = slave_.wall.rest().points.row(vertex);
    const Feature feature = facing_feature(master, master_rest_normal_, master_, place,
                                           slave_rest_normal_(vertex), master.query(place));
    const double gap =
        feature.valid ? feature.distance - offset_at(slave_, vertex) - feature.offset : 0;
    // Walls that touch at rest must not press on each other because of rounding. The slack added
    // here is far below any relevant length.
    value = std::min(0.0, gap) - 1e-10 * (std::sqrt(slave_.wall.areas()[vertex]) + std::abs(gap));
  }
  return value;
}

bool ContactPair::inside_at_rest(int vertex) {
  const ClosestPoint::Hit hit = master_.wall.at_rest().query(slave_.wall.rest().points.row(vertex));
  return !hit.on_boundary && hit.signed_distance < 0;
}

void ContactPair::refresh(const Points& slave, const Points& master, double reach) {
  begin();
  // An overlap at rest only lowers the slack. From outside, a feature farther away than this cannot
  // have a gap below `reach`; from inside every feature counts.
  const Box box = box_of(master);
  const double margin = reach + slave_.offset + master_.offset;
  travel_ += (master - master_then_).rowwise().norm().maxCoeff();
  master_then_ = master;
  const Eigen::VectorXd& area = slave_.wall.areas();
  std::vector<int> near;
  for (int i = 0; i < slave.rows(); ++i)
    if (!slave_.left_out(i) && area[i] > 0 && box.exteriorDistance(Vec3(slave.row(i))) <= margin &&
        !is_clear(i, slave.row(i), margin))
      near.push_back(i);
  if (near.empty()) {
    end();
    return;
  }
  const ClosestPoint& wall = master_.wall.now_at(master);
  NormalsOnDemand wall_normal(wall), own_normal(slave_.wall.now_at(slave));
  for (const int i : near) {
    const ClosestPoint::Hit hit = wall.query(slave.row(i), looked_[index(i)].triangle);
    looked_[index(i)] = {hit.on_boundary ? 0 : hit.signed_distance, travel_, slave.row(i),
                         hit.triangle};
    const Feature feature =
        facing_feature(wall, wall_normal, master_, slave.row(i), own_normal(i), hit);
    const double noise = 0.1 * std::sqrt(area[i]);
    if (feature.swallowed && feature.distance < -noise && !inside_at_rest(i)) ++swallowed_;
    const double faces = offset_at(slave_, i) + feature.offset;
    if (!feature.valid && keep(i, slave, master)) continue;
    if (!feature.valid || feature.distance - faces > reach) continue;
    const double rest = allowance(i);
    if (feature.distance - faces - rest > reach) continue;
    if (feature.distance - faces - rest < -deepest_) continue;
    const double slack = faces + rest + allowed_depth(i, feature.distance - faces - rest);
    ContactPoint contact{i,     feature.vertex, feature.weight, feature.normal,
                         slack, area[i],        stiffness_,     0};
    if (held()) stick(contact, i, slave, master);
    add(contact, i);
  }
  end();
}

}  // namespace vasorod
