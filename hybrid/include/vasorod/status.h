// The outcome of a solve: one enumeration for all solvers, from best to worst.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

namespace vasorod {

/// The outcome of a solve, from best to worst.
enum class Status {
  converged,          ///< equilibrium; where a certificate was requested, a stable minimum
  equilibrium_only,   ///< equilibrium, not a certified minimum (a dead moment has no energy)
  unstable,           ///< equilibrium with a direction of negative curvature that could not be left
  buckled,            ///< the branch from rest lost its stability; this is the minimum below it
  not_unique,         ///< equilibrium with a direction along which the energy does not change
  self_intersecting,  ///< equilibrium whose walls pass through themselves or each other
  iteration_limit,    ///< no equilibrium found; this is the best state seen
  interrupted         ///< stopped by the caller or the time limit; this is the best state seen
};

/// The status's name in result.json.
std::string to_string(Status status);

/// The status with that name; empty if there is none.
std::optional<Status> status_named(const std::string& name);

/// Whether a solve ended without an equilibrium, so that its result is the best state seen.
inline bool is_unfinished(Status status) {
  return status == Status::iteration_limit || status == Status::interrupted;
}

/// Whether the vessels would stay in the state. They would not in the state of an unfinished solve,
/// nor in an equilibrium that is unstable; peaks and fields of such a state say nothing.
inline bool is_solution(Status status) {
  return !is_unfinished(status) && status != Status::unstable;
}

/// The worse of two statuses. The status of a whole is the worst of its parts.
inline Status worse(Status a, Status b) {
  return std::max(a, b);
}

}  // namespace vasorod
