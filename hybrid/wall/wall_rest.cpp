// The wall at rest: its edges and their unknowns, its curvature, its stiffness.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "wall/axial_stretch.h"
#include "wall/held_thickness.h"
#include "wall/lumen.h"
#include "wall/shear_pairs.h"
#include "wall/triangle_stiffness.h"
#include "wall/wall_energy.h"

namespace vasorod {

namespace {

template <typename... Parts>
[[noreturn]] void refuse(const std::string& where, const Parts&... parts) {
  throw InputError(where + ": " + joined_text(parts...));
}

void check(const WallInput& in) {
  const auto n = in.rest.points.rows();
  if (in.rest.triangles.rows() == 0) refuse(in.name, "found no triangle, expected a surface");
  if (in.thickness.size() != n)
    refuse(in.name, "found ", in.thickness.size(), " thicknesses, expected one per vertex (", n,
           ")");
  if (in.axis.size() != static_cast<size_t>(in.rest.triangles.rows()))
    refuse(in.name, "found ", in.axis.size(), " axes, expected one per triangle (",
           in.rest.triangles.rows(), ")");
  if (!in.glued.empty() && in.glued.size() != static_cast<size_t>(n))
    refuse(in.name, "found ", in.glued.size(), " glued marks, expected one per vertex (", n, ")");
  const auto displaced = in.prestress_displacement.rows();
  if (displaced != 0 && displaced != n)
    refuse(in.name, "found ", displaced,
           " displacements of the prestress, expected one per vertex (", n, ")");
  if (!in.prestress_displacement.allFinite())
    refuse(in.name, "found a displacement of the prestress that is not finite");
  if (in.lean.rows() != 0 && in.lean.rows() != n)
    refuse(in.name, "found ", in.lean.rows(), " directions of leans, expected one per vertex (", n,
           ")");
  if (!in.lean.allFinite()) refuse(in.name, "found a direction of a lean that is not finite");
  if (!(in.axial_prestretch > 0) || !std::isfinite(in.axial_prestretch))
    refuse(in.name, "axial prestretch = ", in.axial_prestretch, ", expected a positive number");
  for (int i = 0; i < n; ++i)
    if (!(in.thickness[i] > 0) || !std::isfinite(in.thickness[i]))
      refuse(in.name, "vertex ", i, ": thickness = ", in.thickness[i],
             ", expected a positive number");
}

// Scales a symmetric tensor (11, 22, 12) down until no principal value exceeds `limit`.
Vec3 limited(const Vec3& b, double limit) {
  const double mean = (b[0] + b[1]) / 2, spread = std::hypot((b[0] - b[1]) / 2, b[2]);
  const double largest = std::abs(mean) + spread;
  return largest > limit ? Vec3(b * (limit / largest)) : b;
}

// Upper bound on the ratio of the wall's half thickness to the radius of curvature in the thickness
// integral. It acts at creases of a coarse mesh, where the curvature is not meaningful.
constexpr double largest_thickness_ratio = 0.8;

// Smaller shares are rounding errors.
constexpr double least_share = 1e-9;

// Takes the rest data of a triangle to the state from which it is stretched along and across its
// fibre without bending: the curvature keeps its components in the fibre's frame.
void contract(TriangleRest& rest, const Vec2& stretch) {
  const auto dyads = [&] {
    Mat3 columns;
    for (int k = 0; k < 3; ++k) {
      const Vec2 g = rest.gradients.col(k);
      columns.col(k) << g[0] * g[0], g[1] * g[1], g[0] * g[1];
    }
    return columns;
  };
  const Vec3 curvature = dyads() * rest.bending;
  rest.gradients = stretch.asDiagonal() * rest.gradients;
  rest.bending = dyads().inverse() * curvature;
  rest.area /= stretch.prod();
}

// The part of a direction along a triangle, carried to where its sides are d1 and d2.
Vec3 carried(const Vec3& direction, const TriangleSurface& from, int triangle, const Vec3& d1,
             const Vec3& d2) {
  const auto v = from.triangles.row(triangle);
  Eigen::Matrix<double, 3, 2> sides, now;
  for (int k = 0; k < 2; ++k)
    sides.col(k) = (from.points.row(v[k + 1]) - from.points.row(v[0])).transpose();
  now << d1, d2;
  return now * (sides.transpose() * sides).inverse() * (sides.transpose() * direction);
}

}  // namespace

WallInput scaled(WallInput wall, TriangleSurface rest, double length, double stress) {
  wall.rest = std::move(rest);
  wall.thickness /= length;
  wall.mid_offset /= length;
  wall.prestress_displacement /= length;
  for (double* modulus :
       {&wall.material.young_axial, &wall.material.young_transverse, &wall.material.shear_axial})
    *modulus /= stress;
  return wall;
}

WallEnergy::WallEnergy(const WallInput& input)
    : name_(input.name),
      law_(input.material.law),
      vertices_(static_cast<int>(input.rest.points.rows())),
      triangles_(input.rest.triangles) {
  check(input);
  number_edges(input);
  whole_ = part(std::vector<char>(static_cast<size_t>(vertices_), 1));
  set_rest(input);
  set_pattern();
  if (!input.from_stress_free_shape) {
    set_prestress(input);
    return;
  }
  relax_at_rest();
  following_.reset();
}

void WallEnergy::number_edges(const WallInput& input) {
  const auto glued = [&](int v) {
    return !input.glued.empty() && input.glued[static_cast<size_t>(v)] != 0;
  };
  sides_.resize(static_cast<size_t>(triangles_.rows()));
  // The corner of a triangle that is opposite the edge, and whether the triangle traverses the edge
  // from a to b.
  const auto corner = [&](int triangle, int apex) {
    int k = 0;
    while (triangles_(triangle, k) != apex) ++k;
    return k;
  };
  const auto forward = [&](int triangle, int apex, int a) {
    return triangles_(triangle, (corner(triangle, apex) + 1) % 3) == a;
  };
  for (const Edge& edge : edges_of(triangles_)) {
    std::array<int, 2> triangle = edge.triangle, apex = edge.opposite;
    if (!edge.boundary()) {
      const bool first = forward(triangle[0], apex[0], edge.a);
      if (first == forward(triangle[1], apex[1], edge.a))
        refuse(input.name, "triangles ", triangle[0], " and ", triangle[1],
               " are turned against each other, expected one outward orientation");
      if (!first) {
        std::swap(triangle[0], triangle[1]);
        std::swap(apex[0], apex[1]);
      }
    }
    for (size_t w = 0; w < 2 && triangle[w] >= 0; ++w) {
      const int k = corner(triangle[w], apex[w]);
      Sides& sides = sides_[static_cast<size_t>(triangle[w])];
      sides.edge[static_cast<size_t>(k)] = static_cast<int>(edges_.size());
      sides.neighbour[static_cast<size_t>(k)] = apex[1 - w];
      sides.sign[k] = forward(triangle[w], apex[w], edge.a) ? 1 : -1;
    }
    WallEdge e;
    e.a = edge.a;
    e.b = edge.b;
    e.rim = edge.boundary();
    e.glued = e.rim && glued(edge.a) && glued(edge.b);
    edges_.push_back(e);
    edge_triangle_.push_back(triangle);
    edge_apex_.push_back(apex);
    ++(e.glued ? glued_edges_ : free_edges_);
  }
  number_unknowns(input);
}

void WallEnergy::number_unknowns(const WallInput& input) {
  int xi = 3 * vertices_, lean = xi + free_edges_;
  if (!input.lean.isZero(0)) {
    lean_unknown_.assign(static_cast<size_t>(vertices_), -1);
    lean_rest_.assign(static_cast<size_t>(vertices_), 0);
    for (int v = 0; v < vertices_; ++v) {
      if (input.lean.row(v).isZero(0)) continue;
      leans_.push_back({v, lean});
      lean_unknown_[static_cast<size_t>(v)] = lean++;
    }
  }
  int normal = lean;
  for (WallEdge& e : edges_) {
    e.unknown = e.glued ? normal : xi;
    (e.glued ? normal : xi) += e.glued ? 3 : 1;
  }
  rest_.setZero(normal);
}

void WallEnergy::set_rest(const WallInput& input) {
  const bool by_shape = input.from_stress_free_shape;
  sections_.clear();
  lean_directions_.clear();
  TriangleSurface shape = input.rest;  // without stress, but for a stretch along the fibre
  if (by_shape && input.prestress_displacement.rows() > 0)
    shape.points -= input.prestress_displacement;
  for (int i = 0; i < vertices_; ++i) rest_.segment<3>(3 * i) = shape.points.row(i).transpose();
  const Points vertex_normal = vertex_normals(shape);
  triangle_rest_.resize(static_cast<size_t>(triangles_.rows()));
  std::vector<Eigen::Matrix<double, 3, 2>> frame(triangle_rest_.size());
  for (int t = 0; t < triangles_.rows(); ++t) {
    const auto v = triangles_.row(t);
    const Vec3 x0 = point(rest_, v[0]), d1 = point(rest_, v[1]) - x0, d2 = point(rest_, v[2]) - x0;
    const Vec3 area = d1.cross(d2);
    const double longest = std::max({d1.squaredNorm(), d2.squaredNorm(), (d2 - d1).squaredNorm()});
    if (!(area.norm() > 1e-12 * longest))
      refuse(input.name, "triangle ", t, ": area = ", area.norm() / 2,
             ", expected a triangle with an area");
    const Vec3 normal = area.normalized();
    const Vec3& seen_axis = input.axis[static_cast<size_t>(t)];
    const Vec3 axis = by_shape ? carried(seen_axis, input.rest, t, d1, d2) : seen_axis;
    const Vec3 in_plane = axis - axis.dot(normal) * normal;
    if (!(in_plane.norm() > 1e-9 * seen_axis.norm()))
      refuse(input.name, "triangle ", t,
             ": its axis is normal to it, expected one that runs along the wall");
    auto& f = frame[static_cast<size_t>(t)];
    f.col(0) = in_plane.normalized();
    f.col(1) = normal.cross(f.col(0));
    TriangleRest& rest = triangle_rest_[static_cast<size_t>(t)];
    rest.area = area.norm() / 2;
    Eigen::Matrix2d edges;
    edges << f.transpose() * d1, f.transpose() * d2;
    const Eigen::Matrix2d inverse = edges.inverse();
    rest.gradients.col(1) = inverse.row(0).transpose();
    rest.gradients.col(2) = inverse.row(1).transpose();
    rest.gradients.col(0) = -rest.gradients.col(1) - rest.gradients.col(2);
  }
  set_rest_normals(vertex_normal, vertex_normals(input.rest));
  const Vec2 stretch = by_shape ? stretches_along_and_across(input.material, input.axial_prestretch)
                                : Vec2(Vec2::Ones());
  const double thinning = thinning_exponent(input.material) - 1;  // of the thickness with the area
  const Eigen::VectorXd seen_area = triangle_areas(input.rest);
  const Geometry g = geometry(rest_, whole_);
  for (int t = 0; t < triangles_.rows(); ++t) {
    const auto v = triangles_.row(t);
    TriangleRest& rest = triangle_rest_[static_cast<size_t>(t)];
    const auto& f = frame[static_cast<size_t>(t)];
    rest.bending.setZero();  // of another shape
    rest.bending =
        triangle_strains(law_, rest, state(rest_, g, t, deformation(rest_, t))).tail<3>();

    // Gradient of the vertex normals in the frame of the triangle.
    Eigen::Matrix2d turning = Eigen::Matrix2d::Zero();
    double thickness = 0;
    for (int k = 0; k < 3; ++k) {
      turning +=
          f.transpose() * vertex_normal.row(v[k]).transpose() * rest.gradients.col(k).transpose();
      thickness += input.thickness[v[k]] / 3;
    }
    WallSection section;
    section.inner = input.mid_offset - thickness / 2;
    section.outer = input.mid_offset + thickness / 2;
    if (by_shape) {
      // Heights are those of the wall as seen, which is thinner than without stress.
      const double widened = seen_area[t] / rest.area * stretch.prod();
      section.inner /= std::pow(widened, thinning);
      section.outer /= std::pow(widened, thinning);
      contract(rest, stretch);
    }
    const double reach = std::max(std::abs(section.inner), std::abs(section.outer));
    section.curvature = limited({turning(0, 0), turning(1, 1), (turning(0, 1) + turning(1, 0)) / 2},
                                largest_thickness_ratio / reach);
    sections_.push_back(section);
    if (leans_.empty()) continue;
    Eigen::Matrix<double, 2, 3> directions;
    const Vec3 x0 = point(rest_, v[0]), d1 = point(rest_, v[1]) - x0, d2 = point(rest_, v[2]) - x0;
    for (int k = 0; k < 3; ++k) {
      const Vec3 seen = input.lean.row(v[k]);
      const Vec3 d = by_shape ? carried(seen, input.rest, t, d1, d2) : seen;
      const Vec2 in_plane = stretch.cwiseInverse().asDiagonal() * (f.transpose() * d);
      directions.col(k) = in_plane.isZero(0) ? in_plane : in_plane.normalized();
    }
    lean_directions_.push_back(directions);
  }
  for (int i = 0; i < vertices_; ++i)
    rest_.segment<3>(3 * i) = input.rest.points.row(i).transpose();
  set_material(input.material);
}

void WallEnergy::set_material(const Material& material) {
  check_material(material, name_);
  law_ = material.law;
  const Mat3 stiffness = plane_stress(material);
  const Vec2 shear = transverse_shear(material);
  for (size_t t = 0; t < sections_.size(); ++t) {
    WallSection section = sections_[t];
    section.stiffness = stiffness;
    section.shear_modulus = shear;
    TriangleRest& rest = triangle_rest_[t];
    rest.stiffness = triangle_stiffness(rest.gradients, section);
    rest.large.reset();
    rest.leaning.reset();
    if (!lean_directions_.empty() && !lean_directions_[t].isZero(0)) {
      std::array<bool, 3> glued{};
      for (size_t k = 0; k < 3; ++k) {
        glued[k] = edges_[static_cast<size_t>(sides_[t].edge[k])].glued;
        if (!glued[k] || law_ == Law::neo_hookean) continue;
        const Vec2 across = rest.gradients.col(static_cast<int>(k));
        const double length = 2 * rest.area * across.norm();
        rest.stiffness.topLeftCorner<3, 3>() +=
            length * held_thickness(material, section.outer - section.inner, across.normalized());
      }
      rest.leaning = std::make_shared<LeaningTriangle>(
          leaning_triangle(rest.gradients, section, lean_directions_[t], glued));
    }
    if (law_ != Law::neo_hookean) continue;
    const WallPiece piece = wall_piece(rest.gradients, section);
    rest.large = std::make_shared<LargeStrainWall>(
        LargeStrainWall{section.inner, section.outer, section.curvature, material.shear_axial,
                        material.poisson_tt, piece.strains, piece.area});
  }
  set_relief(1 - ordinary_shear(material) / material.shear_axial);
  set_stored();
}

// Reduces the stiffness of partners against a difference of their shears by the fraction `share`;
// the stiffness against their mean shear does not change.
void WallEnergy::set_relief(double share) {
  // Stiffness of y_2 with all other strains free.
  const auto softest = [](const Mat6& k) { return 1 / k.ldlt().solve(Vec6::Unit(2))[2]; };
  for (TriangleRest& rest : triangle_rest_) rest.relief = 0;
  if (share < least_share) return;
  if (partner_.empty())
    partner_ = shear_pairs({Eigen::Map<const Points>(rest_.data(), vertices_, 3), triangles_});
  for (size_t t = 0; t < triangle_rest_.size(); ++t) {
    if (partner_[t] < 0) continue;
    const double mine = softest(triangle_rest_[t].stiffness);
    const double its = softest(triangle_rest_[static_cast<size_t>(partner_[t])].stiffness);
    triangle_rest_[t].relief = share * mine * its / (mine + its);
  }
}

// Normals of the smooth surface on the edges: the mean of the normals at the edge's ends, projected
// into the plane normal to the edge.
// A glued rim has those of the wall as seen, which the section keeps.
void WallEnergy::set_rest_normals(const Points& vertex_normal, const Points& seen_normal) {
  xi_rest_.assign(edges_.size(), 0);
  const Geometry g = geometry(rest_, whole_);
  for (size_t e = 0; e < edges_.size(); ++e) {
    const WallEdge& edge = edges_[e];
    const Vec3 along = (point(rest_, edge.b) - point(rest_, edge.a)).normalized();
    const Points& normal = edge.glued ? seen_normal : vertex_normal;
    const Vec3 mean = (normal.row(edge.a) + normal.row(edge.b)).transpose();
    const Vec3 across = mean - mean.dot(along) * along;
    const Vec3& first = g.normal[static_cast<size_t>(edge_triangle_[e][0])];
    const Vec3 flat =
        edge.rim ? first
                 : (first + g.normal[static_cast<size_t>(edge_triangle_[e][1])]).normalized();
    const double up = across.dot(flat);
    // A fold sharper than a right angle has no smooth normal.
    const bool smooth = up > 0.5 * mean.norm();
    if (edge.glued)
      rest_.segment<3>(edge.unknown) = smooth ? across.normalized() : flat;
    else
      xi_rest_[e] = smooth ? across.dot(along.cross(flat)) / up : 0;
  }
}

}  // namespace vasorod
