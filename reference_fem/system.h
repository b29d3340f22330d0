// The discrete equilibrium of a model with its supports: free unknowns, state, residual and
// tangent.
//
// Unknowns: free nodal values (a slave has its master's), then the free pose components of sections
// (increments: translation and spin in the section's rest axes), then six multipliers per soft
// section. Nodes of a rigid section follow its pose. Prescribed motions are therefore plain data,
// and reactions are the consistent residual at the pose.
#pragma once

#include <utility>
#include <vector>

#include "reference_fem/linear_solver.h"
#include "reference_fem/model.h"
#include "reference_fem/section.h"

namespace vasorod::fem {

/// A state of the system.
struct State {
  Eigen::VectorXd u;             ///< every degree of freedom, length
  std::vector<Pose> pose;        ///< per section: rotation R and current centre c
  std::vector<Vec6> multiplier;  ///< per section; zero for rigid ones
};

/// A degree of freedom that follows another: u[slave] = u[master] + load * offset. The master is no
/// slave, the slave is in no section.
struct Tie {
  int slave = 0, master = 0;
  double offset = 0;  ///< at load 1, length
};

/// Supports and loads.
struct Supports {
  std::vector<Section> sections;
  std::vector<Tie> ties;
  /// Degree of freedom, value at load 1 (linear in the load).
  std::vector<std::pair<int, double>> prescribed;
  Eigen::VectorXd dead_load;  ///< per degree of freedom at load 1; empty: none
};

/// A model with its supports.
class System {
 public:
  /// With several processes, each process assembles its own cells. The tangent is then the
  /// process's share; everything else is complete.
  System(const Model& model, Supports supports, const Processes& processes = {});

  const Processes& processes() const { return processes_; }
  const Model& model() const { return model_; }
  const Supports& supports() const { return supports_; }
  int size() const { return size_; }
  bool symmetric() const { return symmetric_; }
  /// Whether an energy exists. The tangent is then symmetric in equilibrium, but not elsewhere.
  bool conservative() const { return conservative_; }
  /// Number of multipliers, the last unknowns.
  int multipliers() const;
  State rest() const;
  /// Makes `state` the equilibrium at load 0: what is out of balance there is a load on the
  /// unknowns that fades with 1 - load. So a path can begin at a vessel as it was seen, whose wall
  /// carried a stress before it was cut or an end was freed.
  void start_from(const State& state);

  /// Sets prescribed values to their values at `load`, members of sections to their pose, slaves
  /// beside their masters.
  void prescribe(State& state, double load) const;
  /// Adds a vector of unknowns.
  void add(State& state, const Eigen::VectorXd& unknowns) const;
  /// The unknowns that take one state to another (spins by the logarithm).
  Eigen::VectorXd difference(const State& from, const State& to) const;

  /// Energy, residual and tangent of a state.
  struct Assembly {
    bool admissible = false;   ///< false: det F <= 0 somewhere
    double energy = 0;         ///< strain energy, stress length^3
    Eigen::VectorXd residual;  ///< of the unknowns, less the fading load of start_from()
    /// Root of the sum over cells of |internal force|^2, at least that of start_from(): a wall may
    /// lose all its stress along the path.
    double scale = 0;
    Sparse tangent;
    /// Force of a section on the model, and moment about its current centre.
    std::vector<Vec6> section_force;
    Eigen::VectorXd nodal;  ///< residual at every degree of freedom (reactions at prescribed ones)
    double relative_residual() const;
  };
  /// With `target`: the residual is extrapolated linearly to the prescribed values of that state (a
  /// tangent predictor).
  void assemble(const State& state, double load, bool want_tangent, Assembly& out,
                const State* target = nullptr) const;

 private:
  void build_numbering();
  void build_pattern();
  void reduced_columns(int cell, std::vector<int>& dofs, std::vector<int>& columns,
                       std::vector<int>& sections) const;
  void add_sections(const State& state, double load, bool want_tangent, Assembly& out) const;

  const Model& model_;
  Supports supports_;
  Processes processes_;
  std::vector<int> index_;                            // per dof: unknown, or -1
  std::vector<char> tied_;                            // per dof: a slave
  std::vector<std::pair<int, int>> member_;           // per dof: (section, member) or (-1, -1)
  std::vector<std::array<int, 6>> pose_index_;        // per section: unknown or -1
  std::vector<std::array<int, 6>> multiplier_index_;  // per section: unknown or -1
  std::vector<std::vector<int>> cell_dofs_;
  Eigen::VectorXd start_load_;  // on the unknowns, times 1 - load; empty: none
  double start_scale_ = 0;      // of the internal forces there
  Sparse pattern_;
  int size_ = 0;
  bool symmetric_ = true, conservative_ = true;
};

}  // namespace vasorod::fem
