#include "reference_fem/solve_parts.h"

#include <vasorod/error.h>

#include "data/prestress_sentence.h"

namespace vasorod::fem {
namespace {

Status status_of(const StepperSummary& summary) {
  if (summary.status == PathStatus::interrupted) return Status::interrupted;
  if (summary.status != PathStatus::complete) return Status::iteration_limit;
  if (!summary.positive_definite) return Status::equilibrium_only;
  return *summary.positive_definite ? Status::converged : Status::unstable;
}

}  // namespace

void check_options(const SolveOptions& options) {
  if (options.degree < 1 || options.degree > 4)
    throw InputError("--degree: found " + std::to_string(options.degree) + ", expected 1 to 4");
  if (options.refine < 0 || options.refine > 2)
    throw InputError("--refine: found " + std::to_string(options.refine) + ", expected 0, 1 or 2");
}

Result begin_result(const Scene& scene, const SolveOptions& options) {
  Result result;
  result.scene = scene.name;
  result.fidelity = options.model == ModelKind::solid ? "solid" : "shell";
  result.length_unit = scene.units.length;
  result.stress_unit = scene.units.stress;
  return result;
}

void Effort::add(const StepperSummary& summary, double mesh_seconds) {
  mesh += mesh_seconds;
  assembly += summary.assembly_seconds;
  factor += summary.factor_seconds;
  iterations += summary.iterations;
  counts += summary.counts;
  counts.outer += summary.steps;
}

void Effort::report(double solve, Result& result) const {
  result.seconds["mesh"] = mesh;
  result.seconds["assembly"] = assembly;
  result.seconds["factor"] = factor;
  result.seconds["solve"] = solve;
  result.iterations["newton"] = iterations;
  result.counts = counts;
}

void report_path(const StepperSummary& summary, Result& result) {
  result.status = status_of(summary);
  result.certificate.relative_residual = summary.relative_residual;
  result.certificate.smallest_curvature_positive = summary.positive_definite;
  if (summary.status != PathStatus::complete)
    result.certificate.notes.push_back(
        text("the path ended at %.6f of the load; what is written is the last converged state",
             summary.load));
  for (const double load : summary.limit_loads)
    result.certificate.notes.push_back(
        text("the load passed a maximum at %.6f and came down before it went on", load));
}

void note_prestress(const std::string& vessel, const SeenShare& seen, Result& result) {
  if (const auto note = large_prestress(vessel, seen.largest, seen.steps))
    result.certificate.notes.push_back(*note);
}

std::string error_note(const std::string& what, const Convergence& c, double ratio) {
  std::string line =
      text("u_num of %s: %.2e (GCI, r = %.1f, order %.2f %s, Fs = %.2f)", what.c_str(),
           c.uncertainty, ratio, c.order, c.observed_order ? "used" : "assumed", c.safety);
  if (c.observed_order) line += text(", observed %.2f", *c.observed_order);
  return line;
}

}  // namespace vasorod::fem
