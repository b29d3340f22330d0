// The meshes of a join: both tubes' walls as strips whose lines at rim and slit stand at equal
// shares of arc length, graded towards the slit's tips.
#pragma once

#include <vector>

#include "reference_fem/join_problem.h"
#include "reference_fem/strip_mesh.h"

namespace vasorod::fem {

/// Numbers of cells.
struct JoinCells {
  int seam = 4;    ///< along a quarter of the seam
  int vein = 8;    ///< along the vein
  int around = 8;  ///< around half of the artery; end to end both tubes have those of the seam
  /// Along the artery, from the slit's tips to its ends; end to end: `after` along the second tube.
  int before = 8, after = 8;
  int degree = 3;
  int layers = 0;  ///< of hexahedra through the walls, even; 0: shells
};

/// Cells as large as those of the seam's quarter at the same distance from the tip; their numbers
/// are multiples of `multiple`. `vein` 0: as the others.
JoinCells first_cells(const JoinProblem& problem, int seam, int vein, int multiple);
/// Every number but the layers times a factor.
JoinCells refined(const JoinCells& cells, double factor);

/// A mid-wall node of the vein's rim and the node of the slit's lip at the same share.
struct SeamPair {
  int vein = 0, artery = 0;
  double share = 0;         ///< of the rim's length from the tip at +x
  Vec3 gap = Vec3::Zero();  ///< from the artery's node to the vein's at rest
};

/// The meshes of the part of the join that its planes of symmetry leave.
struct JoinMesh {
  Mesh vein, artery;
  std::vector<SeamPair> seam;  ///< by share
};
JoinMesh make_join_mesh(const JoinProblem& problem, const JoinCells& cells,
                        const Processes& processes = {});

/// The whole meshes of both vessels as they were seen: not cut, the incision closed, of the same
/// part of the planes of symmetry. Where a vessel is kept, its cells are the join's, but for those
/// around an elliptic hole.
JoinMesh make_seen_mesh(const JoinProblem& problem, const JoinCells& cells,
                        const Processes& processes = {});

/// Whether a point of a vessel's strip is in the planes with normal x and y. The artery's incision
/// counts as closed.
std::array<bool, 2> planes_of_vein(const JoinProblem& problem, const Vec3& parameter);
std::array<bool, 2> planes_of_artery(const JoinProblem& problem, const Vec3& parameter);

/// The meshes' lines across the axes, fractions of them.
struct JoinLines {
  std::vector<double> vein, artery;
};
JoinLines join_lines(const JoinProblem& problem, const JoinCells& cells);

/// The point of the modelled part that stands for a point of the whole, and the signs of its
/// components there.
struct Folded {
  Vec3 parameter = Vec3::Zero(), sign = Vec3::Ones();
};
Folded fold_vein(const JoinProblem& problem, double share, double fraction);
Folded fold_artery(const JoinProblem& problem, double share, double fraction);

}  // namespace vasorod::fem
