#include "vessel/section_means.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"
#include "geometry/triangle_surface.h"
#include "vessel/fork_reach.h"

namespace vasorod {
namespace {

constexpr int passes = 2;  // the second pass fits relative to the poses of the first
// Relative extent below which a section covers one direction only and has no mean rotation.
constexpr double thin = 1e-3;

// Vertices of one branch by their arc length.
struct OnBranch {
  double s = 0;
  int vertex = 0;
};

std::vector<OnBranch>::const_iterator first_from(const std::vector<OnBranch>& vertices, double s) {
  return std::lower_bound(vertices.begin(), vertices.end(), s,
                          [](const OnBranch& v, double at) { return v.s < at; });
}

// A point before and after a motion.
struct WeightedPair {
  double weight;
  Vec3 before, after;
};

// The rigid motion from `before` to `after`: exact at the weighted means, least squares in the
// rotation. Empty if the points lie on one line.
std::optional<Pose> rigid_fit(const std::vector<WeightedPair>& pairs) {
  double weight = 0;
  Vec3 before = Vec3::Zero(), after = Vec3::Zero();
  for (const WeightedPair& pair : pairs) {
    weight += pair.weight;
    before += pair.weight * pair.before;
    after += pair.weight * pair.after;
  }
  if (!(weight > 0)) return {};
  before /= weight;
  after /= weight;
  Mat3 spread = Mat3::Zero(), size = Mat3::Zero();
  for (const WeightedPair& pair : pairs) {
    const Vec3 rho = pair.before - before;
    spread += pair.weight * (pair.after - after) * rho.transpose();
    size += pair.weight * rho * rho.transpose();
  }
  const Vec3 extent = Eigen::JacobiSVD<Mat3>(size).singularValues();
  if (extent[1] < thin * extent[0]) return {};
  Pose change;
  change.rotation = rotation_part(spread);
  change.position = after - change.rotation * before;
  return change;
}

class Sections {
 public:
  explicit Sections(const Vessel& vessel)
      : vessel_(vessel),
        area_(vertex_areas(vessel.surface)),
        reach_(fork_reach(vessel)),
        is_fork_(vessel.rod.rest.size(), 0) {
    const RodTree& rod = vessel.rod;
    mean_edge_ = mean_edge_length(vessel.surface);
    for (const RodBranch& branch : rod.branches)
      if (branch.parent >= 0) is_fork_[index(branch.nodes.front())] = 1;
    const std::vector<ElementPlace> places = element_places(rod);
    on_.resize(rod.branches.size());
    for (size_t v = 0; v < vessel.binding.size(); ++v) {
      const auto& [branch, s] = places[index(vessel.binding[v].element)];
      on_[branch].push_back({s + vessel.binding[v].s, static_cast<int>(v)});
    }
    for (auto& vertices : on_)
      std::sort(vertices.begin(), vertices.end(),
                [](const OnBranch& a, const OnBranch& b) { return a.s < b.s; });
  }

  RodPoses fit(const Points& current, const RodPoses& near,
               const std::vector<std::optional<Pose>>& known,
               const std::vector<char>& unseen) const {
    const RodTree& rod = vessel_.rod;
    const Points local = in_frames(current, near);
    const std::vector<std::optional<Pose>> forks = fork_changes(current, near);
    RodPoses fitted = near;
    std::vector<char> done(near.size(), 0);
    for (size_t b = 0; b < rod.branches.size(); ++b) {
      const RodBranch& branch = rod.branches[b];
      // Empty where the section is not seen whole.
      std::vector<std::optional<Pose>> found;
      std::vector<Pose> before;
      std::vector<double> along;
      double s = 0;
      for (size_t k = 0; k < branch.nodes.size(); ++k) {
        const size_t node = index(branch.nodes[k]);
        double width = 0;
        if (k > 0) width = section_band(rod.elements[index(branch.elements[k - 1])], mean_edge_);
        if (k < branch.elements.size())
          width =
              std::max(width, section_band(rod.elements[index(branch.elements[k])], mean_edge_));
        const bool seen =
            (unseen.empty() || !unseen[node]) && !reach_[b].meets(s - width, s + width);
        const std::optional<Pose> change = forks[node] ? forks[node]
                                           : seen      ? mean_change(b, s, width, local)
                                                       : std::nullopt;
        if (!known.empty() && known[node])
          found.push_back(known[node]);
        else
          found.push_back(change ? std::optional(near[node] * *change) : std::nullopt);
        before.push_back(near[node]);
        along.push_back(s);
        if (k < branch.elements.size()) s += rod.elements[index(branch.elements[k])].length;
      }
      fill(along, before, found);
      for (size_t k = 0; k < branch.nodes.size(); ++k) {
        const auto node = index(branch.nodes[k]);
        if (done[node] || !found[k]) continue;
        fitted[node] = *found[k];
        done[node] = 1;
      }
    }
    return fitted;
  }

 private:
  // Poses of the nodes between two fitted ones: carried by the rigid motion that goes from one to
  // the other, by arc length. Beyond the last fitted node: carried by its motion. A motion is that
  // of space from `near`, since the frames of a branch may turn sharply at its fork.
  static void fill(const std::vector<double>& along, const std::vector<Pose>& near,
                   std::vector<std::optional<Pose>>& fitted) {
    const auto motion = [&](size_t k) { return *fitted[k] * near[k].inverse(); };
    std::vector<size_t> known;
    for (size_t k = 0; k < fitted.size(); ++k)
      if (fitted[k]) known.push_back(k);
    if (known.empty()) return;
    for (size_t k = 0; k < known.front(); ++k) fitted[k] = motion(known.front()) * near[k];
    for (size_t k = known.back() + 1; k < fitted.size(); ++k)
      fitted[k] = motion(known.back()) * near[k];
    for (size_t i = 0; i + 1 < known.size(); ++i) {
      const size_t before = known[i], after = known[i + 1];
      if (after == before + 1) continue;
      const Pose start = motion(before);
      const Vec6 step = log_motion(start.inverse() * motion(after));
      for (size_t k = before + 1; k < after; ++k)
        fitted[k] = start *
                    exp_motion((along[k] - along[before]) / (along[after] - along[before]) * step) *
                    near[k];
    }
  }

  // A node where branches meet has no section of its own. Its change is that of the wall around
  // it: the rigid motion that fits the vertices within the fork's reach on all branches.
  std::vector<std::optional<Pose>> fork_changes(const Points& current, const RodPoses& near) const {
    const RodTree& rod = vessel_.rod;
    std::vector<std::vector<WeightedPair>> around(near.size());
    for (size_t b = 0; b < rod.branches.size(); ++b) {
      const size_t front = index(rod.branches[b].nodes.front()),
                   back = index(rod.branches[b].nodes.back());
      for (const OnBranch& v : on_[b])
        for (const size_t fork : {front, back}) {
          const double away = fork == front ? v.s : reach_[b].length - v.s;
          if (!is_fork_[fork] || away > (fork == front ? reach_[b].start : reach_[b].end)) continue;
          around[fork].push_back(
              {area_[v.vertex],
               rod.rest[fork].inverse() * Vec3(vessel_.surface.points.row(v.vertex)),
               near[fork].inverse() * Vec3(current.row(v.vertex))});
        }
    }
    std::vector<std::optional<Pose>> changes(near.size());
    for (size_t n = 0; n < near.size(); ++n)
      if (is_fork_[n]) changes[n] = rigid_fit(around[n]);
    return changes;
  }

  // Each vertex in the frame that `near` has at its own section.
  Points in_frames(const Points& current, const RodPoses& near) const {
    Points local(current.rows(), 3);
    for (Eigen::Index i = 0; i < current.rows(); ++i) {
      const RodCoordinates& at = vessel_.binding[index(i)];
      local.row(i) = frame_at(vessel_.rod, near, at.element, at.s).inverse() * Vec3(current.row(i));
    }
    return local;
  }

  std::optional<Pose> mean_change(size_t branch, double s, double width,
                                  const Points& local) const {
    const auto& vertices = on_[branch];
    std::vector<WeightedPair> pairs;
    for (auto v = first_from(vertices, s - width); v != vertices.end() && v->s < s + width; ++v)
      pairs.push_back({area_[v->vertex] * std::max(0.0, 1 - std::abs(v->s - s) / width),
                       vessel_.binding[index(v->vertex)].local, local.row(v->vertex)});
    return rigid_fit(pairs);
  }

  const Vessel& vessel_;
  Eigen::VectorXd area_;
  double mean_edge_ = 0;
  std::vector<ForkReach> reach_;  // per branch
  std::vector<char> is_fork_;     // per node
  std::vector<std::vector<OnBranch>> on_;
};

}  // namespace

RodPoses section_means(const Vessel& vessel, const Points& current, const RodPoses& near,
                       const std::vector<std::optional<Pose>>& known,
                       const std::vector<char>& unseen) {
  const Sections sections(vessel);
  RodPoses poses = near;
  for (int pass = 0; pass < passes; ++pass) poses = sections.fit(current, poses, known, unseen);
  return poses;
}

}  // namespace vasorod
