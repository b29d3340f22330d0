// Elastic energy of one vessel's wall: a shell of flat triangles with an unknown normal on every
// edge.
//
// Unknowns q, in this order:
// - the vertices (x, y, z each, length);
// - one number xi per free edge (no unit);
// - the lean of every vertex that has one (no unit): leaning_triangle.h;
// - the normal m (3 numbers, no unit) of each edge on a glued rim.
//
// The normal of a free edge is
//
//   m = N + (xi + xi0) (e x N)
//
// with N the unit bisector of its triangles' normals (on a rim, the normal of the one triangle), e
// directed from the edge's lower vertex to the higher, and xi0 chosen so that at rest (xi = 0) m is
// the normal of the smooth surface, or, of a wall from its shape without stress, that of which the
// edge is in equilibrium. The normals of a glued rim belong to a rigid section; the code
// that moves the section sets m = R m_rest. Strains, bending and stiffness: triangle_energy.h,
// wall_section.h.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <string>
#include <vector>

#include <vasorod/types.h>

#include "wall/hinge.h"
#include "wall/plane_stress.h"
#include "wall/triangle_energy.h"
#include "wall/wall_section.h"

namespace vasorod {

class BlockPattern;

/// A wall at rest, free of stress unless a prestress is given. Lengths in one unit, moduli in one
/// unit.
struct WallInput {
  TriangleSurface rest;       ///< the given surface, outward orientation
  Eigen::VectorXd thickness;  ///< per vertex
  double mid_offset = 0;      ///< from the given surface along its outward normal to mid-wall
  std::vector<Vec3> axis;     ///< per triangle: the fibre, any length, not normal to the triangle
  Material material;
  std::vector<char> glued;  ///< per vertex: on a rigid section; empty: none
  /// The wall at rest carries the stress of this displacement u, n x 3, length; empty: none.
  Points prestress_displacement;
  double axial_prestretch = 1;  ///< and that of this stretch along the fibre
  /// Whether u leads from the shape without stress to `rest`; else the stress is linear in u.
  bool from_stress_free_shape = false;
  /// Per vertex the direction in which its director may lean, of any length, zero where it may not
  /// (shear_band.h); n x 3; empty: nowhere.
  Points lean;
  std::string name = "wall";  ///< begins the sentence of an error
};

/// The wall in other units: lengths but those of `rest` divided by `length`, moduli by `stress`.
/// Its rest surface becomes `rest`, which is in these units.
WallInput scaled(WallInput wall, TriangleSurface rest, double length, double stress);

/// An edge and the position of its unknown in q.
struct WallEdge {
  int a = 0, b = 0;  ///< a < b
  bool rim = false;
  bool glued = false;  ///< a rim between glued vertices: its normal is the unknown; else xi
  int unknown = 0;
};

/// A vertex whose director may lean, and the position of its unknown in q.
struct WallLean {
  int vertex = 0;
  int unknown = 0;
  bool operator==(const WallLean&) const = default;
};

/// The least and the largest principal stretch of a wall's two faces, and where on the given
/// surface.
struct FaceExtremes : FaceStretches {
  Vec3 least_place = Vec3::Zero(), largest_place = Vec3::Zero();
};

/// What the energy of a wall has to do with some of its vertices. Ascending.
struct WallPart {
  std::vector<int> triangles;  ///< those whose energies depend on the vertices
  std::vector<int> seen;       ///< those and the ones across their edges
  std::vector<int> edges;      ///< of `triangles`
};

/// Energies, strains and stresses of the wall in one state.
struct WallReport {
  /// Their sum is the wall's energy; shear across the wall is part of `bending`.
  double membrane = 0, bending = 0, coupling = 0;
  /// Per triangle, in the frame (fibre, across): strain of the given surface (11, 22, 2*12); change
  /// of the second fundamental form (1/length); the conjugate stress resultants per rest area
  /// (force/length, force). Both count from the shape without stress, if the wall is from one.
  std::vector<Vec3> strain, bend, force, moment;
  double sharpest_fold = 0;  ///< angle between two triangles, radians
  Vec3 fold_place = Vec3::Zero();
  FaceExtremes faces;
};

/// The energy of one wall with gradient and Hessian as functions of q.
class WallEnergy {
 public:
  /// Throws InputError (one sentence) when the input is invalid.
  explicit WallEnergy(const WallInput& input);

  /// The same wall with another stress at rest: of `input`, only its prestress_displacement and
  /// axial_prestretch may differ from the constructor's, and both must be from_stress_free_shape.
  /// Throws InputError where a triangle of that shape has no area, or edges cannot be brought from
  /// it to rest; this must not be used then.
  void set_stress_free_shape(const WallInput& input);

  int vertices() const { return vertices_; }
  int free_edges() const { return free_edges_; }
  int glued_edges() const { return glued_edges_; }
  int unknowns() const { return static_cast<int>(rest_.size()); }
  const std::vector<WallEdge>& edges() const { return edges_; }  ///< sorted by (a, b)
  const std::vector<WallLean>& leans() const { return leans_; }  ///< sorted by vertex

  /// RMS over the rest area of the prestress's strain of the given surface, sqrt(e_11^2 + e_22^2 +
  /// 2 e_12^2); zero from_stress_free_shape.
  double rms_prestrain() const;

  /// q at rest, the given surface: without a prestress, energy and gradient are zero.
  const Eigen::VectorXd& rest() const { return rest_; }

  /// The energy at q, force * length.
  double value(const Eigen::VectorXd& q) const;
  /// Returns the energy and writes its gradient with respect to q (size unknowns()).
  double gradient(const Eigen::VectorXd& q, Eigen::VectorXd& g) const;
  /// The Hessian, lower triangle, compressed. The pattern never changes; the values are overwritten
  /// in place. `second`: not `none`; `convex`: only a part of it that is positive semidefinite
  /// (triangle_energy.h).
  const Eigen::SparseMatrix<double>& hessian(const Eigen::VectorXd& q,
                                             SecondDerivatives second = SecondDerivatives::all);

  /// The pattern of hessian(), known without evaluating it; the values are whatever they are.
  const Eigen::SparseMatrix<double>& pattern() const { return hessian_; }

  /// The part around the vertices that are marked. `vertices`: per vertex.
  WallPart part(const std::vector<char>& vertices) const;
  /// The same from a part alone: the energy of its triangles, in which the derivatives with respect
  /// to the marked vertices, their leans and the normals of their edges are complete. The others
  /// are not those of any energy.
  double gradient(const Eigen::VectorXd& q, Eigen::VectorXd& g, const WallPart& part) const;
  const Eigen::SparseMatrix<double>& hessian(const Eigen::VectorXd& q, const WallPart& part,
                                             SecondDerivatives second = SecondDerivatives::all);

  /// Replaces the material of the wall. The pattern, the rest state, all unknowns and a linear
  /// prestress stay; a shape without stress does too, and the prestress from it follows.
  void set_material(const Material& material);

  /// Energies, strains and stresses at q.
  WallReport report(const Eigen::VectorXd& q) const;

 private:
  // The edge opposite each vertex of a triangle, and the direction in which the triangle traverses
  // it.
  struct Sides {
    // neighbour: the vertex across the edge, -1 at a rim.
    std::array<int, 3> edge{}, neighbour{};
    Vec3 sign;  // +1: from the edge's lower vertex to its higher
  };
  // Normals of all triangles and angles of all edges.
  struct Geometry {
    std::vector<Vec3> normal;  // unit, per triangle
    std::vector<double> area2;
    std::vector<double> half_sine, half_cosine;  // per edge
  };
  using Deformation = Eigen::Matrix<double, 3, 2>;

  Vec3 point(const Eigen::VectorXd& q, int vertex) const { return q.segment<3>(3 * vertex); }
  // Of what `part` needs; the rest is not computed.
  Geometry geometry(const Eigen::VectorXd& q, const WallPart& part) const;
  Deformation deformation(const Eigen::VectorXd& q, int triangle) const;
  TriangleState state(const Eigen::VectorXd& q, const Geometry& g, int triangle,
                      const Deformation& f) const;
  // The hinge of an inner edge seen from its triangle 0 or 1.
  HingeSide side(const Eigen::VectorXd& q, const Geometry& g, int edge, int which) const;

  void number_edges(const WallInput& input);
  void number_unknowns(const WallInput& input);
  void set_rest(const WallInput& input);
  void set_rest_normals(const Points& vertex_normal, const Points& seen_normal);
  void set_pattern();
  void couple_leans(int first_lean, BlockPattern& pattern);
  void place_leans(const BlockPattern& pattern);
  void set_relief(double share);
  void set_prestress(const WallInput& input);
  void relax_at_rest();
  void set_stored();
  // Per triangle the derivative of y at q in the direction `change`.
  std::vector<Vec6> strain_change(const Eigen::VectorXd& q, const Eigen::VectorXd& change) const;
  void see_faces(const Eigen::VectorXd& q, int triangle, const Vec3& bend,
                 FaceExtremes& extremes) const;
  // Parts of the Hessian.
  struct TriangleDerivatives;
  TriangleDerivatives derivatives(const Eigen::VectorXd& q, const Geometry& g, int triangle,
                                  const Deformation& f) const;
  void add_triangle(size_t triangle, const TriangleEnergy& e, const TriangleDerivatives& d,
                    SecondDerivatives second, double* values) const;
  void add_leans(size_t triangle, const TriangleEnergy& e, const TriangleDerivatives& d,
                 double* values) const;
  void add_hinges(const Eigen::VectorXd& q, const Geometry& g, const WallPart& part,
                  const std::vector<double>& by_angle, double* values) const;
  void add_partners(const Eigen::VectorXd& q, const WallPart& part, double* values) const;

  std::string name_;
  Law law_;
  int vertices_ = 0, free_edges_ = 0, glued_edges_ = 0;
  Triangles triangles_;
  std::vector<WallEdge> edges_;
  std::vector<std::array<int, 2>> edge_triangle_, edge_apex_;
  std::vector<double> xi_rest_;  // per edge
  std::vector<WallLean> leans_;
  std::vector<double> lean_rest_;  // per vertex, as lean_unknown_: of the given surface
  // Of the unknowns that follow the vertices; kept from shape to shape.
  std::shared_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> following_;
  std::vector<int> lean_unknown_;  // per vertex: in q, -1: none; empty if no vertex has a lean
  // Per triangle: the directions of its vertices' leans in its frame; empty if there are none.
  std::vector<Eigen::Matrix<double, 2, 3>> lean_directions_;
  std::vector<Sides> sides_;
  WallPart whole_;  // of all vertices
  std::vector<TriangleRest> triangle_rest_;
  std::vector<int> partner_;  // per triangle, shear_pairs.h; empty until a material needs it
  std::vector<WallSection> sections_;  // geometry only; set_material() adds the material
  Eigen::VectorXd rest_;
  Eigen::SparseMatrix<double> hessian_;
  // Per triangle: its nodes (its vertices, the nodes across its edges, the xi of its edges; -1:
  // none) and the position of each pair's block in the matrix.
  struct Places {
    std::array<int, 9> node{};
    std::array<int, 45> place{};
  };
  std::vector<Places> places_;
  // Per triangle: the nodes of its vertices' leans (-1: none) and, per lean, the position of its
  // block with each of the nine nodes and the three leans. Empty if there are no leans.
  struct LeanPlaces {
    std::array<int, 3> node{};
    std::array<std::array<int, 12>, 3> place{};
  };
  std::vector<LeanPlaces> lean_places_;
  std::vector<int> node_stride_, node_unknown_;
};

}  // namespace vasorod
