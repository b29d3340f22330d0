#include "explore/explore.h"

#include <algorithm>
#include <chrono>

#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "explore/apart.h"
#include "explore/explore_folder.h"
#include "explore/index_page.h"
#include "explore/option_names.h"
#include "explore/option_pictures.h"
#include "explore/table.h"
#include "predict/fitted_vessels.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Explorer {
 public:
  Explorer(const Scene& scene, const ExploreRequest& request)
      : scene_(scene), spec_(*scene.explore), request_(request), folder_(request.folder) {}

  ExploreSummary explore() {
    fit();
    bool going = true;
    for (int stage = 0; going && stage < static_cast<int>(spec_.stages.size()); ++stage)
      going = solve(stage);
    ExploreSummary summary;
    summary.rows = ranked(rows_, spec_);
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
    write_whole(folder_.path() / "index.html", index_html(page, summary.rows));
    return summary;
  }

 private:
  void fit() {
    SolveOptions options;
    options.stop = request_.stop;
    options.progress = [&](const std::string& stage) { request_.progress({stage, 0, 0, {}}); };
    fitted_ = fit_vessels(scene_, options);
    const bool moved = !spec_.incision_along.empty() || !spec_.around_deg.empty();
    options_ = options_of(scene_, moved ? incision_by_fraction(scene_, fitted_) : PickSpec());
    const OptionNames names(scene_, fitted_.inputs, request_.scene_text);
    for (const Option& option : options_) {
      Row& row = rows_.emplace_back();
      row.values = option.values;
      row.option = names.of(option);
    }
  }

  bool last(int stage) const { return stage + 1 == static_cast<int>(spec_.stages.size()); }

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
      const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& other) {
        return other.option == one.row.option;
      });
      all.push_back(static_cast<int>(row - rows_.begin()));
      --left;
    }
    return all;
  }

  // False: stopped.
  bool solve(int stage) {
    std::vector<std::pair<int, Row>> open;  // index into rows_, the row to fill
    const std::vector<int> all = chosen(stage);
    for (const int k : all) {
      Row row = rows_[index(k)];
      row.stage = stage;
      row.fidelity = spec_.stages[index(stage)];
      if (folder_.find(row, last(stage))) {
        rows_[index(k)] = row;
        ++found_;
      } else {
        open.emplace_back(k, row);
      }
    }
    const int done = static_cast<int>(all.size() - open.size());
    const Clock::time_point start = Clock::now();
    Clock::time_point written = start;
    int ended = 0;
    const auto say = [&] {
      ExploreProgress now{
          spec_.stages[index(stage)], done + ended, static_cast<int>(all.size()), {}};
      if (ended > 0)
        now.seconds_left =
            seconds_since(start) / ended * (static_cast<double>(open.size()) - ended);
      request_.progress(now);
    };
    say();
    return run(
        open.size(), [&](int i) { return solved(open[index(i)]); },
        [&](int i, const ApartEnding& ending) {
          take(open[index(i)], ending);
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

  // In a process of its own.
  std::string solved(std::pair<int, Row> open) const {
    Row& row = open.second;
    const Scene scene = with_option(scene_, options_[index(open.first)], row.option);
    SolveOptions options;
    options.fidelity = row.fidelity;
    const Clock::time_point start = Clock::now();
    try {
      Result result = predict(scene, options, fitted_);
      row.seconds = seconds_since(start);
      take_result(result, row);
      if (last(row.stage)) {
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

  void take(const std::pair<int, Row>& open, const ApartEnding& ending) {
    if (ending.file_error) throw FileError(*ending.file_error);
    Row row = open.second;
    if (ending.answer) {
      read_row(*ending.answer, row);
      folder_.finish(row);
    } else {
      row.ending = Ending::failed;
      row.criteria.clear();
      row.sentences = {ending.failure};
    }
    rows_[index(open.first)] = row;
  }

  void write_table(const std::vector<RankedRow>& rows) const {
    write_whole(folder_.path() / "options.csv", options_csv(rows, option_keys(spec_)));
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
  std::vector<Option> options_;
  std::vector<Row> rows_;
  int found_ = 0;
};

}  // namespace

ExploreSummary explore(const Scene& scene, const ExploreRequest& request) {
  if (!scene.glenn)
    throw InputError(
        place_in(scene) +
        ": found no surgery: glenn, expected the operation whose options are explored");
  if (!scene.explore)
    throw InputError(place_in(scene) +
                     ": found no explore, expected explore: {cut_along: ..., rotation_deg: ...} "
                     "with the options' values");
  return Explorer(scene, request).explore();
}

}  // namespace vasorod
