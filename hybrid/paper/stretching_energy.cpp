#include "paper/stretching_energy.h"

#include <cmath>

namespace vasorod {

double stretching_energy(double k_s, const std::vector<Spring>& springs,
                         const Eigen::Ref<const Points>& p) {
  double sum = 0;
  for (const Spring& s : springs) {
    const double change = (p.row(s.b) - p.row(s.a)).norm() - s.rest_length;
    sum += change * change;
  }
  return k_s * sum;
}

double stretching_energy_gradient(double k_s, const std::vector<Spring>& springs,
                                  const Eigen::Ref<const Points>& carried,
                                  const Eigen::Ref<const Points>& u, Eigen::Ref<Points> gradient) {
  const double *x = u.data(), *y = carried.data();
  double* g = gradient.data();
  const Eigen::Index xs = u.outerStride(), ys = carried.outerStride(), gs = gradient.outerStride();
  double sum = 0;
  for (const Spring& s : springs) {
    const double *a = x + xs * s.a, *b = x + xs * s.b, *c = y + ys * s.a, *d = y + ys * s.b;
    const double e0 = (d[0] - c[0]) + (b[0] - a[0]), e1 = (d[1] - c[1]) + (b[1] - a[1]),
                 e2 = (d[2] - c[2]) + (b[2] - a[2]);
    const double length = std::sqrt(e0 * e0 + e1 * e1 + e2 * e2);
    const double change = length - s.rest_length;
    sum += change * change;
    const double factor = length > 0 ? 2 * k_s * change / length : 0;
    double *ga = g + gs * s.a, *gb = g + gs * s.b;
    ga[0] -= factor * e0, ga[1] -= factor * e1, ga[2] -= factor * e2;
    gb[0] += factor * e0, gb[1] += factor * e1, gb[2] += factor * e2;
  }
  return k_s * sum;
}

Mat3 spring_hessian(double k_s, const Vec3& e, double rest_length, double blend) {
  const double length = e.norm();
  if (length == 0) return 2 * k_s * Mat3::Identity();
  const Vec3 along = e / length;
  const double across = (1 - blend) * (1 - rest_length / length) + blend;
  return 2 * k_s * (across * Mat3::Identity() + (1 - across) * along * along.transpose());
}

void stretching_energy_hessian(double k_s, const std::vector<Spring>& springs,
                               const Eigen::Ref<const Points>& p,
                               std::vector<Eigen::Triplet<double>>& entries) {
  for (const Spring& s : springs) {
    const Mat3 block = spring_hessian(k_s, (p.row(s.b) - p.row(s.a)).transpose(), s.rest_length);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        entries.emplace_back(3 * s.a + r, 3 * s.a + c, block(r, c));
        entries.emplace_back(3 * s.b + r, 3 * s.b + c, block(r, c));
        entries.emplace_back(3 * s.a + r, 3 * s.b + c, -block(r, c));
        entries.emplace_back(3 * s.b + r, 3 * s.a + c, -block(r, c));
      }
  }
}

Eigen::SparseMatrix<double> stretching_energy_bound(double k_s, const std::vector<Spring>& springs,
                                                    int vertex_count) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * springs.size());
  for (const Spring& s : springs) {
    entries.emplace_back(s.a, s.a, 2 * k_s);
    entries.emplace_back(s.b, s.b, 2 * k_s);
    entries.emplace_back(s.a, s.b, -2 * k_s);
    entries.emplace_back(s.b, s.a, -2 * k_s);
  }
  Eigen::SparseMatrix<double> bound(vertex_count, vertex_count);
  bound.setFromTriplets(entries.begin(), entries.end());
  return bound;
}

}  // namespace vasorod
