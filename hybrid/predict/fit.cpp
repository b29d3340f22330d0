#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <vasorod/error.h>
#include <vasorod/fit.h>

#include "data/index.h"
#include "data/sentence.h"
#include "judge/validity.h"
#include "predict/input_hashes.h"
#include "predict/name_faults.h"
#include "predict/result_of_vessel.h"
#include "predict/result_parts.h"
#include "predict/stopwatch.h"
#include "surface_file/read_surface.h"
#include "vessel/name_ends.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

// What a vessel of a scene may be called (scene/read_vessels.cpp): the name becomes those of files.
std::string vessel_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
  return text;
}

FittedLength measured(const RodTree& rod, const std::vector<int>& elements) {
  FittedLength out;
  out.smallest_radius = std::numeric_limits<double>::infinity();
  for (const int e : elements) {
    const RodElement& element = rod.elements[index(e)];
    const double first = rod.radius[index(element.first)],
                 second = rod.radius[index(element.second)];
    out.length += element.length;
    out.mean_radius += 0.5 * element.length * (first + second);
    out.smallest_radius = std::min({out.smallest_radius, first, second});
    out.largest_radius = std::max({out.largest_radius, first, second});
  }
  out.mean_radius /= out.length;
  return out;
}

FitReport report_of(const Vessel& vessel) {
  FitReport report;
  std::vector<int> all;
  for (const RodBranch& branch : vessel.rod.branches) {
    report.branches.push_back(measured(vessel.rod, branch.elements));
    all.insert(all.end(), branch.elements.begin(), branch.elements.end());
  }
  report.whole = measured(vessel.rod, all);
  for (std::size_t k = 0; k < vessel.ends.size(); ++k) {
    const VesselEnd& end = vessel.ends[k];
    const double radius = vessel.rod.radius[index(end.node)];
    // A person copies the place into a scene: to a thousandth of the radius, rounded.
    const double step = 1e-3 * std::pow(10, std::floor(std::log10(radius)));
    EndSelector selector{
        EndSelector::Kind::near,
        end.center.unaryExpr([&](double x) { return std::round(x / step) * step; }), 0, 0};
    if (k == 0) selector.kind = EndSelector::Kind::start;
    if (k == 1 && vessel.ends.size() == 2) selector.kind = EndSelector::Kind::end;
    report.ends.push_back({to_string(selector), end.face, end.center, end.outward, radius});
  }
  return report;
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
  Vessel vessel = fit_vessel(spec.name, loaded.surface);
  name_ends(vessel, loaded.lids);
  watch.lap("fit");

  Result result = begin_result(spec.name, "fit", scene.units, 1);
  result.model.rod_nodes = vessel.rod.node_count();
  result.model.vertices = static_cast<int>(vessel.surface.points.rows());
  result.model.triangles = static_cast<int>(vessel.surface.triangles.rows());
  result.model.left_out["solving"] = "fit: the vessel is shown at rest";
  result.model.cleaning[spec.name] = loaded.report.text();
  VesselResult out;
  out.name = spec.name;
  out.space = loaded.space;
  out.rest = out.current = vessel.surface.points;
  out.triangles = vessel.surface.triangles;
  out.point_arrays = loaded.point_arrays;
  out.cell_arrays = loaded.cell_arrays;
  out.centerline = centerline_of(vessel.rod, vessel.rod.rest);
  result.vessels.push_back(std::move(out));
  result.fit = report_of(vessel);
  warn_of_radius(spec.name, vessel.mean_radius, scene.units, result.validity);
  result.stages.push_back({"rest", {vessel.surface}, {spec.name}});
  result.seconds = watch.seconds();
  result.environment.inputs = inputs.hashes();
  result.environment.scene_hash = inputs.scene();
  name_faults(result);
  return result;
}

}  // namespace vasorod
