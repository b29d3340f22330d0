// The seam of a surface problem: pairs of vertices as springs between stacked unknowns
// (joining_energy.h).
#pragma once

#include "bodies/joining_energy.h"
#include "bodies/scaled_bodies.h"

namespace vasorod {

/// Throws InputError where a pair names a vertex that does not exist.
void check_seams(const std::vector<SeamPair>& seams, const ScaledBodies& scaled);

/// Radius of the mouth: RMS distance of its rest vertices from their mean, scaled length; 0 without
/// a seam.
double mouth_radius(const std::vector<SeamPair>& seams, const ScaledBodies& scaled);

/// k_j: `factor` times the largest k_b or k_s of the joined bodies, scaled stiffness; 0 without a
/// seam.
double joining_stiffness(const std::vector<SeamPair>& seams, const ScaledBodies& scaled,
                         double factor);

/// The pairs in the numbering of the stack. `first` is the first row of each body in the stack;
/// `multipliers` has one entry per pair.
std::vector<Join> stacked_joins(const std::vector<SeamPair>& seams, const std::vector<int>& first,
                                const std::vector<Vec3>& multipliers);

/// Largest distance between the two vertices of a pair, in the units of p; 0 without a seam.
double largest_gap(const std::vector<Join>& joins, const Eigen::Ref<const Points>& p);

}  // namespace vasorod
