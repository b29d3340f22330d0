// How much a solver did, in numbers that depend on the machine by rounding alone.
#pragma once

#include <algorithm>
#include <cstdint>

namespace vasorod {

/// How much a solver did.
struct Counts {
  int factorisations = 0,  ///< numerical factorisations, those that met a negative pivot too
      solves = 0,          ///< solves with a factor; several right-hand sides at once are one
      gradients = 0,       ///< evaluations of the energy with its gradient
      hessians = 0,        ///< assembled matrices: Hessians, and matrices in their place
      outer = 0;           ///< minimisations, between which multipliers and contacts change
  std::int64_t factor_nonzeros = 0;  ///< entries of the largest factor

  /// Adds what was done elsewhere; of the factors the largest counts.
  Counts& operator+=(const Counts& other) {
    factorisations += other.factorisations;
    solves += other.solves;
    gradients += other.gradients;
    hessians += other.hessians;
    outer += other.outer;
    factor_nonzeros = std::max(factor_nonzeros, other.factor_nonzeros);
    return *this;
  }
  bool operator==(const Counts&) const = default;  ///< whether all counts are the same
};

}  // namespace vasorod
