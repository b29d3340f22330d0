// vasorod._core.explore. The package calls it in a process of its own, since those that solve
// the options are forked from it (explore/apart.h).
#include <cmath>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vasorod/error.h>

#include "explore/explore.h"
#include "python/classes.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

using Json = nlohmann::json;

Json json_of(const RankedRow& one) {
  Json json = Json::parse(row_json(one.row));
  json.erase("look");
  if (one.row.ending != Ending::solved)
    for (const char* key : {"status", "in_range", "seconds"}) json[key] = nullptr;
  json["option"] = one.row.option;
  json["stage"] = one.row.stage;
  json["values"] = Json::object();
  for (const auto& [key, value] : one.row.values) json["values"][key] = value;
  json["rank"] = one.rank > 0 ? Json(one.rank) : Json();
  json["score"] = std::isfinite(one.score) ? Json(one.score) : Json();
  json["past"] = one.past;
  json["refined"] = one.row.refined;
  if (const auto& spread = one.spread)
    json["samples"] = {{"tried", spread->samples},
                       {"converged", spread->converged},
                       {"first", spread->first},
                       {"intervals", spread->intervals}};
  json["mark"] = to_string(one.mark);
  return json;
}

std::string text_of(const ExploreProgress& now) {
  if (now.of == 0) return now.doing;
  return now.doing + ": " + std::to_string(now.done) + " of " + std::to_string(now.of);
}

// A forked option ends at the first signal, and runs nothing of Python.
void leave_signals_to_the_system() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
}

std::string explored(const Scene& given, const std::filesystem::path& folder,
                     const std::optional<std::vector<std::string>>& stages,
                     const std::optional<int>& best, int threads, bool report,
                     const std::function<bool()>& stop,
                     const std::function<void(const std::string&)>& progress) {
  Scene scene = given;
  if (scene.explore && stages) scene.explore->stages = *stages;
  if (scene.explore && best) scene.explore->best = *best;
  ExploreRequest request;
  request.folder = folder;
  request.threads = threads;
  request.report = report;
  request.stop = [&] { return PyErr_CheckSignals() != 0 || stop(); };
  request.progress = [&](const ExploreProgress& now) { progress(text_of(now)); };
  request.begin_process = leave_signals_to_the_system;
  const ExploreSummary summary = explore(scene, request);
  if (PyErr_Occurred()) throw py::error_already_set();
  Json json{{"finished", summary.finished}, {"found", summary.found}, {"options", Json::array()}};
  if (const auto& spread = summary.spread)
    json["ranking"] = {{"samples", spread->samples},
                       {"first_stays", spread->first_stays()},
                       {"tau", spread->tau},
                       {"survives", spread->survives()},
                       {"text", spread->text()}};
  for (const RankedRow& one : summary.rows) json["options"].push_back(json_of(one));
  return json.dump();
}

}  // namespace

void bind_explore(py::module_& module) {
  module.def("explore", &explored, py::arg("scene"), py::arg("folder"), py::arg("stages"),
             py::arg("best"), py::arg("threads"), py::arg("report"), py::arg("stop"),
             py::arg("progress"));
}

}  // namespace vasorod::python
