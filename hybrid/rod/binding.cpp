#include "rod/binding.h"

#include <cmath>
#include <numeric>
#include <string>

#include <vasorod/error.h>

#include "geometry/rigid_motion.h"
#include "rod/rod_search.h"

namespace vasorod {
namespace {

// Below this ratio of fibre stretch to axis stretch, the section is considered to reach the centre
// of curvature.
constexpr double smallest_stretch = 0.02;

std::string place(const Vec3& p) {
  return "(" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) +
         ")";
}

// The strain of every element in `poses`.
std::vector<Vec6> strains(const RodTree& tree, const RodPoses& poses) {
  std::vector<Vec6> strain;
  strain.reserve(tree.elements.size());
  for (const RodElement& e : tree.elements) {
    const Pose first = poses[static_cast<size_t>(e.first)] * e.start;
    strain.push_back(log_motion(first.inverse() * poses[static_cast<size_t>(e.second)]) / e.length);
  }
  return strain;
}

}  // namespace

Pose frame_at(const RodTree& tree, const RodPoses& poses, int element, double s) {
  const RodElement& e = tree.elements[static_cast<size_t>(element)];
  const Pose first = poses[static_cast<size_t>(e.first)] * e.start;
  const Vec6 strain = log_motion(first.inverse() * poses[static_cast<size_t>(e.second)]) / e.length;
  return first * exp_motion(s * strain);
}

Binding bind(const RodTree& tree, const Points& points, const std::vector<int>& branch_of) {
  const RodSearch search(tree);
  std::vector<int> branches(tree.branches.size());
  std::iota(branches.begin(), branches.end(), 0);
  Binding binding;
  binding.reserve(static_cast<size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 p = points.row(i);
    std::span<const int> allowed(branches);
    if (!branch_of.empty())
      allowed = allowed.subspan(static_cast<size_t>(branch_of[static_cast<size_t>(i)]), 1);
    const RodHit hit = search.find(p, allowed);
    if (hit.stretch < smallest_stretch && !search.at_fork(hit.at.element))
      throw InputError("the section through the surface point " + place(p) + " is " +
                       std::to_string(hit.distance) +
                       " wide there, which reaches the axis' centre of curvature; expected a "
                       "vessel bent less sharply "
                       "than its radius");
    binding.push_back(hit.at);
  }
  return binding;
}

RodCoordinates project(const RodTree& tree, const Vec3& point) {
  std::vector<int> branches(tree.branches.size());
  std::iota(branches.begin(), branches.end(), 0);
  return RodSearch(tree).find(point, branches, !tree.radius.empty()).at;
}

Points carried_points(const RodTree& tree, const RodPoses& poses, const Binding& binding) {
  const std::vector<Vec6> strain = strains(tree, poses);
  Points carried(static_cast<Eigen::Index>(binding.size()), 3);
  for (size_t i = 0; i < binding.size(); ++i) {
    const auto element = static_cast<size_t>(binding[i].element);
    const Pose first =
        poses[static_cast<size_t>(tree.elements[element].first)] * tree.elements[element].start;
    carried.row(static_cast<Eigen::Index>(i)) =
        first * (exp_motion(binding[i].s * strain[element]) * binding[i].local);
  }
  return carried;
}

std::vector<Mat3> carried_rotations(const RodTree& tree, const RodPoses& poses,
                                    const Binding& binding) {
  const std::vector<Vec6> now = strains(tree, poses), rest = strains(tree, tree.rest);
  std::vector<Mat3> rotation;
  rotation.reserve(binding.size());
  for (const RodCoordinates& at : binding) {
    const auto element = static_cast<size_t>(at.element);
    const auto first = static_cast<size_t>(tree.elements[element].first);
    const Mat3& start = tree.elements[element].start.rotation;
    const Mat3 current =
        poses[first].rotation * start * exp_rotation(at.s * now[element].tail<3>());
    const Mat3 before =
        tree.rest[first].rotation * start * exp_rotation(at.s * rest[element].tail<3>());
    rotation.push_back(current * before.transpose());
  }
  return rotation;
}

}  // namespace vasorod
