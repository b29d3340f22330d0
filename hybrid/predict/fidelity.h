// The fidelities: names under which scenes ask for a way of solving, each with the function that
// does it.
//
// To add one: write its solver in a folder of its own, its function in predict/fidelities/, one
// line in predict/fidelity.cpp, its name in schema/scene.schema.json, and its page in docs/.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "predict/prediction.h"

namespace vasorod {

struct Fidelity {
  std::string name;      ///< as scenes, results and the command line have it
  std::string sentence;  ///< what it solves, for --help and the docs
  bool surfaces = true;  ///< false: rods alone; obstacles are left out and vessels may be bare rods
  bool choosable = true;  ///< false: `accuracy:` never falls back to it
  /// Adds to a prediction whose rods are solved: the vessels' positions and pressures, what was
  /// left out and why, and Prediction::surfaces where it has energies, forces or a status of its
  /// own.
  std::function<void(Prediction&, const SolveOptions&)> solve;
};

/// All of them, from cheap to expensive.
const std::vector<Fidelity>& fidelities();

/// The fidelity of that name; null where there is none.
const Fidelity* find_fidelity(const std::string& name);

/// Adds one after those there are. For programs that bring their own; not while a prediction runs.
void register_fidelity(Fidelity fidelity);

}  // namespace vasorod
