#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "predict/chosen_fidelity.h"

namespace vasorod {
namespace {

// A fidelity that ends like this and leaves its mark.
Fidelity ending(const std::string& name, Status status, bool minimum, bool partial) {
  Fidelity fidelity;
  fidelity.name = name;
  fidelity.partial = partial;
  fidelity.solve = [=](Prediction& prediction, const SolveOptions&) {
    prediction.left_out["by " + name] = "a mark";
    prediction.work.counts.gradients += 10;
    SolvedSurfaces& surfaces = prediction.surfaces.emplace();
    surfaces.solution.status = status;
    surfaces.smallest_curvature_positive = minimum;
  };
  return fidelity;
}

struct Ended {
  Prediction prediction;
  std::string by;
  explicit Ended(const Fidelity& chosen) {
    SolveOptions options;
    options.progress = [](const std::string&) {};
    prediction.fidelity = chosen.name;
    prediction.work.counts.gradients = 1;
    const Fidelity dearest = ending("dear", Status::converged, true, false);
    by = solve_chosen(chosen, dearest, prediction, options).name;
    EXPECT_EQ(prediction.fidelity, by);
    EXPECT_EQ(prediction.left_out.count("by " + by), 1);
    EXPECT_EQ(prediction.left_out.size(), 1);
  }
};

TEST(ChosenFidelity, AMinimumIsTheAnswer) {
  for (const Status status : {Status::converged, Status::equilibrium_only}) {
    const Ended ended(ending("part", status, true, true));
    EXPECT_EQ(ended.by, "part");
    EXPECT_TRUE(ended.prediction.notes.empty());
    EXPECT_EQ(ended.prediction.work.counts.gradients, 11);
  }
  // Nor is there time for another where it was stopped.
  EXPECT_EQ(Ended(ending("part", Status::interrupted, false, true)).by, "part");
}

TEST(ChosenFidelity, WhatAPartialOneDoesNotReachTheDearestSolves) {
  for (const Status status : {Status::unstable, Status::buckled, Status::iteration_limit}) {
    const Ended ended(ending("part", status, status == Status::buckled, true));
    EXPECT_EQ(ended.by, "dear");
    ASSERT_EQ(ended.prediction.notes.size(), 1);
    EXPECT_EQ(ended.prediction.notes[0],
              "fidelity part, which the accuracy chose, was left: it ended as " +
                  to_string(status) + "; fidelity dear solves without a promise");
    EXPECT_EQ(ended.prediction.work.counts.gradients, 21);
  }
}

TEST(ChosenFidelity, WhatAPartialOneRefusesTheDearestSolves) {
  Fidelity chosen = ending("part", Status::converged, true, true);
  chosen.solve = [](Prediction& prediction, const SolveOptions&) {
    prediction.left_out["half"] = "done";
    throw InputError("a wall lies over itself");
  };
  const Ended ended(chosen);
  EXPECT_EQ(ended.by, "dear");
  EXPECT_NE(ended.prediction.notes.at(0).find("left: a wall lies over itself; fidelity dear"),
            std::string::npos);
}

TEST(ChosenFidelity, OthersAnswerThemselves) {
  EXPECT_EQ(Ended(ending("whole", Status::unstable, false, false)).by, "whole");
}

}  // namespace
}  // namespace vasorod
