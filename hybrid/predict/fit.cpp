#include <algorithm>
#include <cctype>

#include <vasorod/error.h>
#include <vasorod/fit.h>

#include "data/sentence.h"
#include "predict/input_hashes.h"
#include "predict/name_faults.h"
#include "predict/result_of_vessel.h"
#include "predict/result_parts.h"
#include "predict/stopwatch.h"
#include "surface_file/read_surface.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

// What a vessel of a scene may be called (scene/read_vessels.cpp): the name becomes those of files.
std::string vessel_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
  return text;
}

}  // namespace

Result fit(const FitRequest& request) {
  Stopwatch watch;
  const std::vector<std::string> units{"mm", "cm", "m"};
  if (std::find(units.begin(), units.end(), request.length_unit) == units.end())
    throw InputError("length unit: found " + in_quotes(request.length_unit) + ", expected " +
                     listed(units));
  Scene scene;
  scene.file = request.surface;
  scene.units.length = request.length_unit;
  scene.units.metres = request.length_unit == "mm" ? 1e-3 : request.length_unit == "cm" ? 1e-2 : 1;
  VesselSpec spec;
  spec.name = vessel_name(request.surface.stem().string());
  spec.surface = request.surface;
  spec.remesh = request.remesh;
  scene.vessels.push_back(spec);
  InputHashes inputs(scene);
  LoadedSurface loaded;
  inputs.while_reading(spec, [&] { loaded = load_surface(spec, scene); });
  watch.lap("read");
  const Vessel vessel = fit_vessel(spec.name, loaded.surface);
  watch.lap("fit");

  Result result = begin_result(spec.name, "fit", scene.units, 1);
  result.model.rod_nodes = vessel.rod.node_count();
  result.model.vertices = static_cast<int>(vessel.surface.points.rows());
  result.model.triangles = static_cast<int>(vessel.surface.triangles.rows());
  result.model.left_out["solving"] = "fit: the vessel is shown at rest";
  result.model.cleaning[spec.name] = loaded.report.text();
  VesselResult out;
  out.name = spec.name;
  out.rest = out.current = vessel.surface.points;
  out.triangles = vessel.surface.triangles;
  out.point_arrays = loaded.point_arrays;
  out.cell_arrays = loaded.cell_arrays;
  out.centerline = centerline_of(vessel.rod, vessel.rod.rest);
  result.vessels.push_back(std::move(out));
  result.stages.push_back({"rest", {vessel.surface}, {spec.name}});
  result.seconds = watch.seconds();
  result.environment.inputs = inputs.hashes();
  name_faults(result);
  return result;
}

}  // namespace vasorod
