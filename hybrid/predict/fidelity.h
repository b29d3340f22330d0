// The fidelities: names of solution methods in scenes, each with the function that solves.
//
// To add one: write its solver in a folder of its own, its function in predict/fidelities/, one
// line in predict/fidelity.cpp, and its page in docs/.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "predict/prediction.h"

namespace vasorod {

/// What encloses the lumen of a fidelity's vessels and carries the stress they were seen with.
enum class LumenOf {
  none,      ///< nothing: scenes with a pressure or an axial prestretch are refused
  rod,       ///< sections of the rods
  sections,  ///< sections of the walls, whose solver makes the stress anew in each of its spaces
  wall,      ///< walls of triangles
};

/// A solution method.
struct Fidelity {
  std::string name;       ///< as in scenes, results and on the command line
  std::string sentence;   ///< what it solves, for --help and the docs
  bool surfaces = true;   ///< false: rods alone; no obstacles, vessels may be bare rods
  bool choosable = true;  ///< false: `accuracy:` never selects it as the fallback
  /// Adds to a prediction whose rods are solved: the vessels' positions and pressures, what was
  /// left out and why, and Prediction::surfaces if the fidelity has energies, forces or a status of
  /// its own.
  std::function<void(Prediction&, const SolveOptions&)> solve;
  LumenOf lumen = LumenOf::none;  ///< takes a pressure in the lumen and an axial prestretch
  bool surgery = true;            ///< takes vessels that are cut, incised and joined
  /// Takes some vessels only, and says where a state is beyond it: `accuracy:` goes on from there.
  bool partial = false;
  /// Solves a Glenn operation with coarser meshes first (predict/coarse_start.h).
  bool coarse_first = false;
};

/// All fidelities, from cheap to expensive.
const std::vector<Fidelity>& fidelities();

/// The fidelity with that name; null if there is none.
const Fidelity* find_fidelity(const std::string& name);

/// The names of those that take vessels which are cut, incised and joined.
std::vector<std::string> fidelities_with_surgery();

/// Adds a fidelity after the existing ones, for programs with their own. Not while a prediction
/// runs.
void register_fidelity(Fidelity fidelity);

}  // namespace vasorod
