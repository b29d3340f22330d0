#include "explore/explore.h"

#include <algorithm>
#include <chrono>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "data/whole_file.h"
#include "explore/apart.h"
#include "explore/explore_folder.h"
#include "explore/index_page.h"
#include "explore/option_names.h"
#include "explore/option_pictures.h"
#include "explore/pattern_search.h"
#include "explore/table.h"
#include "explore/uncertain_scene.h"
#include "predict/fitted_vessels.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// One solve, and what came of it.
struct Job {
  Row row;
  const Option* option = nullptr;
  const Sample* sample = nullptr;  // null: without uncertainty
  bool keeps = false;              // its result folder
};

class Explorer {
 public:
  Explorer(const Scene& scene, const ExploreRequest& request,
           ExploreFolder::Sharing sharing = ExploreFolder::Sharing::alone)
      : scene_(scene), spec_(*scene.explore), request_(request), folder_(request.folder, sharing) {}

  ExploreSummary explore() {
    fit();
    bool going = true;
    for (int stage = 0; going && stage < static_cast<int>(spec_.stages.size()); ++stage)
      going = solve(stage);
    if (going && spec_.refine) going = refine(*spec_.refine);
    ExploreSummary summary;
    summary.rows = ranked(rows_, spec_);
    if (going && spec_.vary) going = vary(*spec_.vary, summary);
    summary.found = found_;
    summary.finished = going;
    write_table(summary.rows);
    IndexPage page = draw(summary);
    for (const RankedRow& one : summary.rows)
      if (!one.row.folder.empty())
        for (const char* name : {"/result.json", "/report.html"})
          if (fs::exists(folder_.path() / (one.row.folder + name)))
            page.links[one.row.option] = one.row.folder + name;
    page.scene = scene_.name;
    page.length_unit = scene_.units.length;
    page.finished = summary.finished;
    page.keys = option_keys(spec_);
    page.criteria = criteria_for(spec_);
    if (summary.spread) page.spread = summary.spread->text();
    write_whole_file(folder_.path() / "index.html", index_html(page, summary.rows));
    return summary;
  }

  std::vector<std::string> names(int stage) {
    fit();
    for (int before = 0; before < stage; ++before) {
      int open = 0;
      for (const int k : chosen(before)) {
        Row row = at_stage(k, before);
        open += folder_.find(row, false) ? 0 : 1;
        rows_[index(k)] = row;
      }
      if (open > 0)
        throw InputError("stage " + std::to_string(stage + 1) + ": found " + std::to_string(open) +
                         " options of stage " + std::to_string(before + 1) +
                         " that are not finished, expected none");
    }
    std::vector<std::string> names;
    for (const int k : chosen(stage)) names.push_back(at_stage(k, stage).name());
    return names;
  }

  void solve_one(const std::string& name) {
    fit();
    for (int stage = last_stage(); stage >= 0; --stage)
      for (int k = 0; k < static_cast<int>(rows_.size()); ++k) {
        Job job{at_stage(k, stage), &options_[index(k)], nullptr, stage == last_stage()};
        if (job.row.name() != name) continue;
        if (folder_.find(job.row, job.keeps)) return;
        read_row(solved(job), job.row);
        folder_.finish(job.row);
        return;
      }
    throw InputError("found no option " + in_quotes(name) +
                     " of this scene, expected a name that --list prints");
  }

 private:
  Row at_stage(int k, int stage) const {
    Row row = rows_[index(k)];
    row.stage = stage;
    row.fidelity = spec_.stages[index(stage)];
    return row;
  }

  void fit() {
    SolveOptions options;
    options.stop = request_.stop;
    options.progress = [&](const std::string& stage) { request_.progress({stage, 0, 0, {}}); };
    fitted_ = fit_vessels(scene_, options);
    const bool moved = !spec_.incision_along.empty() || !spec_.around_deg.empty();
    if (moved) incision_ = incision_by_fraction(scene_, fitted_);
    names_.emplace(scene_, fitted_.inputs);
    for (const Option& option : options_of(scene_, incision_)) add(option, false);
    if (!spec_.vary) return;
    samples_ = samples_of(*spec_.vary);
    for (const Sample& sample : samples_) with_sampled_walls(scene_, *spec_.vary, sample);
  }

  void add(const Option& option, bool refined) {
    options_.push_back(option);
    Row& row = rows_.emplace_back();
    row.values = option.values;
    row.option = names_->of(option);
    row.refined = refined;
  }

  int last_stage() const { return static_cast<int>(spec_.stages.size()) - 1; }

  std::size_t place_of_option(const std::string& name) const {
    const auto row = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const Row& other) { return other.option == name; });
    return static_cast<std::size_t>(row - rows_.begin());
  }

  // The options of a stage, in the order of `rows_`.
  std::vector<int> chosen(int stage) const {
    std::vector<int> all;
    if (stage == 0) {
      for (int k = 0; k < static_cast<int>(rows_.size()); ++k) all.push_back(k);
      return all;
    }
    int left = spec_.best;
    for (const RankedRow& one : ranked(rows_, spec_)) {
      if (left == 0) break;
      if (one.row.ending != Ending::solved || one.row.stage != stage - 1) continue;
      all.push_back(static_cast<int>(place_of_option(one.row.option)));
      --left;
    }
    return all;
  }

  // A stage ends with its last option, which one processor solves while the others have little to
  // do: those that are expected to take longest begin first. They are those farthest out of the
  // model's range, whose walls wrinkle and fold.
  void begin_with_longest(std::vector<int>& places) const {
    const auto validity = [this](int k) {
      const auto& criteria = rows_[index(k)].criteria;
      const auto known = criteria.find("validity");
      return known == criteria.end() ? 0 : known->second;
    };
    std::stable_sort(places.begin(), places.end(),
                     [&](int a, int b) { return validity(a) > validity(b); });
  }

  // False: stopped.
  bool solve(int stage) {
    std::vector<int> places = chosen(stage);
    begin_with_longest(places);
    return solve(places, stage, spec_.stages[index(stage)]);
  }

  // Solves rows at a stage.
  bool solve(const std::vector<int>& places, int stage, const std::string& doing) {
    std::vector<Job> jobs;
    for (const int k : places) {
      Job& job = jobs.emplace_back();
      job.row = at_stage(k, stage);
      job.option = &options_[index(k)];
      job.keeps = stage == last_stage();
    }
    return work(jobs, doing, [&](std::size_t i) { rows_[index(places[i])] = jobs[i].row; });
  }

  // Fills the rows of the jobs: those that are finished already, then the others in processes.
  // `done` is called for each, in any order. False: stopped.
  bool work(std::vector<Job>& jobs, const std::string& doing,
            const std::function<void(std::size_t)>& done) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (folder_.find(jobs[i].row, jobs[i].keeps)) {
        ++found_;
        done(i);
      } else {
        open.push_back(i);
      }
    }
    const int before = static_cast<int>(jobs.size() - open.size());
    const Clock::time_point start = Clock::now();
    Clock::time_point written = start;
    int ended = 0;
    const auto say = [&] {
      ExploreProgress now{doing, before + ended, static_cast<int>(jobs.size()), {}};
      if (ended > 0)
        now.seconds_left =
            seconds_since(start) / ended * (static_cast<double>(open.size()) - ended);
      request_.progress(now);
    };
    say();
    return run(
        open.size(), [&](int i) { return solved(jobs[open[index(i)]]); },
        [&](int i, const ApartEnding& ending) {
          take(jobs[open[index(i)]].row, ending);
          done(open[index(i)]);
          ++ended;
          say();
          if (seconds_since(written) < 1) return;
          write_table(ranked(rows_, spec_));
          written = Clock::now();
        });
  }

  bool run(std::size_t count, const std::function<std::string(int)>& job,
           const std::function<void(int, const ApartEnding&)>& take) {
    return run_apart(static_cast<int>(count), job, take, {request_.threads, request_.stop, [&] {
                                                            if (request_.begin_process)
                                                              request_.begin_process();
                                                            folder_.leave_lock();
                                                          }});
  }

  // In one of the processes.
  std::string solved(Job job) const {
    Row& row = job.row;
    SolveOptions options;
    options.fidelity = row.fidelity;
    const Clock::time_point start = Clock::now();
    try {
      const Scene scene = with_option(scene_, *job.option, row.option);
      Result result =
          job.sample ? predicted(scene, *job.sample, options) : predict(scene, options, fitted_);
      row.seconds = seconds_since(start);
      take_result(result, row);
      if (job.keeps) {
        row.folder = ExploreFolder::kept(row);
        row.look = look_of(result);
        write_result_folder(result, folder_.path() / row.folder, {{}, 1, request_.report});
      }
    } catch (const InputError& error) {
      row.ending = Ending::not_built;
      row.sentences = {error.what()};
      row.criteria.clear();
    }
    return row_json(row);
  }

  Result predicted(const Scene& scene, const Sample& sample, const SolveOptions& options) const {
    const Scene changed = with_sample(scene, *spec_.vary, sample, fitted_);
    return predict(changed, options, with_walls(fitted_, changed));
  }

  void take(Row& row, const ApartEnding& ending) {
    if (ending.file_error) throw FileError(*ending.file_error);
    if (ending.answer) {
      read_row(*ending.answer, row);
      folder_.finish(row);
    } else {
      row.ending = Ending::failed;
      row.criteria.clear();
      row.sentences = {ending.failure};
    }
  }

  // The best options of the last stage, in their order.
  std::vector<std::size_t> best(int count) const {
    std::vector<std::size_t> places;
    for (const RankedRow& one : ranked(rows_, spec_))
      if (static_cast<int>(places.size()) < count && one.row.ending == Ending::solved &&
          one.row.stage == last_stage())
        places.push_back(place_of_option(one.row.option));
    return places;
  }

  // False: stopped.
  bool refine(const RefineSpec& spec) {
    const std::vector<RefinedKey> keys = refined_keys(spec_);
    int left = spec.evaluations;
    for (const std::size_t start : best(spec.best)) {
      PatternSearch search(keys, options_[start], incision_);
      std::size_t centre = start;
      while (left > 0 && !search.ended()) {
        std::vector<int> unsolved;
        std::vector<std::size_t> polled;
        for (const Option& option : search.poll()) {
          const std::size_t place = place_of_option(names_->of(option));
          if (place == rows_.size()) {
            if (left == 0) continue;
            add(option, true);
            --left;
          }
          if (rows_[place].stage != last_stage()) unsolved.push_back(static_cast<int>(place));
          polled.push_back(place);
        }
        if (!solve(unsolved, last_stage(), "refining")) return false;
        // The first is the best; the centre stays where another is only as good.
        std::vector<Row> rows{rows_[centre]};
        for (const std::size_t place : polled) rows.push_back(rows_[place]);
        const std::size_t first = place_of_option(ranked(rows, spec_).front().row.option);
        search.go_on(first != centre, options_[first]);
        centre = first;
      }
    }
    return true;
  }

  // Samples of the best options. False: stopped.
  bool vary(const VarySpec& spec, ExploreSummary& summary) {
    std::vector<std::size_t> places = best(spec.best);
    const std::string fidelity = spec.fidelity.value_or(spec_.stages.back());
    std::vector<Job> jobs;
    const auto add_job = [&](std::size_t place, const Sample* sample) {
      Job& job = jobs.emplace_back();
      job.option = &options_[place];
      job.sample = sample;
      job.row.values = options_[place].values;
      job.row.option = names_->of(options_[place], sample ? sample->text : "");
      job.row.stage = last_stage();
      job.row.fidelity = fidelity;
    };
    if (fidelity != spec_.stages.back()) {  // their order at this fidelity
      for (const std::size_t place : places) add_job(place, nullptr);
      if (!work(jobs, "samples", [](std::size_t) {})) return false;
      std::vector<Row> rows;
      for (const Job& job : jobs) rows.push_back(job.row);
      places.clear();
      for (const RankedRow& one : ranked(rows, spec_))
        places.push_back(place_of_option(one.row.option));
      jobs.clear();
    }
    for (const Sample& sample : samples_)
      for (const std::size_t place : places) add_job(place, &sample);
    if (!work(jobs, "samples", [](std::size_t) {})) return false;
    std::vector<std::vector<Row>> samples;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (i % places.size() == 0) samples.emplace_back();
      samples.back().push_back(jobs[i].row);
    }
    summary.spread = spread_of(samples, spec_);
    for (RankedRow& one : summary.rows)
      for (std::size_t k = 0; k < places.size() && k < summary.spread->options.size(); ++k)
        if (rows_[places[k]].option == one.row.option) one.spread = summary.spread->options[k];
    return true;
  }

  void write_table(const std::vector<RankedRow>& rows) const {
    write_whole_file(folder_.path() / "options.csv", options_csv(rows, option_keys(spec_)));
  }

  // The best kept results side by side.
  IndexPage draw(ExploreSummary& summary) {
    constexpr std::size_t most = 24;
    IndexPage page;
    std::vector<Row> kept;
    std::vector<Look> looks;
    for (const RankedRow& one : summary.rows)
      if (one.row.look && kept.size() < most) {
        kept.push_back(one.row);
        looks.push_back(*one.row.look);
      }
    if (!request_.report || !summary.finished || kept.empty()) return page;
    const Look look = common_look(looks);
    page.colours = option_colours(kept);
    int drawn = 0;
    const auto say = [&] {
      request_.progress({"drawing", drawn, static_cast<int>(kept.size()), {}});
    };
    say();
    const bool whole = run(
        kept.size(),
        [&](int k) {
          return option_pictures(folder_.path() / kept[index(k)].folder, look, page.colours);
        },
        [&](int k, const ApartEnding& ending) {
          if (ending.file_error) throw FileError(*ending.file_error);
          if (ending.answer) page.pictures[kept[index(k)].option] = *ending.answer;
          ++drawn;
          say();
        });
    if (!whole) summary.finished = false;
    return page;
  }

  const Scene& scene_;
  const ExploreSpec& spec_;
  const ExploreRequest& request_;
  ExploreFolder folder_;
  FittedVessels fitted_;
  PickSpec incision_;  // by fraction, where options move it
  std::optional<OptionNames> names_;
  std::vector<Option> options_;
  std::vector<Row> rows_;  // of the options
  std::vector<Sample> samples_;
  int found_ = 0;
};

void require_options(const Scene& scene) {
  if (!scene.glenn)
    throw InputError(
        place_in(scene) +
        ": found no surgery: glenn, expected the operation whose options are explored");
  if (!scene.explore)
    throw InputError(place_in(scene) +
                     ": found no explore, expected explore: {cut_along: ..., rotation_deg: ...} "
                     "with the options' values");
}

}  // namespace

ExploreSummary explore(const Scene& scene, const ExploreRequest& request) {
  require_options(scene);
  return Explorer(scene, request).explore();
}

std::vector<std::string> stage_options(const Scene& scene, const ExploreRequest& request,
                                       int stage) {
  require_options(scene);
  const auto stages = static_cast<int>(scene.explore->stages.size());
  if (stage < 0 || stage >= stages)
    throw InputError("stage: found " + std::to_string(stage + 1) + ", expected 1 to " +
                     std::to_string(stages));
  return Explorer(scene, request, ExploreFolder::Sharing::together).names(stage);
}

void explore_one(const Scene& scene, const ExploreRequest& request, const std::string& name) {
  require_options(scene);
  Explorer(scene, request, ExploreFolder::Sharing::together).solve_one(name);
}

}  // namespace vasorod
