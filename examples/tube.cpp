// A tube bent by 10 degrees at two fidelities, and how far apart the two answers are.
#include <cstdio>
#include <filesystem>
#include <numbers>

#include <vasorod/compare.h>
#include <vasorod/predict.h>
#include <vasorod/result_folder.h>

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : "results/example-tube";
  vasorod::VesselSpec tube;
  tube.name = "tube";
  tube.tube = vasorod::TubeSpec{.length = 100, .radius = 10, .around = 24, .along = 44};
  tube.surface_is = vasorod::SurfaceIs::mid;
  tube.wall = vasorod::Wall{.thickness = 1, .material = vasorod::Material::isotropic(1, 0.3)};

  vasorod::EndCondition held;
  held.vessel = "tube";
  held.hold = true;
  vasorod::EndCondition bent = held;
  bent.hold = false;
  bent.end.kind = vasorod::EndSelector::Kind::end;
  const double angle = 10 * std::numbers::pi / 180, radius = 100 / angle;
  bent.rotate_deg = vasorod::Vec3(0, 10, 0);
  bent.move = vasorod::Vec3(radius * (1 - std::cos(angle)), 0, radius * std::sin(angle) - 100);

  vasorod::Scene scene;
  scene.name = "bent tube";
  scene.vessels = {tube};
  scene.ends = {held, bent};
  for (const char* fidelity : {"skin", "coupled"}) {
    scene.fidelity = fidelity;
    vasorod::Result result = vasorod::predict(scene);
    std::printf("%-8s %s, flattening %.4f\n", fidelity, to_string(result.status).c_str(),
                result.metrics.front().flattening);
    vasorod::write_result_folder(result, folder / fidelity);
  }
  const vasorod::Comparison apart = vasorod::compare_results(folder / "skin", folder / "coupled");
  const double rms = apart.vessels.front().surface->rms;
  std::printf("the two surfaces are %.4f of the radius apart (RMS)\n", rms);
  return rms > 0 && rms < 0.1 ? 0 : 1;
}
