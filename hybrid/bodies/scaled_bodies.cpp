#include "bodies/scaled_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vasorod/error.h>

#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// What is nearer along a wall than so many mean edges, or half a turn about its own face, is bent,
// not folded onto itself: there only the surfaces stay apart.
constexpr double bent_edges = 4;

void require(bool good, const SurfaceBody& body, const std::string& sentence) {
  if (!good) throw InputError("vessel " + body.name + ": " + sentence);
}

void check(const SurfaceBody& body) {
  const Eigen::Index count = body.rest.points.rows();
  require(count > 0 && body.rest.triangles.rows() > 0, body,
          "its surface has no triangles, expected some");
  require(body.rest.points.allFinite() && body.carried.allFinite(), body,
          "its surface has a coordinate that is not a number, expected finite ones");
  require(body.carried.rows() == 0 || body.carried.rows() == count, body,
          "found " + std::to_string(body.carried.rows()) + " carried points, expected " +
              std::to_string(count));
  require(body.rotations.empty() || static_cast<Eigen::Index>(body.rotations.size()) == count, body,
          "found " + std::to_string(body.rotations.size()) + " rotations, expected " +
              std::to_string(count));
  require(body.fixed.empty() || static_cast<Eigen::Index>(body.fixed.size()) == count, body,
          "found " + std::to_string(body.fixed.size()) + " flags of fixed vertices, expected " +
              std::to_string(count));
  for (const Mat3& rotation : body.rotations)
    require(rotation.allFinite(), body,
            "a section's rotation is not a number, expected a rotation");
  if (body.obstacle) return;
  const auto good = [](double k) { return std::isfinite(k) && k >= 0; };
  require(
      good(body.k.binding) && body.k.binding > 0 && good(body.k.bending) && good(body.k.stretching),
      body,
      "its coefficients k_c, k_b, k_s are " + std::to_string(body.k.binding) + ", " +
          std::to_string(body.k.bending) + ", " + std::to_string(body.k.stretching) +
          ", expected k_c above zero and the others not below it");
}

bool is_moved(const SurfaceBody& body) {
  if (body.obstacle || body.carried.rows() == 0) return false;
  const double extent =
      (body.rest.points.colwise().maxCoeff() - body.rest.points.colwise().minCoeff()).norm();
  if ((body.carried - body.rest.points).cwiseAbs().maxCoeff() > 1e-12 * extent) return true;
  return std::any_of(body.rotations.begin(), body.rotations.end(), [](const Mat3& r) {
    return (r - Mat3::Identity()).cwiseAbs().maxCoeff() > 1e-12;
  });
}

}  // namespace

GuardedWall guarded_wall(const ScaledBody& body) {
  const double inside = body.thickness - body.offset;
  const double bent = std::numbers::pi * std::max(inside, body.offset);
  return {inside, body.offset, std::max(bent_edges * body.mean_edge, bent)};
}

ScaledBodies scale_bodies(const BodyProblem& problem) {
  ScaledBodies scaled;
  double edges = 0, weight = 0, largest = 0;
  Vec3 centre = Vec3::Zero();
  std::vector<double> mean_edge;
  for (const SurfaceBody& body : problem.bodies) {
    check(body);
    mean_edge.push_back(mean_edge_length(body.rest));
    if (body.obstacle) continue;
    const auto count = static_cast<double>(body.rest.points.rows());
    edges += count * mean_edge.back();
    weight += count;
    centre += body.rest.points.colwise().sum().transpose();
    largest = std::max({largest, body.k.binding, body.k.bending, body.k.stretching});
  }
  if (weight > 0 && edges > 0) {
    scaled.length = edges / weight;
    scaled.stiffness = largest;
    scaled.origin = centre / weight;
  }
  const auto to_scale = [&](const Points& p) -> Points {
    return (p.rowwise() - scaled.origin.transpose()) / scaled.length;
  };
  for (size_t b = 0; b < problem.bodies.size(); ++b) {
    const SurfaceBody& body = problem.bodies[b];
    const auto count = static_cast<size_t>(body.rest.points.rows());
    ScaledBody s;
    s.rest = {to_scale(body.rest.points), body.rest.triangles};
    s.moved = is_moved(body);
    s.carried = s.moved ? to_scale(body.carried) : s.rest.points;
    s.placed = s.now = s.carried;
    s.rotations = s.moved && !body.rotations.empty() ? body.rotations
                                                     : std::vector<Mat3>(count, Mat3::Identity());
    s.fixed = body.fixed.empty() ? std::vector<char>(count, 0) : body.fixed;
    s.k = {body.k.binding / scaled.stiffness, body.k.bending / scaled.stiffness,
           body.k.stretching / scaled.stiffness};
    s.thickness = body.thickness / scaled.length;
    s.offset = body.offset / scaled.length;
    s.mean_edge = mean_edge[b] / scaled.length;
    s.mean_area = total_area(s.rest) / static_cast<double>(count);
    s.obstacle = body.obstacle;
    scaled.bodies.push_back(std::move(s));
  }
  return scaled;
}

}  // namespace vasorod
