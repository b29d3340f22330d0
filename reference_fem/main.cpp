// The command line of the finite-element reference: vasorod-fem solve SCENE -o DIR.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <deal.II/base/mpi.h>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <unistd.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "numerics/blas.h"
#include "reference_fem/clock.h"
#include "reference_fem/solve_scene.h"
#include "result/folder_replacement.h"
#include "result/sha256.h"

namespace {

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) {
  stop_asked = true;
}

struct Arguments {
  std::string scene, output;
  vasorod::fem::SolveOptions options;
  std::vector<int> cells;
  int threads = 1;
  double time_limit = 0;
  bool quiet = false, json = false;
};

/// Whether mpirun (Open MPI, MPICH) started this process as one of several.
bool launched_by_mpi() {
  const auto asks_for_several = [](const char* size) {
    const char* value = std::getenv(size);
    return value != nullptr && std::atoi(value) > 1;
  };
  return asks_for_several("OMPI_COMM_WORLD_SIZE") || asks_for_several("PMI_SIZE");
}

int solve(Arguments& arguments) {
  using namespace vasorod;
  const double start = fem::now();
  set_blas_threads(arguments.threads);
  const fem::Processes& processes = arguments.options.processes;
  const Scene scene = read_scene(arguments.scene);
  if (processes.first()) {
    std::vector<std::filesystem::path> inputs = input_files(scene);
    if (!arguments.options.mesh.empty()) inputs.push_back(arguments.options.mesh);
    require_outside(arguments.output, inputs);
    require_replaceable(arguments.output);
  }
  const double read = fem::now() - start;
  fem::SolveOptions& options = arguments.options;
  if (!arguments.cells.empty()) {
    options.around = arguments.cells[0];
    options.along = arguments.cells[1];
  }
  options.stepper.interrupted = [&] {
    return processes.any(stop_asked ||
                         (arguments.time_limit > 0 && fem::now() - start > arguments.time_limit));
  };
  const bool talk = processes.first() && !arguments.quiet && isatty(STDERR_FILENO) != 0;
  if (talk) options.progress = [](const std::string& line) { std::cerr << line << std::endl; };

  Result result = fem::solve_scene(scene, options);
  result.program = "vasorod-fem " VASOROD_VERSION;
  result.environment.blas = blas_name();
  result.environment.threads = arguments.threads;
  result.environment.scene_hash = sha256_of_file(arguments.scene);
  result.seconds["read"] = read;
  result.seconds["total"] = fem::now() - start;
  if (processes.size() > 1)
    result.certificate.notes.push_back("solved by " + std::to_string(processes.size()) +
                                       " processes");
  const int code = result.status == Status::converged ? 0 : 1;
  if (!processes.first()) return code;
  write_result_folder(result, arguments.output);
  if (arguments.json)
    std::cout << to_json(result) << std::flush;
  else if (!arguments.quiet)
    std::cout << result.scene << ": " << to_string(result.status) << ", written to "
              << arguments.output << std::endl;
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using vasorod::fem::LawKind;
  using vasorod::fem::ModelKind;
  Arguments arguments;
  CLI::App app(
      "Finite-element reference of Vasorod: a generated tube, or a join of two, as a "
      "deal.II solid or shell");
  app.set_version_flag("--version", "vasorod-fem " VASOROD_VERSION);
  app.require_subcommand(1);
  CLI::App* command = app.add_subcommand("solve", "Solves one scene and writes a result folder");
  command->add_option("scene", arguments.scene, "scene file")->required();
  command->add_option("-o,--output", arguments.output, "result folder")->required();
  command->add_option("--model", arguments.options.model, "solid or shell")
      ->transform(CLI::CheckedTransformer(std::map<std::string, ModelKind>{
          {"solid", ModelKind::solid}, {"shell", ModelKind::shell}}));
  command
      ->add_option("--law", arguments.options.law,
                   "biot, svk, neo-hookean or split-neo-hookean (quasi-incompressible at a "
                   "Poisson's ratio near "
                   "0.5; solid only); default: the scene's")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, LawKind>{{"biot", LawKind::biot},
                                         {"svk", LawKind::svk},
                                         {"neo-hookean", LawKind::neo_hookean},
                                         {"split-neo-hookean", LawKind::split_neo_hookean}}));
  command->add_option("--degree", arguments.options.degree,
                      "polynomial degree, 1 to 4 (default 3)");
  command->add_option(
      "--refine", arguments.options.refine,
      "refinements after the first mesh, by 3/2 (a --mesh by 2): 0, 1 (default) or 2");
  command
      ->add_option(
          "--cells", arguments.cells,
          "cells of the first mesh: AROUND ALONG; of a join around the seam and along the vein "
          "(0: as large as the others)")
      ->expected(2);
  command
      ->add_option("--mesh", arguments.options.mesh,
                   "gmsh file of the tube's wall (hexahedra; quadrilaterals for the shell) in "
                   "place of --cells")
      ->excludes("--cells");
  command
      ->add_option("--first-step", arguments.options.stepper.first_step,
                   "first load step, fraction of the load (default 0.1)")
      ->check(CLI::Range(1e-4, 1.0));
  command
      ->add_option("--largest-step", arguments.options.stepper.largest_step,
                   "largest load step (default 0.25)")
      ->check(CLI::Range(1e-4, 1.0));
  command->add_flag_callback(
      "--no-jumps", [&arguments] { arguments.options.stepper.largest_jump = 0.7; },
      "take no step that snaps to another branch; follow the path through its limit points "
      "instead");
  command
      ->add_option("--arc-steps", arguments.options.stepper.arc_steps,
                   "steps in arc length past a limit point (default 300; 0: the path ends there)")
      ->check(CLI::Range(0, 100000));
  command->add_option("--threads", arguments.threads, "threads of the linear algebra (default 1)")
      ->check(CLI::Range(1, 256));
  command
      ->add_option("--time-limit", arguments.time_limit,
                   "seconds; then the last converged state is written")
      ->check(CLI::PositiveNumber);
  command->add_flag("--quiet", arguments.quiet, "no progress");
  command->add_flag("--json", arguments.json, "the result on standard output");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::optional<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
  if (launched_by_mpi()) {
    mpi.emplace(argc, argv, 1);
    arguments.options.processes = vasorod::fem::Processes::world();
  }
  const bool speaks = arguments.options.processes.first();
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  try {
    return solve(arguments);
  } catch (const vasorod::InputError& error) {
    if (speaks) std::cerr << error.what() << std::endl;
    return 2;
  } catch (const vasorod::FileError& error) {
    if (speaks) std::cerr << error.what() << std::endl;
    return 3;
  } catch (const std::bad_alloc&) {
    if (speaks)
      std::cerr << "found no memory left, expected a scene that fits into it: fewer cells or a "
                   "lower degree"
                << std::endl;
    return 3;
  }
}
