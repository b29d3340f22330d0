#include "predict/result_parts.h"

#include <algorithm>
#include <cmath>

#include <vasorod/version.h>

#include "data/sentence.h"
#include "numerics/blas.h"

namespace vasorod {

double worst_of(double a, double b) {
  return std::isnan(a) ? a : std::isnan(b) ? b : std::max(a, b);
}

Result begin_result(const std::string& scene, const std::string& fidelity, const Units& units,
                    int threads) {
  Result result;
  result.scene = scene;
  result.program = "vasorod " + version();
  result.fidelity = fidelity;
  result.length_unit = units.length;
  result.stress_unit = units.stress;
  result.iterations = {{"rod", 0}, {"surface", 0}};
  result.environment.blas = blas_name();
  result.environment.threads = threads;
  return result;
}

void add_rod(const std::string& name, const RodSummary& summary, bool certificate, Result& result) {
  result.status = worse(result.status, summary.status);
  result.certificate.relative_residual =
      worst_of(result.certificate.relative_residual, summary.residual);
  const bool judged = summary.status == Status::converged || summary.status == Status::buckled ||
                      summary.status == Status::unstable;
  if (certificate && judged)
    result.certificate.smallest_curvature_positive =
        result.certificate.smallest_curvature_positive.value_or(true) &&
        summary.negative_directions == 0;
  std::string message = summary.message;
  if (summary.status == Status::iteration_limit)
    message = "no equilibrium was found: residual " + number_text(summary.residual, 3) + " after " +
              std::to_string(summary.iterations) + " linear solves" +
              (message.empty() ? "" : "; " + message);
  if (!message.empty()) result.certificate.notes.push_back("rod of " + name + ": " + message);
  result.energy.rod += summary.energy;
  result.iterations["rod"] += summary.iterations;
}

}  // namespace vasorod
