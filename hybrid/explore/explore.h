// Solves the options of a scene's operation and ranks them.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "explore/options.h"
#include "explore/ranking.h"

namespace vasorod {

/// What is under way.
struct ExploreProgress {
  /// "skin", a stage's fidelity; "fitting vessel svc"; "refining", "samples", "drawing"
  std::string doing;
  int done = 0, of = 0;                ///< options; of 0: no options yet
  std::optional<double> seconds_left;  ///< of this stage, at the pace so far
};

struct ExploreRequest {
  std::filesystem::path folder;
  int threads = 1;     ///< options at once, in as many processes, and threads of all
  bool report = true;  ///< pictures and report.html of kept results, pictures of index.html
  std::function<bool()> stop = [] { return false; };
  std::function<void(const ExploreProgress&)> progress = [](const ExploreProgress&) {};
  std::function<void()> begin_process;  ///< called first in each process; may be empty
};

struct ExploreSummary {
  std::vector<RankedRow> rows;          ///< every option
  bool finished = false;                ///< false: it was stopped before its end
  std::optional<RankingSpread> spread;  ///< of the best, with ExploreSpec::vary
  int found = 0;                        ///< solves that an earlier exploration had done
};

/// Solves the options of `scene.explore` stage by stage; then, at the fidelity of the last stage,
/// new ones near the best (`refine`), and samples of what is uncertain for the best (`vary`). The
/// folder has every finished option at once, options.csv at most a second later; options that it
/// has already, of the same scene, option, fidelity and program, are not solved again. Those of the
/// last stage are kept with their result folders. Numbers do not depend on `threads`. An option
/// that cannot be built is a row with its sentence. Throws InputError, FileError, StoppedEarly
/// while the vessels are fitted.
ExploreSummary explore(const Scene& scene, const ExploreRequest& request);

/// Names (Row::name()) of the options of a stage, from 0, of an exploration whose options are
/// solved by processes of their own, also on other machines with the same file system. Throws
/// InputError where there is no such stage, or where the stages before it are not finished; else as
/// explore().
std::vector<std::string> stage_options(const Scene& scene, const ExploreRequest& request,
                                       int stage);

/// Solves one option of stage_options() in this process, unless it is finished, beside others that
/// do the same; explore() then finds it. Throws InputError where no option of the scene has that
/// name; else as predict() and explore().
void explore_one(const Scene& scene, const ExploreRequest& request, const std::string& name);

}  // namespace vasorod
