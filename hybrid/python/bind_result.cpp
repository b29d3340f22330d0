#include <memory>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vasorod/compare.h>
#include <vasorod/result_folder.h>

#include "python/apart.h"
#include "python/classes.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

py::object parsed(const std::string& json) {
  return py::module_::import("json").attr("loads")(json);
}

py::dict vessels_of(const std::shared_ptr<Result>& result) {
  py::dict vessels;
  for (VesselResult& vessel : result->vessels)
    vessels[py::str(vessel.name)] = std::shared_ptr<VesselResult>(result, &vessel);
  return vessels;
}

void write(Result& result, const std::filesystem::path& folder, bool report) {
  // A copy: another Python thread may read the result meanwhile.
  const auto written = std::make_shared<Result>(result);
  apart<bool>(
      [=](Job& job) {
        WriteOptions options;
        options.report = report;
        options.stop = [&job] { return job.stop(); };
        write_result_folder(*written, folder, options);
        return true;
      },
      OnInterrupt::wait_for);
  result.seconds = written->seconds;
}

}  // namespace

void bind_result(py::module_& module) {
  py::class_<Result, std::shared_ptr<Result>>(module, "Result",
                                              R"(What solve and fit return.

>>> result.status, result.fidelity
('converged', 'skin')
>>> list(result.vessels)
['tube']
>>> force = result.json["ends"][1]["force"]  # of the support on the tube's end, N
)")
      .def_readonly("scene", &Result::scene, "The scene's name; after fit, the surface's.")
      .def_readonly("program", &Result::program, "Name and version of the program.")
      .def_readonly("fidelity", &Result::fidelity, "The fidelity that was solved; fit: \"fit\".")
      .def_property_readonly(
          "status", [](const Result& self) { return to_string(self.status); },
          "How the solve ended: \"converged\", \"equilibrium_only\", \"unstable\", \"buckled\",\n"
          "\"not_unique\", \"self_intersecting\", \"iteration_limit\" or \"interrupted\".")
      .def_readonly("length_unit", &Result::length_unit, "mm, cm or m.")
      .def_readonly("stress_unit", &Result::stress_unit,
                    "Pa, kPa or MPa; forces are stress * length^2.")
      .def_property_readonly("vessels", &vessels_of,
                             "The vessels by name, in the scene's order: dict of Vessel.")
      .def_property_readonly(
          "json", [](const Result& self) { return parsed(to_json(self)); },
          "Everything with a number, as in result.json (docs/result.md): a dict, made anew at "
          "each\n"
          "access. A number that is not finite is None.")
      .def("write", &write, py::arg("folder"), py::kw_only(), py::arg("report") = true,
           R"(Writes the result folder, as the program does.

folder must be absent, empty or an earlier result; it is replaced as a whole. report: False leaves
out the pictures and report.html. OSError if the folder cannot be replaced or written; the old
folder is then unchanged.

>>> folder = tempfile.mkdtemp()
>>> result.write(folder, report=False)
>>> sorted(os.listdir(folder))
['result.json', 'scene.pvd', 'tube.vtp', 'tube_centerline.vtp']
)")
      .def("__repr__", [](const Result& self) {
        return "<vasorod.Result " + self.scene + ": " + to_string(self.status) + " (" +
               self.fidelity + ")>";
      });
  py::class_<Comparison, std::shared_ptr<Comparison>>(module, "Comparison",
                                                      R"(What compare returns.

print() shows the table that `vasorod compare` shows.
)")
      .def_property_readonly(
          "json", [](const Comparison& self) { return parsed(comparison_json(self)); },
          "The numbers of `vasorod compare --json`: a dict, made anew at each access. Distances "
          "are\n"
          "over the vessel's radius.")
      .def("__str__", &comparison_table)
      .def("__repr__",
           [](const Comparison& self) { return "<vasorod.Comparison of " + self.scene + ">"; });
}

}  // namespace vasorod::python
