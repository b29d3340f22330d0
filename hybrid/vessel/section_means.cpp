#include "vessel/section_means.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

constexpr int passes = 2;  // the second pass fits relative to the poses of the first
// Half width of a band in mean edges, if that is more than an element.
constexpr double band_edges = 1.2;
// Relative extent below which a section covers one direction only and has no mean rotation.
constexpr double thin = 1e-3;

// Vertices of one branch by their arc length.
struct OnBranch {
  double s = 0;
  int vertex = 0;
};

class Sections {
 public:
  explicit Sections(const Vessel& vessel) : vessel_(vessel), area_(vertex_areas(vessel.surface)) {
    const RodTree& rod = vessel.rod;
    half_width_ = band_edges * mean_edge_length(vessel.surface);
    std::vector<std::pair<int, double>> start(rod.elements.size());  // branch, arc length
    for (size_t b = 0; b < rod.branches.size(); ++b) {
      double s = 0;
      for (const int e : rod.branches[b].elements) {
        start[index(e)] = {static_cast<int>(b), s};
        s += rod.elements[index(e)].length;
      }
    }
    on_.resize(rod.branches.size());
    for (size_t v = 0; v < vessel.binding.size(); ++v) {
      const auto& [branch, s] = start[index(vessel.binding[v].element)];
      on_[index(branch)].push_back({s + vessel.binding[v].s, static_cast<int>(v)});
    }
    for (auto& vertices : on_)
      std::sort(vertices.begin(), vertices.end(),
                [](const OnBranch& a, const OnBranch& b) { return a.s < b.s; });
  }

  RodPoses fit(const Points& current, const RodPoses& near, const std::vector<char>& unseen) const {
    const RodTree& rod = vessel_.rod;
    const Points local = in_frames(current, near);
    RodPoses fitted = near;
    std::vector<char> done(near.size(), 0);
    for (size_t b = 0; b < rod.branches.size(); ++b) {
      const RodBranch& branch = rod.branches[b];
      // The change of each node's section from `near`; if it is not seen whole, its neighbour's.
      std::vector<std::optional<Pose>> change;
      double s = 0;
      for (size_t k = 0; k < branch.nodes.size(); ++k) {
        double width = half_width_;
        if (k > 0) width = std::max(width, rod.elements[index(branch.elements[k - 1])].length);
        if (k < branch.elements.size())
          width = std::max(width, rod.elements[index(branch.elements[k])].length);
        const bool seen = unseen.empty() || !unseen[index(branch.nodes[k])];
        change.push_back(seen ? mean_change(b, s, width, local) : std::nullopt);
        if (k < branch.elements.size()) s += rod.elements[index(branch.elements[k])].length;
      }
      for (size_t k = 1; k < change.size(); ++k)
        if (!change[k]) change[k] = change[k - 1];
      for (size_t k = change.size() - 1; k-- > 0;)
        if (!change[k]) change[k] = change[k + 1];
      for (size_t k = 0; k < branch.nodes.size(); ++k) {
        const auto node = index(branch.nodes[k]);
        if (done[node] || !change[k]) continue;
        fitted[node] = near[node] * *change[k];
        done[node] = 1;
      }
    }
    return fitted;
  }

 private:
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
    const auto first = std::lower_bound(vertices.begin(), vertices.end(), s - width,
                                        [](const OnBranch& v, double at) { return v.s < at; });
    double weight = 0;
    Vec3 before = Vec3::Zero(), after = Vec3::Zero();
    const auto hat = [&](const OnBranch& v) {
      return area_[v.vertex] * std::max(0.0, 1 - std::abs(v.s - s) / width);
    };
    for (auto v = first; v != vertices.end() && v->s < s + width; ++v) {
      weight += hat(*v);
      before += hat(*v) * vessel_.binding[index(v->vertex)].local;
      after += hat(*v) * local.row(v->vertex).transpose();
    }
    if (!(weight > 0)) return {};
    before /= weight;
    after /= weight;
    Mat3 spread = Mat3::Zero(), size = Mat3::Zero();
    for (auto v = first; v != vertices.end() && v->s < s + width; ++v) {
      const Vec3 rho = vessel_.binding[index(v->vertex)].local - before;
      spread += hat(*v) * (local.row(v->vertex).transpose() - after) * rho.transpose();
      size += hat(*v) * rho * rho.transpose();
    }
    const Vec3 extent = Eigen::JacobiSVD<Mat3>(size).singularValues();
    if (extent[1] < thin * extent[0]) return {};
    const Eigen::JacobiSVD<Mat3> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 sign = Mat3::Identity();
    sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    Pose change;
    change.rotation = svd.matrixU() * sign * svd.matrixV().transpose();
    change.position = after - change.rotation * before;
    return change;
  }

  const Vessel& vessel_;
  Eigen::VectorXd area_;
  double half_width_ = 0;
  std::vector<std::vector<OnBranch>> on_;
};

}  // namespace

RodPoses section_means(const Vessel& vessel, const Points& current, const RodPoses& near,
                       const std::vector<std::optional<Pose>>& known,
                       const std::vector<char>& unseen) {
  const Sections sections(vessel);
  RodPoses poses = near;
  for (int pass = 0; pass < passes; ++pass) {
    poses = sections.fit(current, poses, unseen);
    for (size_t n = 0; n < known.size(); ++n)
      if (known[n]) poses[n] = *known[n];
  }
  return poses;
}

}  // namespace vasorod
