// The program `vasorod`: command-line options and exit codes.
#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <unistd.h>

#include <vasorod/error.h>
#include <vasorod/version.h>

#include "app/commands.h"
#include "app/kernels.h"
#include "app/program.h"
#include "app/stop.h"
#include "data/sentence.h"
#include "numerics/blas.h"
#include "numerics/threads.h"

namespace {

using namespace vasorod;

// Options of all commands.
struct Common {
  CommandOptions command;
  double time_limit = 0;
  bool quiet = false;
};

// CLI11's range checks accept not-a-number and print the largest double in full.
CLI::Validator number(const std::string& expected, bool (*good)(double)) {
  return {[=](std::string& text) {
            double value = 0;
            const bool fine =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && good(value);
            return fine ? std::string() : "found " + text + ", expected " + expected;
          },
          "NUMBER"};
}

void add_output(CLI::App* app, Common* common) {
  app->add_option("-o,--output", common->command.folder,
                  "Result folder: absent, empty or an earlier result")
      ->required();
  app->add_flag("--json", common->command.json, "Print result.json on standard output");
  app->add_flag("-q,--quiet", common->quiet, "No progress");
}

void add_solving(CLI::App* app, Common* common) {
  app->add_option("--fidelity", common->command.solve.fidelity,
                  listed(fidelity_names()) + "; overrides the scene's")
      ->check(CLI::IsMember(fidelity_names()));
  app->add_flag("--certify", common->command.solve.certify,
                "Ask for the sign of the surfaces' smallest curvature too");
  app->add_option("--threads", common->command.solve.threads, "Threads of the solve")
      ->check(CLI::Range(1, 1024));
  app->add_option("--time-limit", common->time_limit,
                  "Seconds after which the best state so far is written")
      ->check(number("a number of at least 0", [](double value) { return value >= 0; }));
}

// An option of three finite numbers.
void add_vec3(CLI::App* app, const std::string& name, const std::string& help,
              const std::function<void(const Vec3&)>& take) {
  app->add_option_function<std::vector<double>>(
         name,
         [take](const std::vector<double>& v) {
           take({v.at(0), v.at(1), v.at(2)});
         },
         help)
      ->expected(3)
      ->check(number("a finite number", [](double) { return true; }));
}

void add_drawing(CLI::App* app, CommandOptions* command) {
  DrawOptions* draw = &command->draw;
  app->add_option("result", command->input, "Result folder")->required();
  app->add_option("-o,--output", command->folder, "Picture, a PNG file")->required();
  app->add_option("--colour", draw->colour, listed(drawable_colours()) + "; by default vessel")
      ->check(CLI::IsMember(drawable_colours()));
  app->add_option_function<std::vector<double>>(
         "--range",
         [draw](const std::vector<double>& v) {
           draw->range = {{v.at(0), v.at(1)}};
         },
         "Values of the first and the last colour, pressures in the scene's unit; by default as in "
         "report.html")
      ->expected(2)
      ->check(number("a finite number", [](double) { return true; }));
  app->add_option("--only", draw->only, "Names of the vessels to draw");
  add_vec3(app, "--from", "Direction towards the eye; by default as in report.html",
           [draw](const Vec3& v) { draw->from = v; });
  add_vec3(app, "--up", "Direction that is up; by default as in report.html",
           [draw](const Vec3& v) { draw->up = v; });
  add_vec3(app, "--centre", "Place in the middle; by default everything fits",
           [draw](const Vec3& v) { draw->centre = v; });
  app->add_option("--height", draw->height, "Height of what is visible, length units")
      ->check(number("a number above 0", [](double value) { return value > 0; }));
  app->add_option_function<std::vector<double>>(
         "--mark",
         [draw](const std::vector<double>& v) {
           for (std::size_t k = 0; k + 2 < v.size(); k += 3)
             draw->marks.emplace_back(v[k], v[k + 1], v[k + 2]);
         },
         "Place that a red ball marks; may be repeated")
      ->type_size(3)
      ->expected(-1)
      ->check(number("a finite number", [](double) { return true; }));
  app->add_option("--stripes", draw->stripes, "Stripes along each vessel, painted at rest")
      ->check(CLI::Range(1, 1000));
  app->add_flag("--rest", draw->rest, "The shape at rest");
  app->add_flag("--mesh", draw->mesh, "The edges of the triangles");
  app->add_flag("--rod", draw->rod, "Transparent walls, the rods and their directors inside");
  app->add_flag("--lettering", draw->lettering,
                "Names, a scale bar and the patient's axes where the surfaces name their space");
  app->add_option("--size", draw->size, "Width and height, pixels")->check(CLI::Range(16, 8192));
}

void add_exploring(CLI::App* app, ExploreCommandOptions* options, Common* common) {
  app->add_option("scene", options->scene, "Scene file (YAML) with surgery: glenn and explore")
      ->required();
  app->add_option("-o,--output", options->folder,
                  "Folder: absent, empty or of an earlier exploration, which goes on")
      ->required();
  app->add_option("--threads", options->threads,
                  "Options solved at once; by default one for each processor")
      ->check(CLI::Range(1, 1024));
  app->add_option("--stages", options->stages,
                  "Fidelities, separated by commas: the first solves every option, each other one "
                  "the best of the stage before; overrides the scene's")
      ->delimiter(',')
      ->check(CLI::IsMember(fidelity_names()));
  app->add_option("--best", options->best,
                  "Number of options that go on to the next stage; overrides the scene's")
      ->check(CLI::Range(1, 1000));
  auto* list = app->add_option(
      "--list", options->list,
      "Print the names of the options of this stage, from 1, and solve nothing: for a cluster");
  list->check(CLI::Range(1, 100));
  auto* only =
      app->add_option("--only", options->only,
                      "Solve this option alone, beside other such processes: for a cluster");
  only->excludes(list);
  app->add_option("--time-limit", common->time_limit,
                  "Seconds after which it stops with what is finished")
      ->check(number("a number of at least 0", [](double value) { return value >= 0; }))
      ->excludes(list)
      ->excludes(only);
  app->add_flag_callback(
      "--no-report", [options] { options->report = false; },
      "No pictures and no report.html of kept options");
  app->add_flag("-q,--quiet", common->quiet, "No progress");
}

void add_preparing(CLI::App* app, PrepareCommandOptions* options, Common* common) {
  PrepareRequest* request = &options->request;
  app->add_option("files", request->files,
                  "A mask (NIfTI, NRRD or MetaImage), or surfaces (VTP, STL, PLY or OBJ) of one "
                  "vessel")
      ->required();
  app->add_option("-o,--output", options->output, "Surface to write, a VTP file in mm")->required();
  app->add_option("--label", request->label, "Label of the mask; by default its only one");
  app->add_option("--units", request->units,
                  "The input's unit; by default as the file says, else guessed from the radius")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  app->add_option("--space", request->space, "Coordinate system to convert to")
      ->check(CLI::IsMember({"LPS", "RAS"}));
  app->add_option("--from-space", request->from_space,
                  "The input's coordinate system, where the file does not say")
      ->check(CLI::IsMember({"LPS", "RAS"}));
  app->add_option_function<std::vector<double>>(
         "--end",
         [request](const std::vector<double>& v) {
           for (std::size_t k = 0; k + 2 < v.size(); k += 3)
             request->ends.emplace_back(v[k], v[k + 1], v[k + 2]);
         },
         "Closed end to open: a place x,y,z near its tip, mm; may be repeated; by default all "
         "that are found")
      ->delimiter(',')
      ->type_size(3)
      ->expected(-1)
      ->check(number("a finite number", [](double) { return true; }));
  app->add_option("--cut-branches-below", request->cut_branches_below,
                  "Radius, mm, below which a branch is taken off and its stump closed")
      ->check(number("a number above 0", [](double value) { return value > 0; }));
  app->add_option("--remesh", request->remesh,
                  "Edge length, mm; by default a sixth of the radius where the wall is built anew")
      ->check(number("a number above 0", [](double value) { return value > 0; }));
  app->add_flag("--json", options->json, "Print the report as JSON on standard output");
  app->add_flag("-q,--quiet", common->quiet, "No progress");
}

bool has_command(const CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; })
              .empty();
}

int run(int argc, char** argv) {
  CLI::App app{
      "Vasorod: predicts how blood vessels bend, twist, stretch and touch when a surgeon re-joins "
      "them.\n"
      "Research software, not for clinical use."};
  app.set_version_flag("--version", "vasorod " + version());
  app.require_subcommand(1);
  Common common;

  auto* solve = app.add_subcommand("solve", "Solve one scene with the hybrid model");
  solve->add_option("scene", common.command.input, "Scene file (YAML)")->required();
  add_output(solve, &common);
  add_solving(solve, &common);
  solve->add_flag_callback(
      "--no-report", [&common] { common.command.report = false; },
      "Numbers and VTP only: no pictures and no report.html");
  solve
      ->add_option("--picture-width", common.command.picture_width,
                   "Width of every picture, pixels; by default 640 and 760")
      ->check(CLI::Range(320, 8192));

  auto* fit =
      app.add_subcommand("fit", "Centerline, radii and reference rod of one vessel surface");
  fit->add_option("surface", common.command.fit.surface, "Surface: VTP, STL, PLY or OBJ")
      ->required();
  fit->add_option("--length-unit", common.command.fit.length_unit, "The surface's unit")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  fit->add_option("--remesh", common.command.fit.remesh, "Remesh to this edge length first")
      ->check(number("a number above 0", [](double value) { return value > 0; }));
  add_output(fit, &common);

  PrepareCommandOptions prepare_options;
  auto* preparing = app.add_subcommand(
      "prepare", "A vessel surface of a mask or of a surface as segmentation leaves it");
  add_preparing(preparing, &prepare_options, &common);

  InitOptions init_options;
  auto* init = app.add_subcommand(
      "init", "A commented scene for vessel surfaces: ends, walls, a first cut and incision");
  init->add_option("surfaces", init_options.surfaces,
                   "Surfaces, one vessel each, called after it: svc.vtp, pulmonary_artery.stl...")
      ->required();
  init->add_option("-o,--output", init_options.scene, "Scene file to write; it must not exist")
      ->required();
  init->add_option("--length-unit", init_options.length_unit,
                   "The surfaces' unit; guessed from the radii where absent")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  init->add_flag("-q,--quiet", common.quiet, "No progress");

  ExploreCommandOptions explore_options;
  explore_options.threads = processors();
  auto* explore = app.add_subcommand(
      "explore",
      "Solves the options of a scene's operation and ranks them; goes on where it stopped");
  add_exploring(explore, &explore_options, &common);

  auto* compare = app.add_subcommand("compare", "How far two results of one scene are apart");
  compare->add_option("a", common.command.input, "Result folder A")->required();
  compare
      ->add_option("b", common.command.second,
                   "Result folder B: each rest point of A is looked up on B")
      ->required();
  compare->add_flag("--json", common.command.json, "Print JSON instead of the table");

  auto* draw = app.add_subcommand("draw", "One picture of a result, from a chosen side");
  add_drawing(draw, &common.command);

  const std::string first = argc > 1 ? argv[1] : "";
  if (!first.empty() && first[0] != '-' && !has_command(app, first)) {
    std::cerr << "vasorod: found the command \"" << first
              << "\", expected solve, fit, prepare, init, explore, compare or draw\n";
    return 2;
  }
  if (const auto ended = parsed(app, "vasorod", argc, argv)) return *ended;
  const bool alone = explore_options.list > 0 || !explore_options.only.empty();
  if (*solve || (*explore && !alone)) {
    common.command.solve.stop = explore_options.stop = stop_on_signal_or_after(common.time_limit);
    common.command.solve.stopped_by = [&] { return stopped_by_signal_or(common.time_limit); };
  } else {
    end_on_signal();
  }
  explore_options.progress = !common.quiet && isatty(STDERR_FILENO) != 0;
  if (explore_options.progress)
    common.command.solve.progress = init_options.progress = prepare_options.request.progress =
        [](const std::string& what) { std::cerr << "vasorod: " << what << '\n'; };

  const int exit_code = *solve       ? solve_command(common.command)
                        : *fit       ? fit_command(common.command)
                        : *draw      ? draw_command(common.command)
                        : *init      ? init_command(init_options)
                        : *preparing ? prepare_command(prepare_options)
                        : *explore   ? explore_command(explore_options)
                                     : compare_command(common.command);
  if (!std::cout.flush()) throw FileError("standard output: cannot be written");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  vasorod::choose_blas_kernels(argv);
  vasorod::end_blas_threads();
  return vasorod::as_program("vasorod", [&] { return run(argc, argv); });
}
