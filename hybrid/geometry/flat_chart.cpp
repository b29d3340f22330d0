#include "geometry/flat_chart.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "data/index.h"

namespace vasorod {
namespace {

// Rotations are updated until no point moves by more than this part of the patch's size.
constexpr double settled = 1e-8;
constexpr int most_updates = 200;

// A triangle in its own plane, x along the wanted direction.
struct FlatTriangle {
  std::array<int, 3> vertex{};  // numbers within the patch
  std::array<Vec2, 3> slope;    // gradients of the three hat functions, 1 / length
  double area = 0;
};

FlatTriangle flat_triangle(const TriangleSurface& surface, int t, const Vec3& along) {
  const auto point = [&](int k) -> Vec3 { return surface.points.row(surface.triangles(t, k)); };
  const Vec3 normal = (point(1) - point(0)).cross(point(2) - point(0));
  const Vec3 unit = normal.normalized();
  Vec3 x = along - along.dot(unit) * unit;
  x = x.norm() > 1e-9 * along.norm() ? x.normalized() : unit.unitOrthogonal();
  const Vec3 y = unit.cross(x);
  FlatTriangle flat;
  flat.area = normal.norm() / 2;
  for (int k = 0; k < 3; ++k) {
    // The hat function rises across the opposite edge.
    const Vec3 edge = point((k + 2) % 3) - point((k + 1) % 3);
    flat.slope[index(k)] = Vec2(-edge.dot(y), edge.dot(x)) / (2 * flat.area);
  }
  return flat;
}

// The gradient of the plane coordinates: one row per coordinate.
Eigen::Matrix2d gradient_of(const FlatTriangle& flat, const Eigen::MatrixX2d& at) {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
  for (size_t k = 0; k < 3; ++k)
    gradient += at.row(flat.vertex[k]).transpose() * flat.slope[k].transpose();
  return gradient;
}

Eigen::Matrix2d nearest_rotation(const Eigen::Matrix2d& m) {
  return Eigen::Rotation2Dd(std::atan2(m(1, 0) - m(0, 1), m(0, 0) + m(1, 1))).toRotationMatrix();
}

}  // namespace

Eigen::MatrixX2d unroll(const TriangleSurface& surface, const ChartRequest& request) {
  std::vector<int> number(index(surface.points.rows()), -1);
  std::vector<FlatTriangle> triangles;
  int count = 0;
  for (size_t i = 0; i < request.patch.size(); ++i) {
    const int t = request.patch[i];
    triangles.push_back(flat_triangle(surface, t, request.along.row(static_cast<Eigen::Index>(i))));
    for (int k = 0; k < 3; ++k) {
      int& own = number[index(surface.triangles(t, k))];
      if (own < 0) own = count++;
      triangles.back().vertex[index(k)] = own;
    }
  }
  if (count == 0) throw std::logic_error("unroll: a patch without triangles");

  std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}};  // holds the first vertex
  for (const FlatTriangle& flat : triangles)
    for (size_t k = 0; k < 3; ++k)
      for (size_t l = 0; l < 3; ++l)
        entries.emplace_back(flat.vertex[k], flat.vertex[l],
                             flat.area * flat.slope[k].dot(flat.slope[l]));
  Eigen::SparseMatrix<double> stiffness(count, count);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
  if (solver.info() != Eigen::Success)
    throw std::logic_error("unroll: the patch is not connected or has a triangle without area");

  std::vector<Eigen::Matrix2d> rotation(triangles.size(), Eigen::Matrix2d::Identity());
  Eigen::MatrixX2d at = Eigen::MatrixX2d::Zero(count, 2);
  for (int update = 0; update < most_updates; ++update) {
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
    for (size_t i = 0; i < triangles.size(); ++i)
      for (size_t k = 0; k < 3; ++k)
        right.row(triangles[i].vertex[k]) +=
            triangles[i].area * (rotation[i] * triangles[i].slope[k]).transpose();
    const Eigen::MatrixX2d next = solver.solve(right);
    const double change = (next - at).cwiseAbs().maxCoeff();
    at = next;
    if (change <= settled * at.cwiseAbs().maxCoeff()) break;
    for (size_t i = 0; i < triangles.size(); ++i)
      rotation[i] = nearest_rotation(gradient_of(triangles[i], at));
  }

  // The wanted direction is x in the mean, and the origin is 0.
  Vec2 along = Vec2::Zero(), origin = Vec2::Zero();
  for (const FlatTriangle& flat : triangles) along += flat.area * gradient_of(flat, at).col(0);
  for (int k = 0; k < 3; ++k)
    origin += request.barycentric[k] *
              at.row(number[index(surface.triangles(request.triangle, k))]).transpose();
  const Eigen::Rotation2Dd turn(-std::atan2(along.y(), along.x()));
  Eigen::MatrixX2d chart = Eigen::MatrixX2d::Constant(surface.points.rows(), 2,
                                                      std::numeric_limits<double>::quiet_NaN());
  for (size_t v = 0; v < number.size(); ++v)
    if (number[v] >= 0)
      chart.row(static_cast<Eigen::Index>(v)) =
          (turn * (at.row(number[v]).transpose() - origin)).transpose();
  return chart;
}

}  // namespace vasorod
