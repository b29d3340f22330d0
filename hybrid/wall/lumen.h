// The volume of a vessel's lumen, on which a pressure does work.
//
// The given surface and fans over its open ends enclose V. The inner face lies a depth h below the
// given surface, so that the lumen has
//
//   V_in = V - sum over triangles of h A_0 (A / A_0)^m,   m = 1 - (c_1 + c_2) / 2
//
// where A is a triangle's area (A_0 at rest) and e_3 = -(c_1 e_1 + c_2 e_2) the wall's thinning
// under plane stress. For isotropic walls m = (1 - 2 nu) / (1 - nu): the tissue between surface and
// inner face keeps its volume if nu = 1/2. Without the thinning, a tube would widen too little by a
// share of the order of t / R (Lame's solution). Terms in (h / R)^2 are left out.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// Exponent m of the tissue's volume over a stretched area, from the wall's material.
double thinning_exponent(const Material& material);

/// A fan of triangles over an open end.
struct LumenFan {
  std::vector<int> loop;  ///< as boundary_loops() gives it, from any vertex on
  /// The fan's tip: the centroid of the loop, or its first vertex. With the first vertex, the fans
  /// of two rims that lie on each other cancel if their loops begin at the same place, and the
  /// Hessian stays sparse.
  bool from_first = false;
};

/// The lumen inside one wall. Lengths in the surface's unit.
class Lumen {
 public:
  Lumen() = default;
  /// `depth`: per vertex, from the given surface inwards to the inner face. `fans` close all open
  /// ends.
  Lumen(const TriangleSurface& rest, const Eigen::VectorXd& depth, double thinning,
        std::vector<LumenFan> fans);

  /// V_in, length^3.
  double volume(const Points& x) const;
  /// Adds `factor` dV_in/dx to g and returns V_in.
  double add_gradient(const Points& x, double factor, Points& g) const;
  /// The force of a unit pressure on each vertex through the lid over one end, n x 3, length^2: a
  /// third of each of the fan's triangles' area vectors at each corner. A lid with its tip in the
  /// centroid ends at the inner face.
  Points lid_force(const Points& x, int fan) const;
  /// Adds the lower triangle of `factor` d2V_in/dx2; entry 3 v + c is component c of vertex v, with
  /// `first` added to both indices.
  void add_hessian(const Points& x, double factor, int first,
                   std::vector<Eigen::Triplet<double>>& entries) const;

 private:
  static double add_fan_gradient(const Points& x, const LumenFan& fan, double factor, Points& g);

  Triangles triangles_;
  Eigen::VectorXd depth_;      // per vertex
  Eigen::VectorXd tissue_;     // per triangle: h A_0, length^3
  Eigen::VectorXd rest_area_;  // length^2
  double thinning_ = 1;
  std::vector<LumenFan> fans_;
};

}  // namespace vasorod
