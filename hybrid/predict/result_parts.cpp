#include "predict/result_parts.h"

#include <algorithm>

#include <vasorod/version.h>

#include "numerics/blas.h"
#include "result/sha256.h"

namespace vasorod {
namespace {

// The name of a surface in result.json: its file name, or its path if another input has that name.
std::string input_name(const Scene& scene, const std::filesystem::path& surface) {
  const auto taken = [&](const std::filesystem::path& other) {
    return other.filename() == surface.filename() &&
           other.lexically_normal() != surface.lexically_normal();
  };
  const bool shared =
      taken(scene.file) ||
      std::any_of(scene.vessels.begin(), scene.vessels.end(), [&](const VesselSpec& vessel) {
        return vessel.surface && taken(*vessel.surface);
      });
  if (!shared) return surface.filename().string();
  const std::filesystem::path beside = surface.lexically_relative(scene.file.parent_path());
  return (beside.empty() ? surface : beside).generic_string();
}

}  // namespace

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
      std::max(result.certificate.relative_residual, summary.residual);
  if (certificate && (summary.status == Status::converged || summary.status == Status::unstable))
    result.certificate.smallest_curvature_positive =
        result.certificate.smallest_curvature_positive.value_or(true) &&
        summary.negative_directions == 0;
  if (!summary.message.empty())
    result.certificate.notes.push_back("rod of " + name + ": " + summary.message);
  result.energy.rod += summary.energy;
  result.iterations["rod"] += summary.iterations;
}

void add_input_hashes(const Scene& scene, Result& result) {
  if (!scene.file.empty())
    result.environment.inputs[scene.file.filename().string()] = sha256_of_file(scene.file);
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface)
      result.environment.inputs[input_name(scene, *vessel.surface)] =
          sha256_of_file(*vessel.surface);
}

}  // namespace vasorod
