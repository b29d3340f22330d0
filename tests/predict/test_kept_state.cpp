#include <cmath>

#include "predict/kept_state.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;

// The states that a prediction hands out on its way, made into results afterwards.
std::vector<Result> kept(const Scene& scene, Result* whole = nullptr) {
  std::vector<std::function<Result()>> states;
  SolveOptions options;
  options.keep = [&](std::function<Result()> state) { states.push_back(std::move(state)); };
  const Result result = predict(scene, options);
  if (whole) *whole = result;
  std::vector<Result> results;
  for (const auto& state : states) results.push_back(state());
  return results;
}

TEST(KeptState, BeforeTheSurfacesItIsTheSkinThatTheRodsCarry) {
  for (const std::string fidelity : {"paper", "coupled"}) {
    const std::vector<Result> states = kept(stretched_tube(0.05, fidelity));
    ASSERT_FALSE(states.empty()) << fidelity;
    const Result& first = states.front();
    const Result skin = predict(stretched_tube(0.05, "skin"));
    EXPECT_EQ(first.status, Status::interrupted);
    EXPECT_EQ(first.fidelity, fidelity);
    EXPECT_EQ(first.vessels.at(0).current, skin.vessels.at(0).current);
    EXPECT_TRUE(std::isnan(first.certificate.relative_residual)) << "unknown";
    ASSERT_FALSE(first.certificate.notes.empty());
    EXPECT_NE(first.certificate.notes.back().find("carried rigidly"), std::string::npos);
    EXPECT_TRUE(first.seconds.contains("solve"));
  }
}

// Before the first factorisation no vertex has moved off its section, and the residual says so.
TEST(KeptState, OnTheWayItHasTheSolversResidual) {
  for (const std::string fidelity : {"paper", "coupled"}) {
    Result whole;
    const std::vector<Result> states = kept(stretched_tube(0.05, fidelity), &whole);
    ASSERT_GE(states.size(), 2u) << fidelity;
    const Result& state = states[1];
    EXPECT_EQ(state.status, Status::interrupted);
    EXPECT_EQ(whole.status, Status::converged);
    EXPECT_GT(state.certificate.relative_residual, 1e-4) << fidelity;
    EXPECT_LT(whole.certificate.relative_residual, 1e-8) << fidelity;
    EXPECT_EQ(state.vessels.at(0).current.rows(), whole.vessels.at(0).current.rows());
    EXPECT_TRUE(state.vessels.at(0).current.allFinite());
    EXPECT_GT((state.vessels[0].current - whole.vessels[0].current).norm(), 1e-6) << fidelity;
  }
}

TEST(KeptState, HandingItOutChangesNothing) {
  for (const std::string fidelity : {"paper", "coupled"}) {
    Result whole;
    kept(stretched_tube(0.05, fidelity), &whole);
    const Result alone = predict(stretched_tube(0.05, fidelity));
    EXPECT_EQ(whole.vessels.at(0).current, alone.vessels.at(0).current) << fidelity;
    EXPECT_EQ(whole.energy.total(), alone.energy.total()) << fidelity;
    EXPECT_EQ(whole.iterations, alone.iterations) << fidelity;
  }
}

TEST(KeptState, StoppedWithoutPatienceThereIsNone) {
  SolveOptions options;
  options.stop = [] { return true; };
  options.patience = 0;
  try {
    predict(stretched_tube(0.05, "paper"), options);
    ADD_FAILURE() << "a result";
  } catch (const StoppedEarly& error) {
    EXPECT_NE(std::string(error.what()).find("reading vessel aorta"), std::string::npos)
        << error.what();
  }
}

TEST(KeptState, SolvedIsToldOnceAfterTheLastState) {
  std::string order;
  SolveOptions options;
  options.keep = [&](const std::function<Result()>&) { order += 'k'; };
  options.solved = [&] { order += 's'; };
  predict(stretched_tube(0.05, "paper"), options);
  EXPECT_EQ(order.find('s'), order.size() - 1) << order;
}

}  // namespace
}  // namespace vasorod
