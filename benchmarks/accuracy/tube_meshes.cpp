#include "accuracy/tube_meshes.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace vasorod::bench {

using std::numbers::pi;

TubeMesh structured(double length, double radius, int around, double aspect) {
  TubeMesh mesh;
  mesh.name = aspect == 1 ? "structured" : "long triangles";
  mesh.edge = 2 * pi * radius / around;
  TubeSpec tube;
  tube.length = length;
  tube.radius = radius;
  tube.around = around;
  tube.along =
      2 * static_cast<int>(std::lround(length / (mesh.edge * std::sqrt(3.0) / 2 * aspect) / 2));
  mesh.triangles = tube_surface(tube).triangles;
  mesh.s = tube_arc_lengths(tube);
  mesh.angle.resize(mesh.s.size());
  for (int row = 0; row <= tube.along; ++row)
    for (int i = 0; i < around; ++i)
      mesh.angle[row * around + i] = 2 * pi * (i + 0.5 * (row % 2)) / around;
  return mesh;
}

TubeMesh shifted(double length, double radius, int around) {
  TubeMesh mesh = structured(length, radius, around);
  mesh.name = "shifted";
  const double row = mesh.s[around];
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> quarter(-0.25, 0.25);
  for (Eigen::Index i = around; i < mesh.s.size() - around; ++i) {
    mesh.angle[i] += quarter(engine) * mesh.edge / radius;
    mesh.s[i] += quarter(engine) * row;
  }
  return mesh;
}

namespace {

// Points on the unrolled tube with distances of at least `least`; a grid of that size finds
// neighbours.
class Darts {
 public:
  Darts(double width, double height, double least)
      : width_(width),
        least_(least),
        columns_(static_cast<int>(width / least)),
        rows_(static_cast<int>(height / least) + 1),
        cells_(static_cast<std::size_t>(columns_ * rows_)) {}

  bool is_free(const Vec2& p) const {
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b) {
        const int row = row_of(p) + b;
        if (row < 0 || row >= rows_) continue;
        for (const int i : cells_[cell((column_of(p) + a + columns_) % columns_, row)]) {
          Vec2 apart = points_[static_cast<std::size_t>(i)] - p;
          apart.x() -= width_ * std::round(apart.x() / width_);
          if (apart.squaredNorm() < least_ * least_) return false;
        }
      }
    return true;
  }

  void add(const Vec2& p) {
    cells_[cell(column_of(p), row_of(p))].push_back(static_cast<int>(points_.size()));
    points_.push_back(p);
  }

  const std::vector<Vec2>& points() const { return points_; }

 private:
  int column_of(const Vec2& p) const {
    return std::min(columns_ - 1, static_cast<int>(p.x() / width_ * columns_));
  }
  int row_of(const Vec2& p) const { return std::min(rows_ - 1, static_cast<int>(p.y() / least_)); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }

  double width_, least_;
  int columns_, rows_;
  std::vector<std::vector<int>> cells_;
  std::vector<Vec2> points_;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

// Delaunay triangulation of the points and of copies beyond the seam. Of the copies of a triangle,
// the one whose centroid lies on the sheet is kept.
Triangles wrapped_delaunay(const std::vector<Vec2>& points, double width, double band) {
  std::vector<std::pair<Kernel::Point_2, int>> sheet;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x(), y = points[i].y();
    const int number = static_cast<int>(i);
    sheet.emplace_back(Kernel::Point_2(x, y), number);
    if (x < band) sheet.emplace_back(Kernel::Point_2(x + width, y), number);
    if (x > width - band) sheet.emplace_back(Kernel::Point_2(x - width, y), number);
  }
  const Delaunay delaunay(sheet.begin(), sheet.end());
  std::vector<std::array<int, 3>> kept;
  for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face) {
    double middle = 0;
    for (int k = 0; k < 3; ++k) middle += face->vertex(k)->point().x() / 3;
    if (middle >= 0 && middle < width)
      kept.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  Triangles triangles(static_cast<Eigen::Index>(kept.size()), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      triangles(t, k) = kept[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
  return triangles;
}

}  // namespace

TubeMesh blue_noise(double length, double radius, int around) {
  TubeMesh mesh;
  mesh.name = "blue-noise";
  mesh.edge = 2 * pi * radius / around;
  const double width = 2 * pi * radius;
  Darts darts(width, length, 0.76 * mesh.edge);
  for (int i = 0; i < around; ++i) {
    darts.add({i * mesh.edge, 0});
    darts.add({i * mesh.edge, length});
  }
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> across(0, width),
      along(0.45 * mesh.edge, length - 0.45 * mesh.edge);
  for (int misses = 0; misses < 20000;) {
    const double x = across(engine);
    const Vec2 p(x, along(engine));
    if (darts.is_free(p)) {
      darts.add(p);
      misses = 0;
    } else {
      ++misses;
    }
  }
  const auto count = static_cast<Eigen::Index>(darts.points().size());
  mesh.angle.resize(count);
  mesh.s.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    mesh.angle[i] = darts.points()[static_cast<std::size_t>(i)].x() / radius;
    mesh.s[i] = darts.points()[static_cast<std::size_t>(i)].y();
  }
  mesh.triangles = wrapped_delaunay(darts.points(), width, 6 * mesh.edge);
  return mesh;
}

TriangleSurface placed(const TubeMesh& mesh, const TubeSpec& tube) {
  TriangleSurface surface;
  surface.triangles = mesh.triangles;
  surface.points.resize(mesh.s.size(), 3);
  for (Eigen::Index i = 0; i < mesh.s.size(); ++i)
    surface.points.row(i) =
        tube_axis(tube, mesh.s[i]) *
        Vec3(tube.radius * std::cos(mesh.angle[i]), tube.radius * std::sin(mesh.angle[i]), 0);
  return surface;
}

}  // namespace vasorod::bench
