// Open ends of a surface closed by fans around their centroids.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// The points, then the centroid of each loop.
Points with_centroids(const Points& points, const std::vector<std::vector<int>>& loops);

/// The triangles, then the fans of the loops in their order, one triangle per edge of a loop,
/// around the centroids that follow `vertices` points. Loops as boundary_loops() gives them; the
/// fans then face outwards as the surface does.
Triangles with_fans(const Triangles& triangles, const std::vector<std::vector<int>>& loops,
                    Eigen::Index vertices);

}  // namespace vasorod
