#include "bodies/surface_report.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle_surface.h"

namespace vasorod {

void report_contacts(const BodyProblem& problem, const ScaledBodies& scaled,
                     const std::vector<ContactPoint>& points, const Points& positions,
                     const StackedContacts& stacked, BodyContacts& contacts,
                     SurfaceSolution& solution, bool final) {
  for (size_t p = 0; p < problem.contacts.size(); ++p) {
    ContactSolution& mine = solution.contacts.emplace_back();
    mine.a = problem.contacts[p].first;
    mine.b = problem.contacts[p].second;
  }
  std::vector<Points> handed;
  std::vector<Eigen::VectorXd> areas;
  for (const ScaledBody& b : scaled.bodies) {
    handed.push_back(Points::Zero(b.now.rows(), 3));
    areas.push_back(vertex_areas(b.rest));
  }
  for (size_t c = 0; c < points.size(); ++c) {
    const ContactPoint& contact = points[c];
    const double pressure = contact_pressure(contact, positions);
    if (pressure == 0) continue;
    const auto slave = static_cast<size_t>(stacked.bodies[c][0]),
               master = static_cast<size_t>(stacked.bodies[c][1]);
    ContactSolution& pair = solution.contacts[static_cast<size_t>(stacked.pair[c])];
    const double real = pressure * scaled.pressure();
    // A wall that touches itself is slave and master with half its area each.
    const double own_area = areas[slave][stacked.slave[c]];
    solution.bodies[slave].pressure[stacked.slave[c]] += real * (contact.area / own_area);
    const Vec3 force = contact.area * pressure * contact.normal;
    for (size_t k = 0; k < 3; ++k)
      handed[master].row(stacked.master[c][k]) -=
          contact.weight[static_cast<int>(k)] * force.transpose();
    if (slave != master)
      pair.force += (pair.a == static_cast<int>(slave) ? 1 : -1) * force * scaled.force();
    // Vertices of both walls stand for one area.
    const double sides = contacts.seen_from_both(stacked.pair[c]) ? 2 : 1;
    pair.area += contact.area * scaled.length * scaled.length / sides;
    pair.largest_pressure = std::max(pair.largest_pressure, real);
  }
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    BodySolution& mine = solution.bodies[b];
    for (int i = 0; i < mine.pressure.size(); ++i) {
      if (areas[b][i] > 0)
        mine.pressure[i] += handed[b].row(i).norm() / areas[b][i] * scaled.pressure();
      if (mine.pressure[i] > 0) mine.contact_area += areas[b][i] * scaled.length * scaled.length;
    }
    mine.largest_pressure = mine.pressure.maxCoeff();
    if (!mine.modelled) mine.contact = handed[b].colwise().sum().transpose() * scaled.force();
  }
  for (size_t p = 0; p < solution.contacts.size(); ++p) {
    ContactSolution& mine = solution.contacts[p];
    mine.within_reach = contacts.within_reach(static_cast<int>(p));
    mine.swallowed = contacts.swallowed(static_cast<int>(p));
    mine.held_depth = contacts.held_depth(static_cast<int>(p)) * scaled.length;
    mine.smallest_gap = contacts.smallest_gap(static_cast<int>(p), scaled, final) * scaled.length;
  }
}

Eigen::VectorXd guard_pressure(const TriangleSurface& rest, const Points& force) {
  const Eigen::VectorXd areas = vertex_areas(rest);
  return (areas.array() > 0).select(force.rowwise().norm().array() / areas.array(), 0);
}

void report_guard(const ScaledBodies& scaled, const Eigen::VectorXd& pressure, double gap,
                  ContactSolution& pair) {
  pair.largest_pressure = pressure.maxCoeff();
  pair.within_reach = pair.largest_pressure > 0;
  // Vertices of both walls stand for one area.
  const Eigen::VectorXd areas = vertex_areas(scaled.bodies[static_cast<size_t>(pair.a)].rest);
  pair.area = (pressure.array() > 0).select(areas, 0).sum() / 2 * scaled.length * scaled.length;
  pair.smallest_gap = gap * scaled.length;
}

void report_seam(const ScaledBodies& scaled, const std::vector<Join>& joins,
                 const Points& positions, SurfaceSolution& solution) {
  double sum = 0;
  for (const Join& join : joins) {
    const double gap = (positions.row(join.a) - positions.row(join.b)).norm() * scaled.length;
    solution.largest_seam_gap = std::max(solution.largest_seam_gap, gap);
    sum += gap * gap;
  }
  if (!joins.empty()) solution.rms_seam_gap = std::sqrt(sum / static_cast<double>(joins.size()));
}

}  // namespace vasorod
