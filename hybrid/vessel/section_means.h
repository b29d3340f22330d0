// The rod implied by a deformed surface: each node's pose is the mean pose of its section.
#pragma once

#include <optional>

#include "vessel/vessel.h"

namespace vasorod {

/// `current`: the deformed surface. `near`: poses close to the sections' (the solved rod). `known`:
/// per node, the pose where a rigid section gives it; may be empty.
///
/// A node's section is the band of vertices around it, weighted by their area and a hat function
/// along the axis. In the frames of `near`, the band is brought into one plane. The pose is the
/// least-squares fit of position r and rotation R: r is the weighted mean, R follows from
/// sum A_i (R rho_i) x (x_i - r) = 0. The band averages only the difference to `near`, so the
/// strains between nodes are second-order accurate in its width.
///
/// Within the reach of a fork (fork_reach.h), sections are not whole. The node of the fork follows
/// the wall within its reach on all branches, by the rigid motion that fits it best; the nodes from
/// there to the first whole section follow by interpolation between the two motions.
RodPoses section_means(const Vessel& vessel, const Points& current, const RodPoses& near,
                       const std::vector<std::optional<Pose>>& known,
                       const std::vector<char>& unseen = {});

}  // namespace vasorod
