// The umbrella Laplacian of a surface: l(p)_i is the mean of the neighbours of i, minus p_i. l = 0
// at vertices without neighbours.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "geometry/triangle_surface.h"

namespace vasorod {

/// The umbrella Laplacian as the neighbours of every vertex in compressed rows.
class Umbrella {
 public:
  Umbrella() = default;
  Umbrella(const std::vector<Edge>& edges, int vertex_count);

  int vertex_count() const { return static_cast<int>(first_.size()) - 1; }
  /// l(p), n x 3.
  Points apply(const Eigen::Ref<const Points>& points) const;
  /// out += factor * L^T field.
  void add_transpose(const Eigen::Ref<const Points>& field, double factor,
                     Eigen::Ref<Points> out) const;
  /// out += factor * L^T (l(points) - target); returns |l(points) - target|^2. One sweep over the
  /// vertices.
  double add_misfit(const Eigen::Ref<const Points>& points, const Eigen::Ref<const Points>& target,
                    double factor, Eigen::Ref<Points> out) const;
  /// L as a matrix, n x n.
  Eigen::SparseMatrix<double> matrix() const;

 private:
  std::vector<int> first_{0}, neighbour_;
};

}  // namespace vasorod
