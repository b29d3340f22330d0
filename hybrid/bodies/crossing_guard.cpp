#include "bodies/crossing_guard.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "bodies/near_on_surface.h"
#include "data/index.h"
#include "geometry/box_tree.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Of the distance at the beginning of a step: what is left at its end.
constexpr double left_of_distance = 0.1;
// Of the time in which a distance could fall to that: how far one round of collision detection
// goes. Below so much of what is left a further round gains nothing.
constexpr double per_round = 0.95, no_further = 0.05;
constexpr int most_rounds = 100;
// Over r: what is so near at rest cannot be kept apart.
constexpr double near_at_rest = 1.5;
// Cosine of the angle between the line that joins two features and their walls' normals.
constexpr double facing_from = 0.7;
// Mean edges by which the surface may move before near features are searched again, twice.
constexpr double margin_in_edges = 0.75;
// Of that: a vertex that has moved farther is searched with those that have to be.
constexpr double moved_from = 0.125;

using Places = Eigen::Ref<const Points>;

FeatureCorners corners(const Places& p, const std::array<int, 4>& at) {
  return {p.row(at[0]), p.row(at[1]), p.row(at[2]), p.row(at[3])};
}

struct Barrier {
  double value = 0, first = 0, second = 0;  // and the derivatives by d
};

Barrier barrier(double d, double r) {
  const double gap = d - r, log = std::log(d / r);
  return {-gap * gap * log, -2 * gap * log - gap * gap / d,
          -2 * log - 4 * gap / d + gap * gap / (d * d)};
}

template <std::size_t N>
Box box_around(const Places& p, const std::array<int, N>& at, double margin) {
  Box box;
  for (const int v : at) {
    const Vec3 x = p.row(v);
    box.add({x, x});
  }
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

}  // namespace

CrossingGuard::CrossingGuard(const TriangleSurface& rest, double reach, double stiffness,
                             std::optional<GuardedWall> wall)
    : triangles_(rest.triangles),
      reach_(reach),
      stiffness_(stiffness),
      margin_(std::max(reach, margin_in_edges * mean_edge_length(rest))) {
  for (const Edge& edge : edges_of(triangles_)) edges_.push_back({edge.a, edge.b});
  if (wall) {
    along_ = std::make_unique<NearOnSurface>(rest, wall->along);
    within_ = {2 * wall->inside, 2 * wall->outside};
  }
  for (const Stencil& stencil : near(rest.points, near_at_rest * reach_))
    if (stencil.distance < near_at_rest * reach_) near_at_rest_.push_back(stencil.at);
  std::sort(near_at_rest_.begin(), near_at_rest_.end());
}

CrossingGuard::~CrossingGuard() = default;

CrossingGuard::Memory CrossingGuard::memory() const {
  return {found_, found_at_};
}

void CrossingGuard::remember(Memory memory) {
  found_ = std::move(memory.found);
  found_at_ = std::move(memory.found_at);
}

bool CrossingGuard::nearer(const Stencil& a, const Stencil& b) {
  return std::tie(a.distance, a.features, a.at) < std::tie(b.distance, b.features, b.at);
}

std::vector<CrossingGuard::Stencil> CrossingGuard::near(const Places& p, double reach,
                                                        const std::vector<char>* moved) const {
  std::vector<Stencil> found;
  // What is far along the wall may come so much nearer that its faces meet.
  const double walls = std::max(within_[0], within_[1]), padding = (reach + walls) / 2;
  const auto take = [&](Stencil stencil) {
    const std::array<int, 4>& at = stencil.at;
    const auto second = at.begin() + (stencil.features == Features::two_edges ? 2 : 1);
    if (std::find_first_of(at.begin(), second, second, at.end()) != second) return;
    stencil.distance = feature_distance(corners(p, at), stencil.features).distance;
    if (stencil.distance >= reach + walls) return;
    stencil.far = along_ && !along_->are(at[0], *second);
    if (!stencil.far && stencil.distance >= reach) return;
    if (!std::binary_search(near_at_rest_.begin(), near_at_rest_.end(), at))
      found.push_back(stencil);
  };
  const auto is_marked = [&](const auto& at) {
    return !moved ||
           std::any_of(at.begin(), at.end(), [&](int v) { return (*moved)[index(v)] != 0; });
  };
  std::vector<Box> boxes, marked_boxes;
  std::vector<int> marked;
  for (int t = 0; t < triangles_.rows(); ++t) {
    const std::array<int, 3> at{triangles_(t, 0), triangles_(t, 1), triangles_(t, 2)};
    boxes.push_back(box_around(p, at, padding));
    if (!is_marked(at)) continue;
    marked_boxes.push_back(boxes.back());
    marked.push_back(t);
  }
  const BoxTree all_triangles(boxes), marked_triangles(marked_boxes);
  for (int v = 0; v < p.rows(); ++v) {
    const Box own = box_around<1>(p, {v}, padding);
    const auto meets = [&own](const Box& box) { return box.meets(own); };
    const auto to_triangle = [&](int t) {
      take({{v, triangles_(t, 0), triangles_(t, 1), triangles_(t, 2)},
            Features::vertex_and_triangle});
    };
    if (is_marked(std::array{v}))
      all_triangles.visit(meets, to_triangle);
    else
      marked_triangles.visit(meets, [&](int m) { to_triangle(marked[index(m)]); });
  }
  boxes.clear();
  std::vector<char> marks;
  for (const std::array<int, 2>& edge : edges_) {
    boxes.push_back(box_around(p, edge, padding));
    marks.push_back(is_marked(edge) ? 1 : 0);
  }
  BoxTree(boxes).meeting_pairs(marks, [&](int i, int j) {
    const auto &a = edges_[index(std::min(i, j))], &b = edges_[index(std::max(i, j))];
    take({{a[0], a[1], b[0], b[1]}, Features::two_edges});
    return true;
  });
  return found;
}

// What of the distance lies between the surfaces and the faces that meet, those to which the
// normals of both features point: outside or inside. 0 where the walls face each other at more than
// 45 degrees.
double CrossingGuard::faces_between(const Places& p, const Points& normals,
                                    const Stencil& stencil) const {
  const FeatureDistance apart = feature_distance(corners(p, stencil.at), stencil.features);
  Vec3 turned = Vec3::Zero();
  for (size_t k = 0; k < 4; ++k) turned += apart.weight[k] * normals.row(stencil.at[k]).transpose();
  const double facing = turned.dot(apart.apart) / (turned.norm() * apart.distance);
  return std::abs(facing) > facing_from ? within_[facing < 0 ? 1 : 0] : 0;
}

// Which faces meet stays so as long as they are near.
void CrossingGuard::add_walls(const Places& p, std::vector<Stencil>& found) const {
  if (!along_) return;
  const auto before = [](const Stencil& a, const Stencil& b) {
    return std::tie(a.features, a.at) < std::tie(b.features, b.at);
  };
  std::vector<Stencil> known = found_;
  std::sort(known.begin(), known.end(), before);
  const Points normals = vertex_normals({p, triangles_});
  for (Stencil& stencil : found) {
    const auto same = std::lower_bound(known.begin(), known.end(), stencil, before);
    if (same != known.end() && !before(stencil, *same)) {
      stencil.within = same->within;
    } else if (stencil.far) {
      // What is nearer already, as beside a slit, only keeps its surfaces apart.
      const double within = faces_between(p, normals, stencil);
      const double now = feature_distance(corners(p, stencil.at), stencil.features).distance;
      if (now > within + reach_) stencil.within = within;
    }
    stencil.distance -= stencil.within;
  }
}

double CrossingGuard::moved(const Places& p) const {
  if (found_at_.rows() != p.rows()) return std::numeric_limits<double>::infinity();
  return std::sqrt((p - found_at_).rowwise().squaredNorm().maxCoeff());
}

std::vector<CrossingGuard::Stencil> CrossingGuard::in_order(const Places& p) const {
  return in_order(near(p, reach_ + margin_), p);
}

// `now`: where the surface is, which decides what meets.
std::vector<CrossingGuard::Stencil> CrossingGuard::in_order(std::vector<Stencil> found,
                                                            const Places& now) const {
  add_walls(now, found);
  std::erase_if(found, [this](const Stencil& one) { return one.distance >= reach_ + margin_; });
  std::sort(found.begin(), found.end(), nearer);
  return found;
}

// Only what has moved is searched anew, as most of a wall does not crumple.
void CrossingGuard::search(const Places& p) {
  if (search_all_ || found_at_.rows() != p.rows()) {
    found_ = in_order(p);
    found_at_ = p;
    return;
  }
  std::vector<char> moved(index(p.rows()), 0);
  for (Eigen::Index v = 0; v < p.rows(); ++v) {
    if ((p.row(v) - found_at_.row(v)).norm() <= moved_from * margin_) continue;
    moved[index(v)] = 1;
    found_at_.row(v) = p.row(v);
  }
  const std::vector<Stencil> found = in_order(near(found_at_, reach_ + margin_, &moved), p);
  std::erase_if(found_, [&](const Stencil& one) {
    return std::any_of(one.at.begin(), one.at.end(), [&](int v) { return moved[index(v)] != 0; });
  });
  std::vector<Stencil> all;
  all.reserve(found_.size() + found.size());
  std::merge(found_.begin(), found_.end(), found.begin(), found.end(), std::back_inserter(all),
             nearer);
  found_ = std::move(all);
}

template <class Take>
void CrossingGuard::within_reach(const Places& p, Take&& take) {
  double nearer = 2 * moved(p);  // two features come together by at most this
  if (nearer > margin_) {
    search(p);
    nearer = 2 * moved(p);
  }
  for (const Stencil& stencil : found_) {
    if (stencil.distance > reach_ + nearer) break;
    const FeatureCorners x = corners(p, stencil.at);
    const FeatureDistance found = feature_distance(x, stencil.features);
    if (found.distance < reach_ + stencil.within) take(stencil, x, found);
  }
}

double CrossingGuard::energy(const Places& p) {
  double energy = 0;
  within_reach(p, [&](const Stencil& stencil, const FeatureCorners&, const FeatureDistance& found) {
    const double d = found.distance - stencil.within;
    energy +=
        d > 0 ? stiffness_ * barrier(d, reach_).value : std::numeric_limits<double>::infinity();
  });
  return energy;
}

double CrossingGuard::gradient(const Places& p, Eigen::Ref<Points> gradient) {
  double energy = 0;
  within_reach(p, [&](const Stencil& stencil, const FeatureCorners&, const FeatureDistance& found) {
    const double d = found.distance - stencil.within;
    if (!(d > 0)) {
      energy = std::numeric_limits<double>::infinity();
      return;
    }
    const Barrier b = barrier(d, reach_);
    energy += stiffness_ * b.value;
    const Vec3 force = stiffness_ * b.first / found.distance * found.apart;
    for (size_t k = 0; k < 4; ++k)
      gradient.row(stencil.at[k]) += found.weight[k] * force.transpose();
  });
  return energy;
}

void CrossingGuard::hessian(const Places& p, double blend, int first,
                            std::vector<Eigen::Triplet<double>>& entries) {
  within_reach(
      p, [&](const Stencil& stencil, const FeatureCorners& x, const FeatureDistance& found) {
        const double d = found.distance;
        if (!(d > stencil.within)) return;
        const Barrier b = barrier(d - stencil.within, reach_);
        Eigen::Matrix<double, 12, 1> slope;  // of d
        for (int k = 0; k < 4; ++k)
          slope.segment<3>(3 * k) = found.weight[static_cast<size_t>(k)] / d * found.apart;
        Eigen::Matrix<double, 12, 12> block = b.second * slope * slope.transpose();
        if (blend < 1)
          block += (1 - blend) * b.first / d *
                   (half_square_hessian(x, found, stencil.features) - slope * slope.transpose());
        block *= stiffness_;
        for (int i = 0; i < 12; ++i)
          for (int j = 0; j < 12; ++j)
            if (block(i, j) != 0)
              entries.emplace_back(3 * (first + stencil.at[static_cast<size_t>(i / 3)]) + i % 3,
                                   3 * (first + stencil.at[static_cast<size_t>(j / 3)]) + j % 3,
                                   block(i, j));
      });
}

void CrossingGuard::bound(const Places& p, int first,
                          std::vector<Eigen::Triplet<double>>& entries) {
  within_reach(p, [&](const Stencil& stencil, const FeatureCorners&, const FeatureDistance& found) {
    if (!(found.distance > stencil.within)) return;
    const double second = stiffness_ * barrier(found.distance - stencil.within, reach_).second;
    for (size_t i = 0; i < 4; ++i)
      for (size_t j = 0; j < 4; ++j)
        if (const double entry = second * found.weight[i] * found.weight[j]; entry != 0)
          entries.emplace_back(first + stencil.at[i], first + stencil.at[j], entry);
  });
}

double CrossingGuard::smallest_gap(const Places& p) const {
  double smallest = std::numeric_limits<double>::infinity();
  const Points normals = along_ ? vertex_normals({p, triangles_}) : Points();
  for (const Stencil& stencil : in_order(p)) {
    if (!stencil.far) continue;
    const double within = stencil.within > 0 ? 0 : faces_between(p, normals, stencil);
    smallest = std::min(smallest, stencil.distance - within);
  }
  return smallest;
}

double CrossingGuard::longest_step(const Places& from, const Places& to) {
  const Points moves = to - from;
  const double farthest = std::sqrt(moves.rowwise().squaredNorm().maxCoeff());
  // How near two features must be to come too near in the whole step; and how much they have come
  // together since they were found.
  const double closing = 2 * farthest / (per_round * (1 - left_of_distance));
  double since = 2 * moved(from);
  // A wall's faces are found before they may meet: no point of the step is searched anew.
  const double known = along_ ? margin_ : reach_ + margin_;
  if (closing + since > known) {
    search(from);
    since = 2 * moved(from);
  }
  double step = std::min(1.0, (known - since) / closing);
  for (const Stencil& stencil : found_) {
    if (stencil.distance > closing * step + since) break;
    const int second = stencil.features == Features::two_edges ? 2 : 1;
    double fastest = 0;
    for (int i = 0; i < second; ++i)
      for (int j = second; j < 4; ++j)
        fastest = std::max(fastest, (moves.row(stencil.at[static_cast<size_t>(i)]) -
                                     moves.row(stencil.at[static_cast<size_t>(j)]))
                                        .norm());
    const FeatureCorners x = corners(from, stencil.at), v = corners(moves, stencil.at);
    double distance = feature_distance(x, stencil.features).distance - stencil.within;
    const double least = left_of_distance * distance;
    double time = 0;
    for (int round = 0; round < most_rounds; ++round) {
      const double safe = distance - least;
      if (time > 0 && safe < no_further * least) break;
      time += per_round * safe / fastest;
      if (!(time < step)) {
        time = step;
        break;
      }
      FeatureCorners now = x;
      for (size_t k = 0; k < 4; ++k) now[k] += time * v[k];
      distance = feature_distance(now, stencil.features).distance - stencil.within;
    }
    step = std::min(step, time);
  }
  return std::max(step, 0.0);
}

}  // namespace vasorod
