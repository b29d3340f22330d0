// The one energy of `coupled`: walls, the sections that hold or load them, seams and contacts, in
// the unknowns that are left free. Scaled units throughout (bodies/scaled_bodies.h).
//
// Unknowns z, wall by wall: [positions of vertices on no rigid section; xi per free-normal edge;
// poses of the sections that are not fixed]. What a rigid section holds follows its pose: x = r + R
// rho, m = R m_rest.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bodies/contact_energy.h"
#include "bodies/joining_energy.h"
#include "coupled/group_turns.h"
#include "coupled/section_tie.h"
#include "wall/wall_energy.h"

namespace vasorod {

/// One wall's place in the system.
struct CoupledWall {
  WallEnergy* energy = nullptr;
  Points rest;
  std::vector<SectionPose> sections;
  std::vector<std::optional<SectionTie>> ties;  ///< per section; none on a rigid one
  int first_vertex = 0;                         ///< row of its vertex 0 in the stacked positions
  std::vector<int> unknown;       ///< per entry of q: its index in z, -1 on a rigid section
  std::vector<int> pose_unknown;  ///< per section: its first index in z
  /// A vertex or rim normal that a rigid section carries: three entries of q from `entry` on.
  struct Carried {
    int entry = 0, section = 0;
    bool normal = false;
    Vec3 arm = Vec3::Zero();  ///< at rest, from the section's point; a normal's rest value
  };
  std::vector<Carried> carried;
  std::vector<int> carried_at;  ///< per entry of q: 3 * index into `carried` + component, -1
};

/// Where everything is.
struct CoupledState {
  std::vector<Eigen::VectorXd> q;                         ///< per wall
  std::vector<std::vector<SectionPlacement>> placements;  ///< per wall and section
  Points positions;                                       ///< stacked
};

struct CoupledTerms {
  double wall = 0, joining = 0, contact = 0, ties = 0, load = 0;
  double total() const { return wall + joining + contact + ties + load; }
};

/// The gradients of the energy's parts before sections gather them.
struct CoupledForces {
  std::vector<Eigen::VectorXd> wall;  ///< per wall, with respect to q
  std::vector<std::vector<Vec6>>
      pose;  ///< per wall and section: loads and ties, with respect to its unknowns
  Points joining, contact, ties;  ///< with respect to the stacked positions
};

/// What one entry of q depends on: itself where it is free, else the unknowns of the pose that
/// carries it.
struct Reach {
  int count = 0;
  std::array<int, 6> unknown{};
  std::array<double, 6> factor{};
};

class CoupledSystem {
 public:
  /// Adds a wall, whose energy must outlive this; returns its index. `tie_stiffness`: of soft
  /// sections.
  int add_wall(WallEnergy& energy, const Points& rest, const std::vector<HeldSection>& sections,
               double tie_stiffness);
  /// Numbers the Hessian's pattern. After the last wall.
  void finish();

  int unknowns() const { return unknowns_; }
  int vertex_count() const { return vertices_; }
  const std::vector<CoupledWall>& walls() const { return walls_; }
  /// First index of each group of unknowns that belong together (a vertex, an edge, a pose).
  const std::vector<int>& groups() const { return groups_; }

  std::vector<Join> joins;  ///< numbered in the stacked positions
  double k_j = 0;
  std::vector<ContactPoint> contacts;

  /// Motions and loads at time t.
  void set_time(double t);
  /// A section that is fixed altogether stands there (rotation from rest), until the next set_time.
  void set_target(int wall, int section, const Pose& pose);
  /// SectionPose::recentre for all sections; the largest change.
  double recentre(Eigen::VectorXd& z);
  /// Soft sections' multipliers.
  void update_ties(const Eigen::VectorXd& z);
  double worst_tie(const Eigen::VectorXd& z) const;
  bool has_ties() const;

  /// Takes one wall's positions into z; xi of its edges becomes 0 unless kept.
  void put(int wall, const Points& x, bool keep_edges, Eigen::VectorXd& z);
  /// Takes a section's pose (rotation from rest) into z, as far as it is free.
  void put_pose(int wall, int section, const Mat3& rotation, const Vec3& position,
                Eigen::VectorXd& z);

  /// Takes a wall's xi from a configuration.
  void put_edges(int wall, const Eigen::VectorXd& q, Eigen::VectorXd& z);

  /// Other motions and loads for a wall's sections; rings and fixed freedoms stay.
  void set_sections(int wall, const std::vector<HeldSection>& sections);
  /// Another energy on the same triangles.
  void set_energy(int wall, WallEnergy& energy);
  /// Whether every load has an energy.
  bool has_potential() const;
  /// Largest force or moment now that loads what can move, force or force times length.
  double largest_load() const;
  /// Largest moment of a load, force times length.
  double largest_moment() const;

  CoupledState state(const Eigen::VectorXd& z) const;

  /// The energy; its gradient with respect to z, and where asked what it is gathered from.
  CoupledTerms gradient(const Eigen::VectorXd& z, Eigen::VectorXd& g,
                        CoupledForces* forces = nullptr) const;
  /// All of them on one wall's q.
  Eigen::VectorXd total_force(size_t wall, const CoupledForces& f) const;
  /// The Hessian, lower triangle.
  Eigen::SparseMatrix<double> hessian(const Eigen::VectorXd& z);
  /// The walls' Hessian at rest.
  Eigen::SparseMatrix<double> rest_hessian();
  /// The rotations that bring the rest Hessian into present frames: per stacked vertex, per wall
  /// and section.
  GroupTurns turns(const std::vector<Mat3>& frames,
                   const std::vector<std::vector<Mat3>>& section_frames) const;

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  void evaluate(const CoupledState& s, const Eigen::VectorXd& z, CoupledForces& f,
                CoupledTerms& terms) const;
  Eigen::SparseMatrix<double> with_extra(const Entries& extra) const;
  static void scatter(const Reach& p, const Reach& q, bool diagonal, double value, Entries& extra);
  void add_wall_hessian(size_t wall, const Eigen::SparseMatrix<double>& h, const CoupledState& s,
                        Entries& extra);
  void add_pose_curvature(const CoupledState& s, const CoupledForces& f, Entries& extra) const;
  void add_ties(const CoupledState& s, Entries& extra) const;
  void add_meetings(const CoupledState& s, Entries& extra) const;

  std::vector<CoupledWall> walls_;
  std::vector<int> wall_of_;  // per stacked vertex
  int unknowns_ = 0, vertices_ = 0;
  std::vector<int> groups_;
  // The walls' Hessian between free entries: fixed pattern, and per wall where each of its own
  // entries goes.
  Eigen::SparseMatrix<double> base_;
  std::vector<std::vector<int>> slot_;  // -1: not between free entries
};

}  // namespace vasorod
