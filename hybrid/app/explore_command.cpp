#include <cmath>
#include <iostream>

#include <vasorod/error.h>
#include <vasorod/predict.h>
#include <vasorod/read_scene.h>

#include "app/commands.h"
#include "app/stop.h"
#include "data/sentence.h"
#include "explore/explore.h"

namespace vasorod {
namespace {

// "1 h 5 min", "5 min 20 s", "20 s".
std::string time_text(double seconds) {
  const long whole = std::lround(seconds);
  const long hours = whole / 3600, minutes = whole / 60 % 60;
  if (hours > 0) return std::to_string(hours) + " h " + std::to_string(minutes) + " min";
  if (minutes > 0) return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole) + " s";
}

// One line of the terminal, written over until the exploration ends.
void show(const ExploreProgress& now) {
  std::cerr << "\r\033[Kvasorod: " << now.doing;
  if (now.of > 0) std::cerr << ": " << now.done << " of " << now.of;
  if (now.seconds_left && now.done < now.of)
    std::cerr << ", about " << time_text(*now.seconds_left) << " left";
  std::cerr << std::flush;
}

std::string counted(int count, const char* what) {
  return std::to_string(count) + (count == 1 ? " option" : " options") + what;
}

int say(const ExploreSummary& summary, const ExploreCommandOptions& options,
        const ExploreSpec& spec, const std::string& scene) {
  int refused = 0, failed = 0, converged = 0, open = 0, refined = 0;
  const int last = static_cast<int>(spec.stages.size()) - 1;
  std::string reason;
  for (const RankedRow& one : summary.rows) {
    const Row& row = one.row;
    refused += row.ending == Ending::not_built ? 1 : 0;
    failed += row.ending == Ending::failed ? 1 : 0;
    refined += row.refined ? 1 : 0;
    open += row.ending == Ending::open ? 1 : 0;
    converged +=
        row.ending == Ending::solved && row.status == Status::converged && row.stage == last ? 1
                                                                                             : 0;
    const bool lost = row.ending == Ending::not_built || row.ending == Ending::failed;
    if (reason.empty() && lost && !row.sentences.empty()) reason = row.sentences.front();
  }
  std::cout << scene << ": " << counted(static_cast<int>(summary.rows.size()), "") << ", "
            << converged << " converged at " << spec.stages.back();
  if (refined > 0) std::cout << ", " << refined << " found by refining";
  if (refused > 0) std::cout << ", " << refused << " cannot be built";
  if (failed > 0) std::cout << ", " << failed << " failed";
  if (open > 0) std::cout << ", " << open << " not solved yet";
  std::cout << '\n';
  if (converged == 0 && !reason.empty()) std::cout << "  " << reason << '\n';
  if (!summary.finished)
    std::cout << "  stopped before its end; the same command goes on from here\n";
  constexpr int most = 5;
  for (const RankedRow& one : summary.rows) {
    if (one.rank == 0 || one.rank > most) continue;
    Option option;
    option.values = one.row.values;
    std::cout << "  " << one.rank << ". " << option.text() << ": " << to_string(one.row.status)
              << " (" << one.row.fidelity << ")";
    if (std::isfinite(one.score)) std::cout << ", score " << number_text(one.score, 3);
    for (const std::string& name : one.past)
      std::cout << (name == one.past.front() ? ", past the threshold of " : ", ") << name;
    std::cout << '\n';
  }
  if (summary.spread) std::cout << "  " << summary.spread->text() << '\n';
  std::cout << "  " << (options.folder / "index.html").string() << '\n';
  return summary.finished && converged > 0 && failed == 0 ? 0 : 1;
}

}  // namespace

int explore_command(const ExploreCommandOptions& options) {
  Scene scene = read_scene(options.scene);
  if (scene.explore && !options.stages.empty()) scene.explore->stages = options.stages;
  if (scene.explore && options.best > 0) scene.explore->best = options.best;
  ExploreRequest request;
  request.folder = options.folder;
  request.threads = options.threads;
  request.report = options.report;
  request.stop = options.stop;
  request.begin_process = end_on_signal;
  if (options.list > 0) {
    for (const std::string& name : stage_options(scene, request, options.list - 1))
      std::cout << name << '\n';
    return 0;
  }
  if (!options.only.empty()) {
    explore_one(scene, request, options.only);
    return 0;
  }
  if (options.progress) request.progress = show;
  struct EndOfLine {
    bool wanted;
    ~EndOfLine() {
      if (wanted) std::cerr << "\r\033[K" << std::flush;
    }
  };
  const ExploreSummary summary = [&] {
    const EndOfLine end{options.progress};
    return explore(scene, request);
  }();
  return say(summary, options, *scene.explore, scene.name);
}

}  // namespace vasorod
