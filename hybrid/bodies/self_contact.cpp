#include "bodies/self_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bodies/facing_walls.h"
#include "bodies/near_on_surface.h"
#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Edges along the surface within which a mesh can only be bent, not folded onto itself.
constexpr double bent_edges = 4;
// The same of a vessel that is joined: its folds beside the seam are shorter.
constexpr double bent_edges_when_joined = 2.5;
// A vessel that is joined comes to itself in small steps: what seems deeper than this many mean
// edges is a wall whose side is mistaken, beside a mouth that is no plane.
constexpr double deepest_when_joined = 1;
// The same of the seam's own vertices that seem to be through a wall.
constexpr double deepest_on_seam = 0.5;
// A gap in mean edges at which walls that press on each other count as closed.
constexpr double settled = 5e-4;

size_t slot_of(int vertex, bool outside) {
  return 2 * index(vertex) + (outside ? 1 : 0);
}

}  // namespace

SelfContact::SelfContact(ContactSide side, double thickness, double stiffness)
    : FoundContacts(2 * side.wall.rest().points.rows(), side.wall.mean_edge()),
      side_(std::move(side)),
      offset_{thickness - side_.offset, side_.offset},
      stiffness_(stiffness),
      area_(side_.wall.areas()),
      deepest_(side_.joined ? deepest_when_joined * edge_
                            : std::numeric_limits<double>::infinity()),
      never_(2 * index(side_.wall.rest().points.rows()), 0) {
  near_ = std::make_unique<NearOnSurface>(
      side_.wall.rest(), std::max((side_.joined ? bent_edges_when_joined : bent_edges) * edge_,
                                  std::numbers::pi * std::max(offset_[0], offset_[1])));
  settled_ = settled * edge_;
  on_seam_.resize(index(side_.wall.rest().points.rows()), 0);
  for (const int v : side_.seam) on_seam_[index(v)] = 1;
  side_.share.resize(index(side_.wall.rest().points.rows()), 1);
  for (const std::vector<int>& loop : boundary_loops(side_.wall.rest().triangles)) {
    if (std::find(side_.seam.begin(), side_.seam.end(), loop.front()) != side_.seam.end()) continue;
    for (const int v : loop) side_.share[index(v)] = 0;
  }
  for (int i = 0; i < side_.wall.rest().points.rows(); ++i)
    if (!(area_[i] > 0) || side_.left_out(i))
      for (const bool outside : {false, true})
        never_[slot_of(i, outside)] = std::numeric_limits<double>::infinity();
}

SelfContact::SelfContact(SelfContact&&) noexcept = default;
SelfContact& SelfContact::operator=(SelfContact&&) noexcept = default;
SelfContact::~SelfContact() = default;

// What the gap lacks at rest already.
double SelfContact::allowance(const FacingWall& wall, int vertex, bool outside) const {
  Vec3 at = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    at += wall.weight[k] * side_.wall.rest().points.row(wall.corner[index(k)]).transpose();
  const double apart = (Vec3(side_.wall.rest().points.row(vertex)) - at).norm();
  return std::min(0.0, apart - 2 * offset_[outside ? 1 : 0]);
}

bool SelfContact::own(int vertex, const std::array<int, 3>& corner) const {
  return std::any_of(corner.begin(), corner.end(), [&](int v) { return near_->are(vertex, v); });
}

// Takes what a vertex faces as a contact if it is within reach.
void SelfContact::meet(int vertex, bool outside, const FacingWall& wall, double reach,
                       double deepest) {
  if (wall.triangle < 0) return;
  if (!side_.met_up_to_seam && std::any_of(wall.corner.begin(), wall.corner.end(),
                                           [this](int v) { return side_.left_out(v); }))
    return;
  // The normals of two walls in contact are opposite but for the mesh; halfway between them both
  // walls agree on the direction of the force.
  const Vec3 own_normal = walls_->normals().row(vertex);
  const Vec3 normal = (outside ? 1 : -1) * (wall.normal - own_normal).normalized();
  double slack = 2 * offset_[outside ? 1 : 0] + allowance(wall, vertex, outside);
  const Vec3 apart = Vec3(now_.row(vertex)) - wall.at;
  double gap = normal.dot(apart) - slack;
  if (gap > reach || gap < -deepest) return;
  const auto slot = static_cast<Eigen::Index>(slot_of(vertex, outside));
  const double allowed = allowed_depth(slot, gap);
  slack += allowed;
  gap -= allowed;
  const double stick = std::max(0.0, multiplier(slot) - stiffness_ * gap) / edge_;
  add({vertex, wall.corner, wall.weight, normal, slack, area_[vertex] / 2, stiffness_, 0, stick,
       apart},
      slot);
}

// Looks along a vertex's normal, both ways. `nearer`: how far walls may have come together since
// the last search of the whole wall; 0: this is one.
void SelfContact::search(int vertex, double nearer, double reach) {
  std::array<double*, 2> clearance{&clearance_[slot_of(vertex, false)],
                                   &clearance_[slot_of(vertex, true)]};
  if (std::min(*clearance[0], *clearance[1]) > nearer) return;
  std::array<FacingWall, 2> wall;
  for (const bool outside : {false, true}) {
    const double faces = 2 * std::max(offset_[0], offset_[1]);
    double seen = 0;
    wall[outside ? 1 : 0] = walls_->first(
        vertex, outside, 4 * (reach + faces),
        [&](const std::array<int, 3>& corner) { return own(vertex, corner); }, seen);
    // What is seen at a distance may be half as far away: it faces at 60 degrees.
    if (nearer == 0) *clearance[outside ? 1 : 0] = seen / 2 - faces - reach;
  }
  if (wall[0].triangle < 0 && wall[1].triangle < 0) return;
  const int winding = walls_->winding_outside(vertex);
  if (winding == 0) {
    meet(vertex, false, wall[0], reach, deepest_);
    meet(vertex, true, wall[1], reach, deepest_);
  } else {
    // They are through each other: the wall of the lumen is met outwards, that of a fold inwards.
    const bool fold = winding > 0;
    meet(vertex, fold, wall[fold ? 0 : 1], reach,
         on_seam_[index(vertex)] ? deepest_on_seam * edge_ : deepest_);
  }
}

void SelfContact::keep_planes(const Points& now) {
  std::vector<char> met(index(now.rows()), 0);
  for (const ContactPoint& contact : contacts()) met[index(contact.slave)] = 1;
  for (const Pressed& one : pressed())
    if (!met[index(one.contact.slave)]) keep(one.slot, now, now);
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
  if (std::any_of(clearance_.begin(), clearance_.end(),
                  [nearer](double clearance) { return clearance <= nearer; })) {
    if (!walls_) walls_ = std::make_unique<FacingWalls>(side_.wall.rest());
    walls_->refit(slave);
    now_ = slave;
    for (int i = 0; i < slave.rows(); ++i) search(i, nearer, reach);
  }
  keep_planes(slave);
  end();
}

}  // namespace vasorod
