#include "surface/paper_report.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle_surface.h"

namespace vasorod {
void report_contacts(const PaperProblem& problem, const ScaledBodies& scaled,
                     const std::vector<ContactPoint>& points, const Points& positions,
                     const StackedContacts& stacked, PaperContacts& contacts, PaperSolution& solution) {
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
    const auto slave = static_cast<size_t>(contacts.slave(stacked.pair[c])),
               master = static_cast<size_t>(contacts.master(stacked.pair[c]));
    ContactSolution& pair = solution.contacts[static_cast<size_t>(stacked.pair[c])];
    const double real = pressure * scaled.pressure();
    solution.bodies[slave].pressure[stacked.slave[c]] += real;
    const Vec3 force = contact.area * pressure * contact.normal;
    for (size_t k = 0; k < 3; ++k)
      handed[master].row(stacked.master[c][k]) -= contact.weight[static_cast<int>(k)] * force.transpose();
    pair.force += (pair.a == static_cast<int>(slave) ? 1 : -1) * force * scaled.force();
    pair.area += contact.area * scaled.length * scaled.length;
    pair.largest_pressure = std::max(pair.largest_pressure, real);
  }
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    BodySolution& mine = solution.bodies[b];
    for (int i = 0; i < mine.pressure.size(); ++i) {
      if (areas[b][i] > 0) mine.pressure[i] += handed[b].row(i).norm() / areas[b][i] * scaled.pressure();
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
    mine.smallest_gap = contacts.smallest_gap(static_cast<int>(p), scaled) * scaled.length;
  }
}

void report_seam(const ScaledBodies& scaled, const std::vector<Join>& joins, const Points& positions,
                 PaperSolution& solution) {
  double sum = 0;
  for (const Join& join : joins) {
    const double gap = (positions.row(join.a) - positions.row(join.b)).norm() * scaled.length;
    solution.largest_seam_gap = std::max(solution.largest_seam_gap, gap);
    sum += gap * gap;
  }
  if (!joins.empty()) solution.rms_seam_gap = std::sqrt(sum / static_cast<double>(joins.size()));
}

std::vector<BodySolution> sum_forces(const ScaledBodies& scaled, const PaperSystem& system,
                                     const std::vector<int>& first, const Points& positions) {
  PaperGradient gradient;
  paper_energy_gradient(system, positions, gradient);
  const Points total = gradient.sum();
  std::vector<BodySolution> bodies(scaled.bodies.size());
  for (size_t b = 0; b < bodies.size(); ++b) {
    if (first.empty() || first[b] < 0) continue;
    BodySolution& mine = bodies[b];
    const Eigen::Index start = first[b], count = scaled.bodies[b].now.rows();
    mine.modelled = true;
    mine.binding_force = -gradient.binding.middleRows(start, count);
    mine.support_force = Points::Zero(count, 3);
    for (Eigen::Index i = 0; i < count; ++i)
      if (system.fixed[static_cast<size_t>(start + i)]) mine.support_force.row(i) = total.row(start + i);
    mine.binding = mine.binding_force.colwise().sum();
    mine.support = mine.support_force.colwise().sum();
    mine.joining = -gradient.joining.middleRows(start, count).colwise().sum();
    mine.contact = -gradient.contact.middleRows(start, count).colwise().sum();
    const double net = (mine.binding + mine.support + mine.joining + mine.contact).norm();
    const double largest =
        std::max({mine.binding.norm(), mine.support.norm(), mine.joining.norm(), mine.contact.norm()});
    // Rounding: what cancels keeps the last digits of its terms, and of the positions.
    const auto size_of = [&](const Points& term) {
      return term.middleRows(start, count).rowwise().norm().sum();
    };
    const PaperCoefficients& k = scaled.bodies[b].k;
    const double rounding =
        1e-12 * (size_of(gradient.binding) + size_of(gradient.bending) + size_of(gradient.stretching)) +
        1e-14 * (k.binding + k.bending + k.stretching) * static_cast<double>(count);
    mine.residual = net <= rounding ? 0 : net / largest;
  }
  return bodies;
}

double worst_balance(const std::vector<BodySolution>& bodies) {
  double worst = 0;
  for (const BodySolution& b : bodies) worst = std::max(worst, b.residual);
  return worst;
}

void report_paper(const PaperProblem& problem, const ScaledBodies& scaled, const PaperSystem& system,
                  const std::vector<int>& first, const Points& positions, const StackedContacts& stacked,
                  PaperContacts& contacts, PaperSolution& solution) {
  solution.bodies = sum_forces(scaled, system, first, positions);
  PaperGradient gradient;
  const PaperTerms terms = paper_energy_gradient(system, positions, gradient);
  solution.binding_energy = terms.binding * scaled.energy();
  solution.bending_energy = terms.bending * scaled.energy();
  solution.stretching_energy = terms.stretching * scaled.energy();
  solution.joining_energy = terms.joining * scaled.energy();
  solution.contact_energy = terms.contact * scaled.energy();
  for (size_t b = 0; b < scaled.bodies.size(); ++b) {
    BodySolution& mine = solution.bodies[b];
    const Points& rest = problem.bodies[b].rest.points;
    mine.pressure = Eigen::VectorXd::Zero(rest.rows());
    if (!mine.modelled) {
      mine.positions = rest;
      mine.support_force = mine.binding_force = Points::Zero(rest.rows(), 3);
      continue;
    }
    mine.positions = scaled.unscaled(scaled.bodies[b].now);
    for (Points* force : {&mine.support_force, &mine.binding_force}) *force *= scaled.force();
    for (Vec3* force : {&mine.support, &mine.binding, &mine.joining, &mine.contact}) *force *= scaled.force();
  }
  report_contacts(problem, scaled, system.contacts, positions, stacked, contacts, solution);
  report_seam(scaled, system.joins, positions, solution);
}

}  // namespace vasorod
