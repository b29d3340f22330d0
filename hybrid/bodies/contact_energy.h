// Contact as an area-weighted gap penalty with augmented Lagrangian multipliers:
//
//   E = sum_i A_i / (2 k) (p_i^2 - m_i^2),   p_i = max(0, m_i - k g_i)
//
// g is the gap between a vertex and the plane that faces it, m the multiplier. After each
// minimisation m is set to p, so p converges to the pressure for any k, and is exactly 0 where the
// walls are apart.
//
// A contact may also stick: it then resists sliding across its normal from where it was held,
//
//   E += A s / 2 |slip|^2
//
// Units: g length, p and m stress, k and s stress / length, A length^2 (rest area of the
// vertex), E force * length.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// One vertex against a plane. The plane moves with a triangle of the other surface, or is fixed
/// (master[0] < 0); or the vertex is fixed (slave < 0). What is fixed counts as at the origin: its
/// place is in `slack` and `held`. The force on the vertex and the weighted forces on the triangle
/// sum to zero.
struct ContactPoint {
  int slave = 0;
  std::array<int, 3> master{-1, -1, -1};
  Vec3 weight = Vec3::Zero();  ///< of the triangle's vertices, sum 1
  Vec3 normal = Vec3::Zero();  ///< unit, outward from the other surface
  /// Offset in g = normal.(x_slave - sum weight x_master) - slack, length.
  double slack = 0;
  double area = 0;        ///< A, rest area of the vertex, length^2
  double stiffness = 0;   ///< k, stress / length
  double multiplier = 0;  ///< m, stress
  double stick = 0;       ///< s, stress / length
  /// x_slave - sum weight x_master from where on it slips, length.
  Vec3 held = Vec3::Zero();
};

/// g, length.
double contact_gap(const ContactPoint& contact, const Eigen::Ref<const Points>& p);
/// How far the vertex slid over the plane from where it was held, length.
Vec3 contact_slip(const ContactPoint& contact, const Eigen::Ref<const Points>& p);
/// max(0, m - k g), stress.
double contact_pressure(const ContactPoint& contact, const Eigen::Ref<const Points>& p);

/// Sum over all contacts, force * length. `p` is n x 3.
double contact_energy(const std::vector<ContactPoint>& contacts, const Eigen::Ref<const Points>& p);

/// gradient += dE/dp (n x 3); returns the energy.
double contact_energy_gradient(const std::vector<ContactPoint>& contacts,
                               const Eigen::Ref<const Points>& p, Eigen::Ref<Points> gradient);

/// Appends the blocks of the Hessian (3n x 3n, both triangles) to `entries`. The Hessian is
/// discontinuous where a gap opens.
void contact_energy_hessian(const std::vector<ContactPoint>& contacts,
                            const Eigen::Ref<const Points>& p,
                            std::vector<Eigen::Triplet<double>>& entries);

/// An upper bound of the Hessian at p, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> contact_energy_bound(const std::vector<ContactPoint>& contacts,
                                                 const Eigen::Ref<const Points>& p);

}  // namespace vasorod
