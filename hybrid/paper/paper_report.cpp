#include "paper/paper_report.h"

#include <algorithm>
#include <cmath>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

const PaperBlock& block_of(const PaperSystem& system, int first) {
  return *std::find_if(system.blocks.begin(), system.blocks.end(),
                       [first](const PaperBlock& block) { return block.first == first; });
}

// Per vertex, in the problem's unit; 0 without a guard.
Eigen::VectorXd pressure_of_guard(const PaperBlock& block, const Points& positions,
                                  const ScaledBody& body, const ScaledBodies& scaled) {
  if (!block.guard) return Eigen::VectorXd::Zero(block.count);
  Points force = Points::Zero(block.count, 3);
  block.guard->gradient(positions.middleRows(block.first, block.count), force);
  return guard_pressure(body.rest, force) * scaled.pressure();
}

}  // namespace

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
      if (system.fixed[static_cast<size_t>(start + i)])
        mine.support_force.row(i) = total.row(start + i);
    mine.binding = mine.binding_force.colwise().sum();
    mine.support = mine.support_force.colwise().sum();
    mine.joining = -gradient.joining.middleRows(start, count).colwise().sum();
    mine.contact = -gradient.contact.middleRows(start, count).colwise().sum();
    const double net = (mine.binding + mine.support + mine.joining + mine.contact).norm();
    const double largest = std::max(
        {mine.binding.norm(), mine.support.norm(), mine.joining.norm(), mine.contact.norm()});
    // Rounding level: terms that cancel leave the last digits of the terms and of the positions.
    const auto size_of = [&](const Points& term) {
      return term.middleRows(start, count).rowwise().norm().sum();
    };
    const Coefficients& k = scaled.bodies[b].k;
    const double rounding =
        1e-12 *
            (size_of(gradient.binding) + size_of(gradient.bending) + size_of(gradient.stretching)) +
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

void report_paper(const BodyProblem& problem, const ScaledBodies& scaled, const PaperSystem& system,
                  const std::vector<int>& first, const Points& positions,
                  const StackedContacts& stacked, BodyContacts& contacts, SurfaceSolution& solution,
                  bool final) {
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
    mine.pressure =
        pressure_of_guard(block_of(system, first[b]), positions, scaled.bodies[b], scaled);
    mine.positions = scaled.unscaled(scaled.bodies[b].now);
    for (Points* force : {&mine.support_force, &mine.binding_force}) *force *= scaled.force();
    for (Vec3* force : {&mine.support, &mine.binding, &mine.joining, &mine.contact})
      *force *= scaled.force();
  }
  std::vector<Eigen::VectorXd> guarded;  // before the contacts' pressures are added
  for (const BodySolution& body : solution.bodies) guarded.push_back(body.pressure);
  report_contacts(problem, scaled, system.contacts, positions, stacked, contacts, solution, final);
  for (ContactSolution& pair : solution.contacts) {
    const size_t b = index(pair.a);
    if (pair.a != pair.b || !solution.bodies[b].modelled) continue;
    const PaperBlock& block = block_of(system, first[b]);
    const double gap = block.guard->smallest_gap(positions.middleRows(block.first, block.count));
    report_guard(scaled, guarded[b], gap, pair);
    const bool solved = solution.status == Status::converged || solution.status == Status::unstable;
    if (final && solved && gap < 0)
      solution.notes.push_back(joined_text("faces of the wall of ", problem.bodies[b].name,
                                           " that met at an angle lie in each other by ",
                                           number_text(-gap / scaled.bodies[b].mean_edge, 2),
                                           " mean edges"));
  }
  report_seam(scaled, system.joins, positions, solution);
}

}  // namespace vasorod
