// What became of a solve: one enumeration for every solver, from good to bad.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

namespace vasorod {

enum class Status {
  converged,         ///< equilibrium; where a certificate was asked for, a stable minimum
  equilibrium_only,  ///< equilibrium; not a certified minimum (a dead moment has no energy)
  unstable,          ///< equilibrium with a direction of negative curvature that could not be left
  buckled,           ///< the branch from rest lost its stability; this is the minimum below it
  not_unique,        ///< equilibrium with a direction along which the energy does not change
  iteration_limit,   ///< no equilibrium found; this is the best state seen
  interrupted        ///< stopped by the caller or the time limit; this is the best state seen
};

/// The name that result.json has for a status.
std::string to_string(Status status);

/// The status of that name; empty where there is none.
std::optional<Status> status_named(const std::string& name);

/// Whether a solve ended without an equilibrium: what came of it is the best state seen.
inline bool is_unfinished(Status status) {
  return status == Status::iteration_limit || status == Status::interrupted;
}

/// The worse of two: a whole is as good as its worst part.
inline Status worse(Status a, Status b) {
  return std::max(a, b);
}

}  // namespace vasorod
