// The Glenn operation of a scene file: what became of it, and where the vein twists most.
#include <cstdio>
#include <exception>

#include <vasorod/predict.h>
#include <vasorod/read_scene.h>

int main(int argc, char** argv) {
  try {
    const vasorod::Scene scene =
        vasorod::read_scene(argc > 1 ? argv[1] : "benchmarks/cases/glenn/infant.yaml");
    vasorod::SolveOptions options;
    options.fidelity = "skin";  // sections carried rigidly: the quickest that shows the shape
    const vasorod::Result result = vasorod::predict(scene, options);

    const vasorod::GlennReport& glenn = result.glenn.value();
    std::printf("%s: %s, vein cut at %.2f of its length, turned by %.1f degrees, %d pairs\n",
                result.scene.c_str(), to_string(result.status).c_str(), glenn.cut.fraction,
                glenn.join.rotation_deg, glenn.join.pairs);
    for (const vasorod::VesselMetrics& vessel : result.metrics)
      std::printf("%-20s largest twist shear %.4f, stretch %.3f to %.3f, smallest lumen %.2f\n",
                  vessel.vessel.c_str(), vessel.largest_twist_shear, vessel.stretch[0],
                  vessel.stretch[1], vessel.smallest_lumen_ratio);
    for (const std::string& warning : result.validity.warnings)
      std::printf("  %s\n", warning.c_str());
    return result.status == vasorod::Status::converged ? 0 : 1;
  } catch (const std::exception& error) {  // InputError, FileError: one sentence
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
