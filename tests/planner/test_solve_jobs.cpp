#include <vasorod/predict.h>

#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

class SolveJobsTest : public SmallScene {
 protected:
  const std::shared_ptr<const OpenedScene> scene = opened();
  ResultShelf shelf;
  SolveJobs jobs{shelf};
  Plan plan = *scene->plan;
};

Json ended(SolveJobs& jobs, const std::string& id) {
  Json status = jobs.status(id, std::chrono::milliseconds(0));
  for (int k = 0; k < 1000 && status["state"] == "running"; ++k)
    status = jobs.status(id, std::chrono::milliseconds(1000));
  return status;
}

TEST_F(SolveJobsTest, TheResultIsThatOfTheLibrary) {
  plan.cut_along = 0.8;
  const Json status = ended(jobs, jobs.begin(scene, plan, "skin"));
  ASSERT_EQ(status["state"], "done") << status;
  EXPECT_EQ(status["fidelity"], "skin");
  EXPECT_TRUE(status["error"].is_null());
  const auto stored = shelf.find(status["result"]);
  SolveOptions options;
  options.fidelity = "skin";
  const Result own = predict(with_plan(*scene, plan, "skin"), options);
  ASSERT_EQ(stored->result.vessels.size(), own.vessels.size());
  for (std::size_t v = 0; v < own.vessels.size(); ++v)
    EXPECT_EQ(stored->result.vessels[v].current, own.vessels[v].current);
  EXPECT_EQ(stored->plan, plan);
  EXPECT_DOUBLE_EQ(stored->to_lumen[0].value(), 0.2);  // mid-wall, 0.4 thick
}

TEST_F(SolveJobsTest, WhatCannotBeSolvedIsASentence) {
  plan.incision_along = 0.01;
  const Json status = ended(jobs, jobs.begin(scene, plan, "skin"));
  EXPECT_EQ(status["state"], "failed");
  EXPECT_NE(status["error"].get<std::string>().find("expected"), std::string::npos);
  EXPECT_TRUE(status["result"].is_null());
}

TEST_F(SolveJobsTest, TheNewestWins) {
  std::vector<std::string> ids;
  for (int k = 0; k < 20; ++k)
    ids.push_back(jobs.begin(scene, std::nullopt, k % 2 ? "skin" : "coupled"));
  EXPECT_EQ(ended(jobs, ids.back())["state"], "done");
  for (std::size_t k = 0; k + 1 < ids.size(); ++k) {
    const Json status = jobs.status(ids[k], std::chrono::milliseconds(0));
    EXPECT_EQ(status["state"], "cancelled");
    EXPECT_TRUE(status["result"].is_null());
  }
}

TEST_F(SolveJobsTest, CancellingKeepsTheLastState) {
  const std::string id = jobs.begin(scene, std::nullopt, "coupled");
  // The rods are solved first; from then on there is a state.
  Json status = jobs.status(id, std::chrono::milliseconds(0));
  const auto early = [&] {
    const std::string stage = status["stage"];
    return stage == "waiting" || stage.starts_with("surgery") || stage.starts_with("rod of");
  };
  while (status["state"] == "running" && early())
    status = jobs.status(id, std::chrono::milliseconds(1000));
  jobs.cancel(id);
  status = ended(jobs, id);
  ASSERT_EQ(status["state"], "cancelled") << status;
  const auto stored = shelf.find(status["result"]);
  EXPECT_EQ(stored->result.status, Status::interrupted);
  EXPECT_EQ(stored->result.certificate.notes.back().rfind("stopped by Cancel at ", 0), 0U);
  EXPECT_EQ(jobs.cancel(id)["state"], "cancelled");
}

TEST_F(SolveJobsTest, OnlyTheLastJobsAreKnown) {
  const std::string first = jobs.begin(scene, std::nullopt, "rod");
  for (int k = 0; k < 64; ++k) jobs.begin(scene, std::nullopt, "rod");
  for (const std::string& id :
       {first, std::string(""), std::string("j"), std::string("x1"), std::string("j1x"),
        std::string("j-1"), std::string("j99999999999999999999")})
    EXPECT_EQ(refusal_of([&] { jobs.status(id, std::chrono::milliseconds(0)); }).status, 404) << id;
}

}  // namespace
}  // namespace vasorod::planner
