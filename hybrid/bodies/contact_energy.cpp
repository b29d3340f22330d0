#include "bodies/contact_energy.h"

#include <algorithm>

#include "data/index.h"

namespace vasorod {
namespace {

// The vertices that a contact acts on and their share of the normal force: (slave, 1),
// (master_k, -weight_k), without what is fixed.
struct Stencil {
  int count = 0;
  std::array<int, 4> vertex{};
  std::array<double, 4> share{};
};

Stencil stencil_of(const ContactPoint& contact) {
  Stencil s;
  const auto add = [&s](int vertex, double share) {
    s.vertex[index(s.count)] = vertex;
    s.share[index(s.count)] = share;
    ++s.count;
  };
  if (contact.slave >= 0) add(contact.slave, 1);
  for (size_t k = 0; k < 3 && contact.master[0] >= 0; ++k)
    add(contact.master[k], -contact.weight[static_cast<int>(k)]);
  return s;
}

}  // namespace

Vec3 contact_slip(const ContactPoint& contact, const Eigen::Ref<const Points>& p) {
  Vec3 slip = -contact.held;
  if (contact.slave >= 0) slip += p.row(contact.slave).transpose();
  for (size_t k = 0; k < 3 && contact.master[0] >= 0; ++k)
    slip -= contact.weight[static_cast<int>(k)] * p.row(contact.master[k]).transpose();
  return slip - contact.normal.dot(slip) * contact.normal;
}

double contact_gap(const ContactPoint& contact, const Eigen::Ref<const Points>& p) {
  double gap = -contact.slack;
  if (contact.slave >= 0) gap += contact.normal.dot(p.row(contact.slave));
  for (size_t k = 0; k < 3 && contact.master[0] >= 0; ++k)
    gap -= contact.weight[static_cast<int>(k)] * contact.normal.dot(p.row(contact.master[k]));
  return gap;
}

double contact_pressure(const ContactPoint& contact, const Eigen::Ref<const Points>& p) {
  return std::max(0.0, contact.multiplier - contact.stiffness * contact_gap(contact, p));
}

double contact_energy(const std::vector<ContactPoint>& contacts,
                      const Eigen::Ref<const Points>& p) {
  double sum = 0;
  for (const ContactPoint& c : contacts) {
    const double pressure = contact_pressure(c, p);
    sum += c.area / (2 * c.stiffness) * (pressure * pressure - c.multiplier * c.multiplier);
    if (c.stick > 0) sum += c.area * c.stick / 2 * contact_slip(c, p).squaredNorm();
  }
  return sum;
}

double contact_energy_gradient(const std::vector<ContactPoint>& contacts,
                               const Eigen::Ref<const Points>& p, Eigen::Ref<Points> gradient) {
  double sum = 0;
  for (const ContactPoint& c : contacts) {
    const double pressure = contact_pressure(c, p);
    sum += c.area / (2 * c.stiffness) * (pressure * pressure - c.multiplier * c.multiplier);
    const Stencil s = stencil_of(c);
    if (c.stick > 0) {
      const Vec3 slip = contact_slip(c, p);
      sum += c.area * c.stick / 2 * slip.squaredNorm();
      for (size_t k = 0; k < static_cast<size_t>(s.count); ++k)
        gradient.row(s.vertex[k]) += c.area * c.stick * s.share[k] * slip.transpose();
    }
    if (pressure == 0) continue;
    for (size_t k = 0; k < static_cast<size_t>(s.count); ++k)
      gradient.row(s.vertex[k]) -= c.area * pressure * s.share[k] * c.normal.transpose();
  }
  return sum;
}

void contact_energy_hessian(const std::vector<ContactPoint>& contacts,
                            const Eigen::Ref<const Points>& p,
                            std::vector<Eigen::Triplet<double>>& entries) {
  for (const ContactPoint& c : contacts) {
    const double across = contact_pressure(c, p) > 0 ? c.stiffness - c.stick : -c.stick;
    if (across == 0) continue;
    const Stencil s = stencil_of(c);
    for (size_t a = 0; a < static_cast<size_t>(s.count); ++a)
      for (size_t b = 0; b < static_cast<size_t>(s.count); ++b) {
        const double stick = c.area * c.stick * s.share[a] * s.share[b];
        const double factor = c.area * across * s.share[a] * s.share[b];
        for (int row = 0; row < 3; ++row)
          for (int column = 0; column < 3; ++column)
            entries.emplace_back(
                3 * s.vertex[a] + row, 3 * s.vertex[b] + column,
                factor * c.normal[row] * c.normal[column] + (row == column ? stick : 0));
      }
  }
}

Eigen::SparseMatrix<double> contact_energy_bound(const std::vector<ContactPoint>& contacts,
                                                 const Eigen::Ref<const Points>& p) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const ContactPoint& c : contacts) {
    const double largest = std::max(contact_pressure(c, p) > 0 ? c.stiffness : 0, c.stick);
    if (largest == 0) continue;
    const Stencil s = stencil_of(c);
    for (size_t a = 0; a < static_cast<size_t>(s.count); ++a)
      for (size_t b = 0; b < static_cast<size_t>(s.count); ++b)
        entries.emplace_back(s.vertex[a], s.vertex[b], c.area * largest * s.share[a] * s.share[b]);
  }
  Eigen::SparseMatrix<double> bound(p.rows(), p.rows());
  bound.setFromTriplets(entries.begin(), entries.end());
  return bound;
}

}  // namespace vasorod
