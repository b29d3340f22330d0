#include "bodies/joining_energy.h"

namespace vasorod {
namespace {

Vec3 gap(const Join& join, const Eigen::Ref<const Points>& p) {
  return (p.row(join.a) - p.row(join.b)).transpose() - join.offset;
}

}  // namespace

double joining_energy(double k_j, const std::vector<Join>& joins,
                      const Eigen::Ref<const Points>& p) {
  double sum = 0;
  for (const Join& join : joins) {
    const Vec3 d = gap(join, p);
    sum += k_j * d.squaredNorm() + join.multiplier.dot(d);
  }
  return sum;
}

double joining_energy_gradient(double k_j, const std::vector<Join>& joins,
                               const Eigen::Ref<const Points>& p, Eigen::Ref<Points> gradient) {
  double sum = 0;
  for (const Join& join : joins) {
    const Vec3 d = gap(join, p);
    sum += k_j * d.squaredNorm() + join.multiplier.dot(d);
    const Vec3 force = 2 * k_j * d + join.multiplier;
    gradient.row(join.a) += force.transpose();
    gradient.row(join.b) -= force.transpose();
  }
  return sum;
}

Eigen::SparseMatrix<double> joining_energy_hessian(double k_j, const std::vector<Join>& joins,
                                                   int vertex_count) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Join& join : joins) {
    entries.emplace_back(join.a, join.a, 2 * k_j);
    entries.emplace_back(join.b, join.b, 2 * k_j);
    entries.emplace_back(join.a, join.b, -2 * k_j);
    entries.emplace_back(join.b, join.a, -2 * k_j);
  }
  Eigen::SparseMatrix<double> hessian(vertex_count, vertex_count);
  hessian.setFromTriplets(entries.begin(), entries.end());
  return hessian;
}

void update_join_multipliers(double k_j, std::vector<Join>& joins,
                             const Eigen::Ref<const Points>& p) {
  for (Join& join : joins) join.multiplier += 2 * k_j * gap(join, p);
}

}  // namespace vasorod
