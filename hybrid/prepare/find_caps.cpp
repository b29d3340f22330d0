#include "prepare/find_caps.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/ray_hits.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Largest angles to the cap's normal, degrees; at twice the angle a ball has 3.9 times the area.
constexpr std::array<double, 4> flats{20, 12, 16, 25};
constexpr double most_oval = 3;    // long axis over short one
constexpr std::size_t fewest = 8;  // triangles

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

class Caps {
 public:
  Caps(const TriangleSurface& surface, bool named)
      : surface_(surface),
        most_growth_(named ? 3 : 2.2),
        enough_(named ? 8 : 13),
        neighbours_(at(static_cast<int>(surface.triangles.rows()))) {
    for (const Edge& edge : edges_of(surface.triangles)) {
      if (edge.boundary()) continue;
      neighbours_[at(edge.triangle[0])].push_back(edge.triangle[1]);
      neighbours_[at(edge.triangle[1])].push_back(edge.triangle[0]);
    }
    for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
      normal_.push_back(triangle_normal(surface, static_cast<int>(t)) / 2);
      area_.push_back(normal_.back().norm());
    }
    mark_.assign(area_.size(), 0);
  }

  std::vector<FlatCap> find(double least) {
    std::vector<FlatCap> found;
    for (const double flat : flats) {
      std::vector<char> tried(area_.size(), 0);
      for (int seed = 0; seed < static_cast<int>(area_.size()); ++seed) {
        if (tried[at(seed)] || area_[at(seed)] <= 0) continue;
        Vec3 normal = normal_[at(seed)].normalized();
        std::vector<int> part;
        constexpr int rounds = 3;  // the seed's normal, then the part's
        for (int round = 0; round < rounds; ++round) {
          part = within(seed, normal, flat);
          Vec3 sum = Vec3::Zero();
          for (const int t : part) sum += normal_[at(t)];
          if (sum.norm() > 0) normal = sum.normalized();
        }
        for (const int t : part) tried[at(t)] = 1;
        if (part.size() < fewest) continue;
        const double inner = area(part), outer = area(within(seed, normal, 2 * flat));
        const double radius = std::sqrt(0.5 * (inner + outer) / M_PI);
        if (radius < least || outer > most_growth_ * inner) continue;
        const double longer = oval(part, normal);
        if (longer > most_oval) continue;
        FlatCap cap{center(part), normal, radius, outer / inner, longer, 0};
        cap.unevenness = off_plane(part, cap.center, normal) / radius;
        found.push_back(cap);
      }
    }
    // One place is found from many seeds: the one with the sharpest rim stands for all.
    std::stable_sort(found.begin(), found.end(),
                     [](const FlatCap& a, const FlatCap& b) { return a.growth < b.growth; });
    std::vector<FlatCap> caps;
    for (const FlatCap& cap : found)
      if (behind_rim(cap) && std::none_of(caps.begin(), caps.end(), [&](const FlatCap& other) {
            return (other.center - cap.center).norm() < std::max(other.radius, cap.radius);
          }))
        caps.push_back(cap);
    return caps;
  }

 private:
  // Connected triangles from the seed whose normals are within the angle of `normal`.
  std::vector<int> within(int seed, const Vec3& normal, double angle) {
    const double least = std::cos(angle * M_PI / 180);
    ++round_;
    std::vector<int> part{seed};
    mark_[at(seed)] = round_;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const int t : neighbours_[at(part[k])])
        if (mark_[at(t)] != round_ && normal_[at(t)].dot(normal) >= least * area_[at(t)]) {
          mark_[at(t)] = round_;
          part.push_back(t);
        }
    return part;
  }

  // Whether the wall falls away behind the cap in nearly every direction. A facet of a tube goes on
  // along the axis.
  bool behind_rim(const FlatCap& cap) {
    constexpr int directions = 16;
    constexpr double steep = 40, reach = 1.6, depth = 0.8;  // degrees; radii
    const Vec3 x = cap.normal.unitOrthogonal(), y = cap.normal.cross(x);
    std::array<bool, directions> falls{};
    for (int t = 0; t < static_cast<int>(area_.size()); ++t) {
      const Vec3 off = triangle_center(surface_, t) - cap.center;
      if (off.norm() > reach * cap.radius || off.dot(cap.normal) > 0.1 * cap.radius ||
          off.dot(cap.normal) < -depth * cap.radius)
        continue;
      const double cosine = normal_[at(t)].dot(cap.normal) / std::max(area_[at(t)], 1e-300);
      if (cosine > std::cos(steep * M_PI / 180)) continue;
      const double turn = std::atan2(off.dot(y), off.dot(x)) / (2 * M_PI) + 1;
      falls[at(static_cast<int>(turn * directions) % directions)] = true;
    }
    return std::count(falls.begin(), falls.end(), true) >= enough_;
  }

  double area(const std::vector<int>& part) const {
    double sum = 0;
    for (const int t : part) sum += area_[at(t)];
    return sum;
  }

  Vec3 center(const std::vector<int>& part) const {
    Vec3 sum = Vec3::Zero();
    for (const int t : part) sum += area_[at(t)] * triangle_center(surface_, t);
    return sum / area(part);
  }

  // Root mean square of the distance from the plane.
  double off_plane(const std::vector<int>& part, const Vec3& middle, const Vec3& normal) const {
    double sum = 0;
    for (const int t : part) {
      const auto height = [&](Eigen::Index k) {
        return (surface_.points.row(surface_.triangles(t, k)).transpose() - middle).dot(normal);
      };
      const Vec3 h(height(0), height(1), height(2));
      sum += area_[at(t)] / 12 * (h.squaredNorm() + h.sum() * h.sum());
    }
    return std::sqrt(sum / area(part));
  }

  // Long axis over short one of the ellipse with the part's second moments.
  double oval(const std::vector<int>& part, const Vec3& normal) const {
    const Vec3 middle = center(part);
    Mat3 moments = Mat3::Zero();
    for (const int t : part)
      for (Eigen::Index k = 0; k < 3; ++k) {
        Vec3 d = surface_.points.row(surface_.triangles(t, k)).transpose() - middle;
        d -= d.dot(normal) * normal;
        moments += area_[at(t)] * d * d.transpose();
      }
    const Vec3 values = Eigen::SelfAdjointEigenSolver<Mat3>(moments).eigenvalues();
    return std::sqrt(values[2] / std::max(values[1], 1e-300));
  }

  const TriangleSurface& surface_;
  double most_growth_;     // of the area from `flat` to twice that
  std::ptrdiff_t enough_;  // directions of 16 in which the wall falls away
  std::vector<std::vector<int>> neighbours_;
  std::vector<Vec3> normal_;  // with the triangle's area as length
  std::vector<double> area_;
  std::vector<int> mark_;
  int round_ = 0;
};

}  // namespace

std::vector<FlatCap> find_caps(const TriangleSurface& surface, double least, bool named) {
  return Caps(surface, named).find(least);
}

bool surely_cut(const FlatCap& cap) {
  return cap.growth < 1.4 && cap.oval < 1.5 && cap.unevenness < 0.04;
}

double depth_behind(const TriangleSurface& surface, const FlatCap& cap) {
  for (const RayHit& hit : RayHits(surface).along(cap.center, -cap.normal))
    if (hit.leaves) return hit.distance / cap.radius;
  return HUGE_VAL;
}

}  // namespace vasorod
