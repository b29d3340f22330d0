// The command line of the finite-element reference: vasorod-fem solve SCENE -o DIR.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <map>

#include "geometry/error.h"
#include "output/folder_replacement.h"
#include "output/result_folder.h"
#include "output/write_json.h"
#include "reference_fem/solve_scene.h"

extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace {

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) {
  stop_asked = true;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Arguments {
  std::string scene, output;
  vasorod::fem::SolveOptions options;
  std::vector<int> cells;
  int threads = 1;
  double time_limit = 0;
  bool quiet = false, json = false;
  std::string law;
};

int solve(Arguments& arguments) {
  using namespace vasorod;
  const double start = now();
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(arguments.threads);
  require_replaceable(arguments.output);
  const Scene scene = read_scene(arguments.scene, {.accept_pressure = true});
  const double read = now() - start;
  fem::SolveOptions& options = arguments.options;
  if (!arguments.cells.empty()) {
    options.around = arguments.cells[0];
    options.along = arguments.cells[1];
  }
  options.stepper.interrupted = [&] {
    return stop_asked || (arguments.time_limit > 0 && now() - start > arguments.time_limit);
  };
  const bool talk = !arguments.quiet && isatty(STDERR_FILENO) != 0;
  if (talk) options.progress = [](const std::string& line) { std::cerr << line << std::endl; };

  Result result = fem::solve_scene(scene, options);
  result.program = "vasorod-fem " VASOROD_VERSION;
  result.environment.blas = openblas_set_num_threads != nullptr ? "openblas" : "other";
  result.environment.threads = arguments.threads;
  result.seconds["read"] = read;
  result.seconds["total"] = now() - start;
  write_result_folder(result, arguments.output);
  if (arguments.json)
    std::cout << to_json(result) << std::flush;
  else if (!arguments.quiet)
    std::cout << result.scene << ": " << to_string(result.status) << ", written to " << arguments.output
              << std::endl;
  return result.status == Status::converged ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  using vasorod::fem::LawKind;
  using vasorod::fem::ModelKind;
  Arguments arguments;
  CLI::App app("Finite-element reference of Vasorod: a generated tube as a deal.II solid or shell");
  app.set_version_flag("--version", "vasorod-fem " VASOROD_VERSION);
  app.require_subcommand(1);
  CLI::App* command = app.add_subcommand("solve", "Solves one scene and writes a result folder");
  command->add_option("scene", arguments.scene, "scene file")->required();
  command->add_option("-o,--output", arguments.output, "result folder")->required();
  command->add_option("--model", arguments.options.model, "solid or shell")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ModelKind>{{"solid", ModelKind::solid}, {"shell", ModelKind::shell}}));
  command->add_option("--law", arguments.law, "biot, svk or neo-hookean (default: the scene's)")
      ->check(CLI::IsMember({"biot", "svk", "neo-hookean"}));
  command->add_option("--degree", arguments.options.degree, "polynomial degree, 1 to 4 (default 3)");
  command->add_option("--refine", arguments.options.refine,
                      "refinements by 3/2 after the first mesh: 0, 1 (default) or 2");
  command->add_option("--cells", arguments.cells, "cells of the first mesh: AROUND ALONG")->expected(2);
  command
      ->add_option("--first-step", arguments.options.stepper.first_step,
                   "first load step, fraction of the load (default 0.1)")
      ->check(CLI::Range(1e-4, 1.0));
  command
      ->add_option("--largest-step", arguments.options.stepper.largest_step,
                   "largest load step (default 0.25)")
      ->check(CLI::Range(1e-4, 1.0));
  command->add_option("--threads", arguments.threads, "threads of the linear algebra (default 1)")
      ->check(CLI::Range(1, 256));
  command
      ->add_option("--time-limit", arguments.time_limit, "seconds; then the last converged state is written")
      ->check(CLI::PositiveNumber);
  command->add_flag("--quiet", arguments.quiet, "no progress");
  command->add_flag("--json", arguments.json, "the result on standard output");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!arguments.law.empty())
    arguments.options.law = arguments.law == "biot"  ? LawKind::biot
                            : arguments.law == "svk" ? LawKind::svk
                                                     : LawKind::neo_hookean;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  try {
    return solve(arguments);
  } catch (const vasorod::InputError& error) {
    std::cerr << error.what() << std::endl;
    return 2;
  } catch (const vasorod::FileError& error) {
    std::cerr << error.what() << std::endl;
    return 3;
  }
}
