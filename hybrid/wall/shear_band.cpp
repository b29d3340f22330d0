#include "wall/shear_band.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "wall/shear_left.h"

namespace vasorod {

namespace {

// Width of the band over the layer's length.
constexpr double band_lengths = 3;

// From moduli: across the rim, along it, and of the shear across the wall. `bow`: the curvature.
ShearLayer layer_of(double across, double hoop, double shear, double t, double bow) {
  return shear_layer(across * t * t * t / 12, hoop * t * bow * bow, shear_factor * shear * t);
}

// The glued edges of a rim and the means of its wall.
struct Rim {
  std::vector<Edge> edges;
  double length = 0, thickness = 0, curvature = 0, bending = 0, hoop = 0, shear = 0, left = 0;

  ShearLayer layer() const {
    return layer_of(bending / length, hoop / length, shear / length, thickness / length,
                    curvature / length);
  }
};

bool is_glued(const WallInput& wall, int vertex) {
  return !wall.glued.empty() && wall.glued[index(vertex)] != 0;
}

// Glued boundary edges by connected rim.
std::vector<Rim> rims_of(const WallInput& wall) {
  std::vector<std::vector<Edge>> at(index(wall.rest.points.rows()));
  for (const Edge& e : edges_of(wall.rest.triangles))
    if (e.boundary() && is_glued(wall, e.a) && is_glued(wall, e.b)) {
      at[index(e.a)].push_back(e);
      at[index(e.b)].push_back(e);
    }
  std::vector<Rim> rims;
  std::vector<char> seen(at.size(), 0);
  for (size_t first = 0; first < at.size(); ++first) {
    if (seen[first] || at[first].empty()) continue;
    rims.emplace_back();
    std::vector<size_t> stack{first};
    seen[first] = 1;
    while (!stack.empty()) {
      const size_t v = stack.back();
      stack.pop_back();
      for (const Edge& e : at[v]) {
        const size_t other = index(e.a) == v ? index(e.b) : index(e.a);
        if (index(e.a) == v) rims.back().edges.push_back(e);
        if (seen[other]) continue;
        seen[other] = 1;
        stack.push_back(other);
      }
    }
  }
  return rims;
}

// Gradients of a triangle's barycentric coordinates in a frame of its plane.
Eigen::Matrix<double, 2, 3> gradients_in(const TriangleSurface& surface, int triangle,
                                         const Eigen::Matrix<double, 3, 2>& frame) {
  const auto v = surface.triangles.row(triangle);
  Mat3 corners;  // rows: 1, x, y; their inverse holds the coordinates' coefficients
  for (int k = 0; k < 3; ++k)
    corners.col(k) << 1, frame.transpose() * surface.points.row(v[k]).transpose();
  return corners.inverse().rightCols<2>().transpose();
}

// Sums over the edges of a rim, each weighted by its length: thickness, curvature along the rim,
// the moduli across it and along it, and what the triangles leave of the shear across it.
void measure(const WallInput& wall, const Points& normals, Rim& rim) {
  const Mat3 plane = plane_stress(wall.material), compliance = plane.inverse();
  const Vec2 shear = transverse_shear(wall.material);
  for (const Edge& e : rim.edges) {
    const Vec3 along = (wall.rest.points.row(e.b) - wall.rest.points.row(e.a)).transpose();
    const double length = along.norm();
    const Vec3 turn = (normals.row(e.b) - normals.row(e.a)).transpose();
    rim.length += length;
    rim.thickness += length * (wall.thickness[e.a] + wall.thickness[e.b]) / 2;
    rim.curvature += std::abs(turn.dot(along)) / length;
    const Vec3 normal = triangle_normal(wall.rest, e.triangle[0]).normalized();
    const Vec3& axis = wall.axis[index(e.triangle[0])];
    const Vec3 fibre = (axis - axis.dot(normal) * normal).normalized();
    // the rim in the frame (fibre, across); (-y, x) is the direction across the rim
    const double x = fibre.dot(along) / length, y = normal.cross(fibre).dot(along) / length;
    const Vec3 strain(y * y, x * x, -2 * x * y), stress(x * x, y * y, x * y);
    rim.bending += length * strain.dot(plane * strain);
    rim.hoop += length / stress.dot(compliance * stress);
    rim.shear += length * (y * y * shear[0] + x * x * shear[1]);
    Eigen::Matrix<double, 3, 2> frame;
    frame << fibre, normal.cross(fibre);
    WallSection section;
    section.outer = (wall.thickness[e.a] + wall.thickness[e.b]) / 2;
    section.stiffness = plane;
    section.shear_modulus = shear;
    rim.left +=
        length * shear_left(gradients_in(wall.rest, e.triangle[0], frame), section, Vec2(-y, x));
  }
}

// The point of a segment that is nearest to x.
Vec3 nearest_on(const Vec3& a, const Vec3& b, const Vec3& x) {
  const Vec3 along = b - a;
  return a + std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

// Spreads from the rims over the surface. A vertex takes its way from the rim's edges at the rim
// vertex from which it was reached, or at one beside that if they are nearer.
class Spread {
 public:
  Spread(const WallInput& wall, const Points& normals)
      : wall_(wall),
        normals_(normals),
        around_(index(wall.rest.points.rows())),
        rim_at_(around_.size()),
        reached_(around_.size(), 0),
        lean_(Points::Zero(wall.rest.points.rows(), 3)) {
    for (const Edge& e : edges_of(wall.rest.triangles)) {
      around_[index(e.a)].push_back(e.b);
      around_[index(e.b)].push_back(e.a);
    }
  }

  void start(const Rim& rim, double width) {
    for (const Edge& e : rim.edges)
      for (const int v : {e.a, e.b}) {
        if (rim_at_[index(v)].empty()) queue_.push({0, v, v, width});
        rim_at_[index(v)].push_back(e);
      }
  }

  Points leans() {
    while (!queue_.empty()) {
      Step step = queue_.top();
      queue_.pop();
      if (reached_[index(step.vertex)] != 0) continue;
      if (!rim_at_[index(step.vertex)].empty()) step.source = step.vertex;
      reached_[index(step.vertex)] = 1;
      set_direction(step);
      for (const int next : around_[index(step.vertex)]) {
        if (reached_[index(next)] != 0) continue;
        const int source = nearest_source(step.source, next);
        const double distance = way(source, next).norm();
        if (distance < step.width) queue_.push({distance, next, source, step.width});
      }
    }
    return std::move(lean_);
  }

 private:
  struct Step {
    double distance;
    int vertex, source;
    double width;
    bool operator<(const Step& other) const {
      return distance != other.distance ? distance > other.distance : vertex > other.vertex;
    }
  };

  Vec3 point(int v) const { return wall_.rest.points.row(v); }

  // From the nearest point of the rim's edges at `source` to the vertex.
  Vec3 way(int source, int vertex) const {
    Vec3 shortest = Vec3::Constant(std::numeric_limits<double>::infinity());
    for (const Edge& e : rim_at_[index(source)]) {
      const Vec3 way = point(vertex) - nearest_on(point(e.a), point(e.b), point(vertex));
      if (!(way.squaredNorm() >= shortest.squaredNorm())) shortest = way;
    }
    return shortest;
  }

  int nearest_source(int source, int vertex) const {
    for (double distance = way(source, vertex).norm();;) {
      const int before = source;
      for (const Edge& e : rim_at_[index(before)])
        for (const int other : {e.a, e.b})
          if (const double now = way(other, vertex).norm(); now < distance) {
            distance = now;
            source = other;
          }
      if (source == before) return source;
    }
  }

  void set_direction(const Step& step) {
    const Vec3 normal = normals_.row(step.vertex);
    Vec3 d = Vec3::Zero();
    if (step.vertex != step.source) {
      d = way(step.source, step.vertex);
    } else {
      for (const Edge& e : rim_at_[index(step.vertex)]) {
        const Vec3 inward =
            point(e.opposite[0]) - nearest_on(point(e.a), point(e.b), point(e.opposite[0]));
        const Vec3 across = (point(e.b) - point(e.a)).cross(normal);
        d += std::copysign(1.0, across.dot(inward)) * across;
      }
    }
    d -= d.dot(normal) * normal;
    if (d.norm() > 0) lean_.row(step.vertex) = d.normalized().transpose();
  }

  const WallInput& wall_;
  const Points& normals_;
  std::vector<std::vector<int>> around_;
  std::vector<std::vector<Edge>> rim_at_;
  std::vector<char> reached_;
  std::priority_queue<Step> queue_;
  Points lean_;
};

}  // namespace

ShearLayer shear_layer(double bending, double hoop, double shear) {
  ShearLayer layer;
  const double share = std::sqrt(hoop * bending) / (2 * shear);
  layer.share = share;
  // u ~ exp(-m x): m^2 = sqrt(k / D) (share +- sqrt(share^2 - 1))
  const double wave = std::sqrt(hoop / bending);
  const double decay = share < 1 ? std::sqrt(wave * (1 + share) / 2)
                                 : std::sqrt(wave / (share + std::sqrt(share * share - 1)));
  layer.length = 1 / decay;
  return layer;
}

ShearLayer shear_layer(const Material& material, double thickness, double radius) {
  const Mat3 plane = plane_stress(material);
  return layer_of(plane(0, 0), 1 / plane.inverse()(1, 1), transverse_shear(material)[0], thickness,
                  1 / radius);
}

Points shear_band(const WallInput& wall) {
  // what WallEnergy refuses
  if (wall.thickness.size() != wall.rest.points.rows() ||
      wall.axis.size() != index(wall.rest.triangles.rows()) ||
      (!wall.glued.empty() && wall.glued.size() != index(wall.rest.points.rows())) ||
      fault_of(wall.material))
    return {};
  std::vector<Rim> rims = rims_of(wall);
  if (rims.empty()) return {};
  const Points normals = vertex_normals(wall.rest);
  bool any = false;
  Spread spread(wall, normals);
  for (Rim& rim : rims) {
    measure(wall, normals, rim);
    if (!(rim.curvature > 0)) continue;
    const ShearLayer layer = rim.layer();
    if (!(layer.share * rim.left / rim.length >= least_shear_share)) continue;
    spread.start(rim, band_lengths * layer.length);
    any = true;
  }
  return any ? spread.leans() : Points();
}

}  // namespace vasorod
