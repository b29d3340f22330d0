#include "vessel/rest_rod.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/rigid_motion.h"
#include "vessel/arc_length.h"

namespace vasorod {
namespace {

// A branch with more elements indicates wrong units; the bound keeps the count within an int.
constexpr double most_elements = 1e6;

// The smallest rotation that takes unit vector a to unit vector b.
Mat3 shortest_rotation(const Vec3& a, const Vec3& b) {
  return Eigen::Quaterniond::FromTwoVectors(a, b).toRotationMatrix();
}

// Transports the frame `from`, whose d3 is the curve's tangent there, to (r, t) without rotation
// about the tangent.
Pose transported(const Pose& from, const Vec3& r, const Vec3& t) {
  const Vec3 v1 = r - from.position;
  const Vec3 d1 = from.director(1) - 2 / v1.squaredNorm() * v1.dot(from.director(1)) * v1;
  const Vec3 d3 = from.director(3) - 2 / v1.squaredNorm() * v1.dot(from.director(3)) * v1;
  const Vec3 v2 = t - d3;
  Vec3 x = d1;
  if (v2.squaredNorm() > 0) x -= 2 / v2.squaredNorm() * v2.dot(d1) * v2;
  Pose to;
  to.position = r;
  x = (x - x.dot(t) * t).normalized();
  to.rotation << x, t.cross(x), t;
  return to;
}

}  // namespace

RestRod rest_rod(const Centerline& centerline, double spacing, const Vec3& first_point) {
  const size_t count = centerline.curves.size();
  RestRod rod;
  RodTree& tree = rod.tree;
  rod.branches_of.resize(count);
  rod.branch_end.resize(count);
  std::vector<int> start_node(count, 0), start_branch(count, -1);
  for (size_t c = 0; c < count; ++c) {
    const AxisCurve& curve = centerline.curves[c];
    const ArcLength arc(curve.axis);

    // Forks on this curve, in order; those closer than half an element share a node.
    struct Fork {
      double u;
      std::vector<size_t> children;
    };
    std::vector<Fork> forks;
    for (size_t k = c + 1; k < count; ++k)
      if (centerline.curves[k].parent == static_cast<int>(c))
        forks.push_back({centerline.curves[k].parent_u, {k}});
    std::stable_sort(forks.begin(), forks.end(),
                     [](const Fork& a, const Fork& b) { return a.u < b.u; });
    auto radius_at = [&](double u) {
      const double typical = centerline.paths.paths[c].radius;
      // Before its first closed section, a branch has no radius of its own.
      return std::clamp(curve.radius(std::max(u, curve.clean_start))[0], 0.25 * typical,
                        4 * typical);
    };
    std::vector<Fork> stops;
    for (Fork& fork : forks) {
      const double room = 0.5 * spacing * radius_at(fork.u);
      fork.u = std::max(std::min(fork.u, curve.last - 2 * room), curve.first + 2 * room);
      if (!stops.empty() && fork.u - stops.back().u < room)
        stops.back().children.insert(stops.back().children.end(), fork.children.begin(),
                                     fork.children.end());
      else
        stops.push_back(std::move(fork));
    }
    stops.push_back({curve.last, {}});

    const Vec3 t0 = curve.axis.derivative(curve.first).normalized();
    Pose frame;
    if (c == 0) {
      frame.position = curve.axis(curve.first);
      const Vec3 towards = first_point - frame.position;
      const Vec3 d1 = (towards - towards.dot(t0) * t0).normalized();
      frame.rotation << d1, t0.cross(d1), t0;
      tree.rest.push_back(frame);
      tree.radius.push_back(radius_at(curve.first));
    } else {
      frame = tree.rest[static_cast<size_t>(start_node[c])];
      frame.rotation = shortest_rotation(frame.director(3), t0) * frame.rotation;
    }
    int node = start_node[c], parent = start_branch[c];
    double from = arc(curve.first);
    for (const Fork& stop : stops) {
      const double to = arc(stop.u);
      const double local = radius_at(arc.inverse(0.5 * (from + to)));
      const double wanted = std::ceil((to - from) / (spacing * local) - 1e-6);
      if (!std::isfinite(wanted))
        throw InputError("found no axis through the surface's sections, expected a tubular vessel");
      if (wanted > most_elements)
        throw InputError("found an axis of length " + number_text(to - from) + " on a radius of " +
                         number_text(local) + ", which takes " + number_text(wanted) +
                         " elements, expected at most " + number_text(most_elements));
      const int elements = std::max(1, static_cast<int>(wanted));
      RodBranch branch;
      branch.parent = parent;
      branch.nodes.push_back(node);
      for (int i = 1; i <= elements; ++i) {
        const double u = i == elements ? stop.u : arc.inverse(from + (to - from) * i / elements);
        frame = transported(frame, curve.axis(u), curve.axis.derivative(u).normalized());
        RodElement element;
        element.first = node;
        element.second = tree.node_count();
        element.length = (to - from) / elements;
        element.rest_strain =
            log_motion(tree.rest[static_cast<size_t>(node)].inverse() * frame) / element.length;
        element.natural_strain = element.rest_strain;
        node = element.second;
        tree.rest.push_back(frame);
        tree.radius.push_back(radius_at(u));
        branch.nodes.push_back(node);
        branch.elements.push_back(static_cast<int>(tree.elements.size()));
        tree.elements.push_back(element);
      }
      parent = static_cast<int>(tree.branches.size());
      rod.branches_of[c].push_back(parent);
      rod.branch_end[c].push_back(stop.u);
      tree.branches.push_back(std::move(branch));
      for (const size_t child : stop.children) {
        start_node[child] = node;
        start_branch[child] = parent;
      }
      from = to;
    }
  }
  return rod;
}

}  // namespace vasorod
