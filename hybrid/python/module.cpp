// The compiled part of the Python package: vasorod._core.
#include <cmath>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vasorod/compare.h>
#include <vasorod/error.h>
#include <vasorod/fit.h>
#include <vasorod/predict.h>
#include <vasorod/read_scene.h>
#include <vasorod/version.h>

#include "data/sentence.h"
#include "predict/kept_state.h"
#include "predict/name_stop.h"
#include "python/apart.h"
#include "python/classes.h"
#include "python/errors.h"
#include "result/folder_replacement.h"
#include "surface_file/read_polydata.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

// Of a solve that goes on long after its time limit, as the program does (app/commands.cpp).
Result state_so_far(const std::shared_ptr<Job>& job, double time_limit) {
  const py::gil_scoped_release others_run;
  const auto [make_result, stage] = job->kept();
  Job::leave(job);
  if (!make_result) stop_early(stage);
  Result result = make_result();
  name_stop(time_limit_of(time_limit), stage, result);
  return result;
}

std::shared_ptr<Result> solve(const std::shared_ptr<Scene>& scene,
                              const std::optional<std::string>& fidelity, bool certify, int threads,
                              std::optional<double> time_limit, const py::object& progress) {
  if (time_limit && !(std::isfinite(*time_limit) && *time_limit > 0))
    throw InputError("time_limit: found " + number_text(*time_limit) +
                     ", expected seconds above 0, or None");
  SolveOptions options;
  options.fidelity = fidelity;
  options.certify = certify;
  options.threads = threads;
  auto result = std::make_shared<Result>();
  const auto job = Job::start(
      [=](Job& self) mutable {
        options.stop = [&self] { return self.stop(); };
        if (time_limit) options.stopped_by = [=] { return time_limit_of(*time_limit); };
        options.progress = [&self](const std::string& stage) { self.begin(stage); };
        options.keep = [&self](Job::MakeResult state) { self.keep(std::move(state)); };
        options.solved = [&self] { self.solved(); };
        *result = predict(*scene, options);
      },
      time_limit);
  if (wait_for(job, OnInterrupt::leave, progress)) return result;
  return std::make_shared<Result>(state_so_far(job, *time_limit));
}

std::shared_ptr<Result> fitted(const std::filesystem::path& surface, const std::string& length_unit,
                               std::optional<double> remesh) {
  // As the program's own options (app/main.cpp).
  if (remesh && !(std::isfinite(*remesh) && *remesh > 0))
    throw InputError("remesh: found " + number_text(*remesh) + ", expected a number above 0");
  const FitRequest request{surface, length_unit, remesh};
  return apart<Result>([request](Job&) { return fit(request); });
}

std::shared_ptr<Comparison> compared(const std::filesystem::path& a, const std::filesystem::path& b,
                                     bool a_in_memory, bool b_in_memory) {
  auto comparison = apart<Comparison>([=](Job&) { return compare_results(a, b); });
  // Its folder was there for the comparison only.
  if (a_in_memory) comparison->a.folder = "in memory";
  if (b_in_memory) comparison->b.folder = "in memory";
  return comparison;
}

std::shared_ptr<LoadedSurface> surface_of_file(const std::filesystem::path& file) {
  return apart<LoadedSurface>([file](Job&) { return read_polydata(file); });
}

void check_folder(const std::filesystem::path& folder, const Scene& scene) {
  require_outside(folder, input_files(scene));
  require_replaceable(folder);
}

}  // namespace
}  // namespace vasorod::python

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace vasorod;
  using namespace vasorod::python;
  module.doc() = "The compiled part of vasorod; use the functions of the package vasorod.";
  translate_errors();
  bind_scene(module);
  bind_surface(module);
  bind_vessel(module);
  bind_result(module);
  bind_explore(module);
  module.def("version", &version);
  module.def("fidelities", &fidelity_names);
  module.def("read_scene", &read_scene, py::arg("file"));
  module.def("read_scene_text", &read_scene_text, py::arg("text"), py::arg("folder"));
  module.def("read_surface", &surface_of_file, py::arg("file"));
  module.def("solve", &solve, py::arg("scene"), py::arg("fidelity"), py::arg("certify"),
             py::arg("threads"), py::arg("time_limit"), py::arg("progress"));
  module.def("fit", &fitted, py::arg("surface"), py::arg("length_unit"), py::arg("remesh"));
  module.def("compare", &compared, py::arg("a"), py::arg("b"), py::arg("a_in_memory"),
             py::arg("b_in_memory"));
  module.def("check_folder", &check_folder, py::arg("folder"), py::arg("scene"));
  // Computations that Ctrl-C left to themselves end before what they use is gone.
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    const py::gil_scoped_release others_run;
    Job::wait_for_left();
  }));
}
