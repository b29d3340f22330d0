#include <gtest/gtest.h>

#include "result/example_result.h"
#include "result/unknown_validity.h"

namespace vasorod {
namespace {

TEST(UnknownValidity, AStateThatIsNoSolutionIsNeitherInRangeNorOutOfIt) {
  for (const Status status : {Status::interrupted, Status::iteration_limit, Status::unstable})
    for (const bool in_range : {true, false}) {
      Result result = test::example_result();
      result.status = status;
      result.validity.in_range = in_range;
      EXPECT_FALSE(known_range(result)) << to_string(status);
      EXPECT_NE(why_unknown(status).find("validity is unknown"), std::string::npos);
    }
}

TEST(UnknownValidity, OfASolutionItIsWhatWasJudged) {
  for (const Status status :
       {Status::converged, Status::equilibrium_only, Status::buckled, Status::not_unique})
    for (const bool in_range : {true, false}) {
      Result result = test::example_result();
      result.status = status;
      result.validity.in_range = in_range;
      EXPECT_EQ(known_range(result), in_range) << to_string(status);
      EXPECT_EQ(why_unknown(status), "");
    }
}

TEST(UnknownValidity, AFitPredictsNothingThatCouldBeInRange) {
  Result result = test::example_result();
  result.fit = FitReport{};
  EXPECT_FALSE(known_range(result));
}

}  // namespace
}  // namespace vasorod
