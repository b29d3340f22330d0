// The total energy of `coupled`: walls, the sections that hold or load them, seams and contacts, as
// a function of the free unknowns. Scaled units throughout (bodies/scaled_bodies.h).
//
// Unknowns z, wall by wall:
// - positions of the vertices on no rigid section;
// - xi per edge with a free normal;
// - the lean of each vertex that has one;
// - poses of the sections that are not fixed.
//
// Vertices and rim normals of a rigid section follow its pose:
//
//   x = r + R rho,   m = R m_rest
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/crossing_guard.h"
#include "bodies/joining_energy.h"
#include "coupled/group_turns.h"
#include "coupled/section_tie.h"
#include "wall/lumen.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// The lumen of one wall under pressure. The energy is -p V.
struct WallLumen {
  /// What is behind a fan: the index of a section, or one of these.
  static constexpr int free_end = -1, seam = -2;

  Lumen volume;
  std::vector<int> behind_fan;  ///< per fan of `volume`
  double scan = 0, after = 0;   ///< pressure at times 0 and 1
  double inflation = 0;         ///< pressure that is added while the walls are inflated
  double now = 0;               ///< at the present time
};

/// A wall of which only a patch moves.
struct WallPatch {
  std::vector<char> moves;  ///< per vertex: with its leans and the normals of its edges
  Eigen::VectorXd held;     ///< q, of which the rest stays
};

/// One wall in the system.
struct CoupledWall {
  WallEnergy* energy = nullptr;
  Points rest;
  std::vector<SectionPose> sections;
  std::vector<std::optional<SectionTie>> ties;  ///< per section; none for a rigid one
  std::optional<WallLumen> lumen;
  std::shared_ptr<CrossingGuard> guard;  ///< that keeps it from passing through itself; may be none
  int first_vertex = 0;                  ///< row of its vertex 0 in the stacked positions
  std::optional<WallPart> part;          ///< that is evaluated; none: all
  Eigen::VectorXd held;                  ///< q outside of a patch; empty: none
  /// Per entry of q: its index in z, -1 on a rigid section and outside of a patch.
  std::vector<int> unknown;
  std::vector<int> pose_unknown;  ///< per section: its first index in z
  /// A vertex or rim normal that follows a rigid section: three entries of q from `entry` on.
  struct Carried {
    int entry = 0, section = 0;
    bool normal = false;
    Vec3 arm = Vec3::Zero();  ///< at rest, from the section's point; a normal's rest value
  };
  std::vector<Carried> carried;
  /// Per entry of q: 3 * index into `carried` + component; -1: none.
  std::vector<int> carried_at;
};

/// Configuration of all walls and sections.
struct CoupledState {
  std::vector<Eigen::VectorXd> q;                         ///< per wall
  std::vector<std::vector<SectionPlacement>> placements;  ///< per wall and section
  Points positions;                                       ///< stacked
};

/// Energy term by term, force * length.
struct CoupledTerms {
  double wall = 0, joining = 0, contact = 0, ties = 0, load = 0, pressure = 0;
  double total() const { return wall + joining + contact + ties + load + pressure; }
};

/// Gradients of the parts of the energy, before the sections collect them.
struct CoupledForces {
  std::vector<Eigen::VectorXd> wall;  ///< per wall, with respect to q
  /// Per wall and section: loads and ties, with respect to the pose's unknowns.
  std::vector<std::vector<Vec6>> pose;
  /// With respect to the stacked positions; `guard`: what is kept from touching itself.
  Points joining, contact, guard, ties, pressure;
};

/// Dependence of one entry of q on the unknowns: itself if it is free, the unknowns of the pose
/// that moves it, or none.
struct Reach {
  int count = 0;
  std::array<int, 6> unknown{};
  std::array<double, 6> factor{};
};

/// The energy of all walls with gradient and Hessian with respect to z.
class CoupledSystem {
 public:
  /// Adds a wall and returns its index. `energy` must outlive this. `tie_stiffness`: of soft
  /// sections, force / length. Of a `patch`, whose sections must have no free poses, the energy is
  /// that of what depends on it.
  int add_wall(WallEnergy& energy, const Points& rest, const std::vector<HeldSection>& sections,
               double tie_stiffness, const WallPatch* patch = nullptr);
  /// The pressure in the lumen of a wall, which every section then feels as a lid.
  void set_lumen(int wall, WallLumen lumen);
  void set_guard(int wall, std::shared_ptr<CrossingGuard> guard);
  bool guarded() const;
  /// The longest share, in (0, 1], of a step along `direction` on which no guarded wall passes
  /// through itself.
  double longest_share(const Eigen::VectorXd& z, const Eigen::VectorXd& direction) const;
  double longest_share(const Points& from, const Points& to) const;  ///< of stacked positions
  /// Builds the pattern of the Hessian. Call after the last wall.
  void finish();

  int unknowns() const { return unknowns_; }
  int vertex_count() const { return vertices_; }
  const std::vector<CoupledWall>& walls() const { return walls_; }
  /// First index of each group of unknowns (a vertex, an edge, a pose).
  const std::vector<int>& groups() const { return groups_; }

  std::vector<Join> joins;  ///< numbered in the stacked positions
  double k_j = 0;
  std::vector<ContactPoint> contacts;

  /// Sets motions and loads to time t.
  void set_time(double t);
  /// Sets the share (0 to 1) of WallLumen::inflation that is in the lumens.
  void set_inflation(double share);
  /// Sets the pose of a section with six fixed freedoms (rotation from rest), until the next
  /// set_time().
  void set_target(int wall, int section, const Pose& pose);
  /// SectionPose::recentre() for all sections; returns the largest change.
  double recentre(Eigen::VectorXd& z);
  /// Updates the multipliers of soft sections.
  void update_ties(const Eigen::VectorXd& z);
  /// Largest SectionTie::relative_misfit().
  double worst_tie(const Eigen::VectorXd& z) const;
  bool has_ties() const;

  /// Copies the positions of one wall into z; xi of its edges and its leans become 0 unless
  /// `keep_edges`.
  void put(int wall, const Points& x, bool keep_edges, Eigen::VectorXd& z);
  /// Copies the pose of a section (rotation from rest) into z, as far as it is free.
  void put_pose(int wall, int section, const Mat3& rotation, const Vec3& position,
                Eigen::VectorXd& z);

  /// Copies the xi and the leans of a wall from its configuration q into z.
  void put_edges(int wall, const Eigen::VectorXd& q, Eigen::VectorXd& z);

  /// Replaces the motions and loads of a wall's sections; rings and fixed freedoms stay.
  void set_sections(int wall, const std::vector<HeldSection>& sections);
  /// Replaces the energy of a wall; the triangles and the leaning vertices stay.
  void set_energy(int wall, WallEnergy& energy);
  /// Whether every load has a potential.
  bool has_potential() const;
  /// Largest present force or moment that loads a free freedom; force, or force times length.
  double largest_load() const;
  /// Largest moment of a load, force times length.
  double largest_moment() const;

  CoupledState state(const Eigen::VectorXd& z) const;

  /// The energy and its gradient with respect to z; if requested, also the gradients of its parts.
  CoupledTerms gradient(const Eigen::VectorXd& z, Eigen::VectorXd& g,
                        CoupledForces* forces = nullptr) const;
  /// Sum of all parts on q of one wall.
  Eigen::VectorXd total_force(size_t wall, const CoupledForces& f) const;
  /// The Hessian, lower triangle. `second`: not `none`; `convex`: only a part of it that is
  /// positive semidefinite: of the walls that of triangle_energy.h, of loads that turn with their
  /// section and of pressure nothing.
  Eigen::SparseMatrix<double> hessian(const Eigen::VectorXd& z,
                                      SecondDerivatives second = SecondDerivatives::all);
  /// What ties, seams and contacts add to it.
  Eigen::SparseMatrix<double> meeting_hessian(const Eigen::VectorXd& z) const;
  /// The walls' Hessian at rest.
  Eigen::SparseMatrix<double> rest_hessian();
  /// The rotations that transform the rest Hessian to the present frames. `frames`: per stacked
  /// vertex; `section_frames`: per wall and section.
  GroupTurns turns(const std::vector<Mat3>& frames,
                   const std::vector<std::vector<Mat3>>& section_frames) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  void evaluate(const CoupledState& s, const Eigen::VectorXd& z, CoupledForces& f,
                CoupledTerms& terms) const;
  void evaluate_wall(size_t wall, const CoupledState& s, const Eigen::VectorXd& z, CoupledForces& f,
                     CoupledTerms& terms) const;
  Eigen::SparseMatrix<double> with_extra(const Entries& extra) const;
  static void scatter(const Reach& p, const Reach& q, bool diagonal, double value, Entries& extra);
  void add_wall_hessian(size_t wall, const Eigen::SparseMatrix<double>& h, const CoupledState& s,
                        Entries& extra);
  void add_wall_hessians(const CoupledState& s, SecondDerivatives second, Entries& extra);
  void add_pose_curvature(const CoupledState& s, const CoupledForces& f, Entries& extra) const;
  void add_ties(const CoupledState& s, Entries& extra) const;
  void set_pressures();
  // Adds -p V''; `at_rest`: with the pressure of time 0.
  void add_lumens(const CoupledState& s, bool at_rest, Entries& extra) const;
  void add_stacked(const Entries& stacked, const CoupledState& s, Entries& extra) const;
  // `blend`: of CrossingGuard::hessian().
  void add_meetings(const CoupledState& s, double blend, Entries& extra) const;

  std::vector<CoupledWall> walls_;
  std::vector<int> wall_of_;  // per stacked vertex
  int unknowns_ = 0, vertices_ = 0;
  double time_ = 0, inflation_ = 0;
  std::vector<int> groups_;
  // The walls' Hessian between free entries: its fixed pattern, and per wall the position of each
  // of its own entries.
  Eigen::SparseMatrix<double> base_;
  std::vector<std::vector<int>> slot_;  // -1: not between free entries
};

}  // namespace vasorod
