// Explorations of a small shunt of two tubes.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "explore/explore.h"
#include "explore/small_exploration.h"
#include "explore/uncertain_scene.h"
#include "result/read_folder.h"
#include "scratch_folder.h"

namespace vasorod::testing {
namespace {

namespace fs = std::filesystem;

class Explore : public ScratchFolder {
 protected:
  ExploreRequest request(const std::string& name = "dir") const {
    ExploreRequest made;
    made.folder = folder / name;
    made.report = false;
    return made;
  }
};

const RankedRow& option_with(const ExploreSummary& summary, const std::string& value) {
  return *std::find_if(summary.rows.begin(), summary.rows.end(), [&](const RankedRow& one) {
    return std::any_of(one.row.values.begin(), one.row.values.end(),
                       [&](const auto& pair) { return pair.second == value; });
  });
}

TEST_F(Explore, NumbersAreThoseOfPredictWhateverTheNumberOfProcesses) {
  const Scene scene = small_exploration("rotation_deg: [0, 40, -70], stages: skin");
  ExploreRequest two = request("two");
  two.threads = 2;
  const ExploreSummary one = explore(scene, request("one")), both = explore(scene, two);
  ASSERT_EQ(one.rows.size(), 3U);
  EXPECT_TRUE(one.finished);
  for (const double degrees : {0.0, 40.0, -70.0}) {
    Scene alone = scene;
    alone.explore.reset();
    alone.glenn->rotation_deg = degrees;
    Row row;
    take_result(predict(alone), row);
    ASSERT_TRUE(row.criteria.contains("twist_shear"));
    const std::string value = std::to_string(static_cast<int>(degrees));
    EXPECT_EQ(option_with(one, value).row.criteria, row.criteria) << value;
    EXPECT_EQ(option_with(both, value).row.criteria, row.criteria) << value;
  }
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(one.rows[k].row.option, both.rows[k].row.option) << k;
}

// The vein is straight and comes from above: turning it twists it, whatever the side.
TEST_F(Explore, MoreTwistRanksBelowLess) {
  const ExploreSummary summary =
      explore(small_exploration("rotation_deg: [120, 0, 60], stages: skin"), request());
  const auto rotation = [&](std::size_t k) { return summary.rows[k].row.values.front().second; };
  EXPECT_EQ(rotation(0), "0");
  EXPECT_EQ(rotation(1), "60");
  EXPECT_EQ(rotation(2), "120");
}

TEST_F(Explore, WhatCannotBeBuiltIsARowWithItsSentence) {
  const ExploreSummary summary = explore(
      small_exploration("incision_along: [0.5, 0.01], around_deg: 0, stages: skin"), request());
  EXPECT_TRUE(summary.finished);
  const RankedRow& refused = option_with(summary, "0.01");
  EXPECT_EQ(refused.row.ending, Ending::not_built);
  ASSERT_EQ(refused.row.sentences.size(), 1U);
  EXPECT_NE(refused.row.sentences.front().find(", expected "), std::string::npos)
      << refused.row.sentences.front();
  EXPECT_EQ(option_with(summary, "0.5").row.ending, Ending::solved);
  EXPECT_EQ(option_with(summary, "0.5").rank, 1);
}

TEST_F(Explore, ASecondRunSolvesOnlyWhatIsNew) {
  const ExploreSummary first =
      explore(small_exploration("rotation_deg: [0, 60], stages: skin"), request());
  EXPECT_EQ(first.found, 0);
  const ExploreSummary second =
      explore(small_exploration("rotation_deg: [0, 60, 90], stages: skin, weights: {stretch: 0}"),
              request());
  EXPECT_EQ(second.found, 2);
  EXPECT_EQ(option_with(second, "60").row.criteria, option_with(first, "60").row.criteria);
  EXPECT_NE(option_with(second, "60").score, option_with(first, "60").score);
}

TEST_F(Explore, StoppedItKeepsWhatIsFinishedAndGoesOnFromThere) {
  const Scene scene = small_exploration("rotation_deg: [0, 30, 60, 90, 120], stages: skin");
  bool stop = false;
  ExploreRequest stopped = request();
  stopped.stop = [&] { return stop; };
  stopped.progress = [&](const ExploreProgress& now) { stop = now.done >= 2; };
  const ExploreSummary first = explore(scene, stopped);
  EXPECT_FALSE(first.finished);
  const auto solved = std::count_if(first.rows.begin(), first.rows.end(), [](const RankedRow& one) {
    return one.row.ending == Ending::solved;
  });
  EXPECT_EQ(solved, 2);
  EXPECT_TRUE(fs::exists(folder / "dir" / "options.csv"));
  EXPECT_TRUE(fs::exists(folder / "dir" / "index.html"));
  const ExploreSummary second = explore(scene, request());
  EXPECT_TRUE(second.finished);
  EXPECT_EQ(second.found, 2);
  const ExploreSummary whole = explore(scene, request("whole"));
  ASSERT_EQ(whole.rows.size(), second.rows.size());
  for (std::size_t k = 0; k < whole.rows.size(); ++k) {
    EXPECT_EQ(whole.rows[k].row.option, second.rows[k].row.option) << k;
    EXPECT_EQ(whole.rows[k].row.criteria, second.rows[k].row.criteria) << k;
  }
}

TEST_F(Explore, TheLastStageIsKeptWithItsFolders) {
  const ExploreSummary summary = explore(
      small_exploration("rotation_deg: [0, 60, 90], stages: [rod, skin], best: 2"), request());
  ASSERT_EQ(summary.rows.size(), 3U);
  EXPECT_EQ(summary.rows[0].row.fidelity, "skin");
  EXPECT_EQ(summary.rows[1].row.fidelity, "skin");
  EXPECT_EQ(summary.rows[2].row.fidelity, "rod");
  EXPECT_EQ(summary.rows[2].row.values.front().second, "90");
  EXPECT_TRUE(summary.rows[2].row.folder.empty());
  for (std::size_t k = 0; k < 2; ++k) {
    const Row& row = summary.rows[k].row;
    const Result kept = read_result_folder(folder / "dir" / row.folder);
    EXPECT_EQ(kept.scene, "small-glenn-" + row.option);
    EXPECT_EQ(kept.fidelity, "skin");
    double shear = 0;
    std::ifstream stream(folder / "dir" / row.folder / "result.json");
    const auto json = nlohmann::json::parse(stream);
    for (const auto& metrics : json["metrics"])
      shear = std::max(shear, metrics["largest_twist_shear"].get<double>());
    EXPECT_EQ(shear, row.criteria.at("twist_shear"));
  }
  // A lost folder is made again.
  fs::remove_all(folder / "dir" / summary.rows[0].row.folder);
  const ExploreSummary again = explore(
      small_exploration("rotation_deg: [0, 60, 90], stages: [rod, skin], best: 2"), request());
  EXPECT_EQ(again.found, 4);
  EXPECT_TRUE(fs::exists(folder / "dir" / summary.rows[0].row.folder / "result.json"));
}

// Twist wrinkles the vein, so that more of it takes longer.
TEST_F(Explore, WhatIsExpectedToTakeLongestBeginsFirst) {
  const ExploreSummary summary = explore(
      small_exploration("rotation_deg: [60, 0, 90], stages: [rod, skin], best: 3"), request());
  std::vector<std::pair<fs::file_time_type, std::string>> ended;
  for (const RankedRow& one : summary.rows)
    ended.emplace_back(
        fs::last_write_time(folder / "dir" / "finished" / (one.row.name() + ".json")),
        one.row.values.front().second);
  std::sort(ended.begin(), ended.end());
  ASSERT_EQ(ended.size(), 3U);
  EXPECT_EQ(ended[0].second, "90");
  EXPECT_EQ(ended[1].second, "60");
  EXPECT_EQ(ended[2].second, "0");
}

// The same samples for every option, each as if its scene had been written by hand.
TEST_F(Explore, SamplesAreThoseOfPredictWithTheirWallsAndPicks) {
  Scene scene = small_exploration("rotation_deg: [0, 40, 90], stages: skin");
  VarySpec& spec = scene.explore->vary.emplace();
  spec.uncertain = {{Uncertain::What::thickness, "svc", 0.8, 1.2, 0},
                    {Uncertain::What::cut, "", 0, 0, 0.5}};
  spec.samples = 4;
  spec.best = 2;
  const ExploreSummary summary = explore(scene, request());
  ASSERT_TRUE(summary.finished);
  ASSERT_TRUE(summary.spread);
  EXPECT_EQ(summary.spread->samples, 4);
  ASSERT_TRUE(summary.rows[1].spread);
  EXPECT_FALSE(summary.rows[2].spread);
  const FittedVessels fitted = fit_vessels(scene);
  for (const std::size_t rank : {0, 1}) {
    std::vector<double> shears;
    for (const Sample& sample : samples_of(spec)) {
      Scene alone = with_sample(scene, spec, sample, fitted);
      alone.explore.reset();
      alone.glenn->rotation_deg = std::stod(summary.rows[rank].row.values.front().second);
      Row row;
      take_result(predict(alone), row);
      shears.push_back(row.criteria.at("twist_shear"));
    }
    const auto [low, high] = summary.rows[rank].spread->intervals.at("twist_shear");
    EXPECT_NEAR(low, percentile(shears, 0.05), 1e-9);
    EXPECT_NEAR(high, percentile(shears, 0.95), 1e-9);
    EXPECT_EQ(summary.rows[rank].spread->converged, 4);
  }
  const ExploreSummary again = explore(scene, request());
  EXPECT_EQ(again.found, 3 + 2 * 4);
  EXPECT_EQ(again.rows[0].spread->intervals, summary.rows[0].spread->intervals);
}

TEST_F(Explore, AnImpossibleSampleIsRefusedBeforeAnythingIsSolved) {
  Scene scene = small_exploration("rotation_deg: [0, 40], stages: skin");
  scene.explore->vary.emplace().uncertain = {{Uncertain::What::poisson, "", 0.5, 3, 0}};
  EXPECT_THROW(explore(scene, request()), InputError);
}

// The vein comes straight from above: the least twist lies between the listed rotations.
TEST_F(Explore, ARefinedOptionIsBetterAndKeptLikeOthers) {
  const Scene scene = small_exploration("rotation_deg: [-60, 100], stages: [rod, skin], best: 1");
  Scene refined = scene;
  refined.explore->refine = RefineSpec{12, 1};
  const ExploreSummary plain = explore(scene, request("plain")),
                       found = explore(refined, request());
  EXPECT_TRUE(found.finished);
  ASSERT_GT(found.rows.size(), 2U);
  EXPECT_LE(found.rows.size(), 2U + 12);
  const Row& best = found.rows.front().row;
  EXPECT_TRUE(best.refined);
  EXPECT_LT(found.rows.front().score, plain.rows.front().score);
  const double degrees = std::stod(best.values.front().second);
  EXPECT_GT(degrees, -60);
  EXPECT_LT(degrees, 100);
  EXPECT_EQ(best.fidelity, "skin");
  EXPECT_TRUE(fs::exists(folder / "dir" / best.folder / "result.json"));
  EXPECT_EQ(std::count_if(found.rows.begin(), found.rows.end(),
                          [](const RankedRow& one) { return !one.row.refined; }),
            2);
  const ExploreSummary again = explore(refined, request());
  const auto refined_stage =
      std::count_if(found.rows.begin(), found.rows.end(),
                    [](const RankedRow& one) { return one.row.fidelity == "skin"; });
  EXPECT_EQ(again.found, 2 + refined_stage);  // at rod, and at skin
  EXPECT_EQ(again.rows.front().row.option, best.option);
}

// As on a cluster: a list, one process for each option, the next list, then the table.
TEST_F(Explore, OptionsSolvedOneByOneAreFoundByTheWhole) {
  const Scene scene = small_exploration("rotation_deg: [0, 60, 90], stages: [rod, skin], best: 2");
  const auto first = stage_options(scene, request(), 0);
  ASSERT_EQ(first.size(), 3U);
  EXPECT_THROW(stage_options(scene, request(), 1), InputError);  // the first is not finished
  for (const std::string& name : first) explore_one(scene, request(), name);
  const auto second = stage_options(scene, request(), 1);
  ASSERT_EQ(second.size(), 2U);
  for (const std::string& name : second) explore_one(scene, request(), name);
  explore_one(scene, request(), second[0]);  // finished already
  EXPECT_THROW(stage_options(scene, request(), 2), InputError);
  EXPECT_THROW(explore_one(scene, request(), "0123456789abcdef-skin"), InputError);
  const ExploreSummary jobs = explore(scene, request()), whole = explore(scene, request("whole"));
  EXPECT_EQ(jobs.found, 5);
  ASSERT_EQ(jobs.rows.size(), whole.rows.size());
  for (std::size_t k = 0; k < whole.rows.size(); ++k) {
    EXPECT_EQ(jobs.rows[k].row.option, whole.rows[k].row.option) << k;
    EXPECT_EQ(jobs.rows[k].row.criteria, whole.rows[k].row.criteria) << k;
    EXPECT_EQ(jobs.rows[k].row.folder, whole.rows[k].row.folder) << k;
  }
}

TEST_F(Explore, AFileSystemThatRefusesEndsItWithItsSentence) {
  // A file of the user where a kept result would be.
  const Scene scene = small_exploration("rotation_deg: [0], stages: skin");
  const ExploreSummary summary = explore(scene, request());
  const fs::path kept = folder / "dir" / summary.rows[0].row.folder;
  fs::remove_all(kept);
  std::ofstream(kept) << "mine";
  try {
    explore(scene, request());
    ADD_FAILURE() << "expected a FileError";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("is a file"), std::string::npos) << error.what();
  }
}

TEST_F(Explore, ASceneWithoutOptionsIsRefused) {
  Scene scene = small_exploration("rotation_deg: [0]");
  scene.explore.reset();
  EXPECT_THROW(explore(scene, request()), InputError);
  EXPECT_FALSE(fs::exists(folder / "dir"));
}

}  // namespace
}  // namespace vasorod::testing
