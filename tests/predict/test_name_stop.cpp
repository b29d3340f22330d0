#include <gtest/gtest.h>

#include "predict/name_stop.h"

namespace vasorod {
namespace {

TEST(NameStop, SaysByWhatAndWhere) {
  Result result;
  result.status = Status::interrupted;
  result.certificate.notes = {"of something else"};
  name_stop(time_limit_of(5), "walls, iteration 30", result);
  ASSERT_EQ(result.certificate.notes.size(), 2U);
  EXPECT_EQ(result.certificate.notes[1],
            "stopped by the time limit of 5 s at \"walls, iteration 30\", before there was an "
            "equilibrium; this is the best state so far, expected more time or a cheaper fidelity");
}

TEST(NameStop, SaysThatOtherWaysWereBeingTried) {
  for (const Status status :
       {Status::self_intersecting, Status::iteration_limit, Status::unstable}) {
    Result result;
    result.status = status;
    name_stop("the caller", "walls", result);
    ASSERT_EQ(result.certificate.notes.size(), 1U) << to_string(status);
    EXPECT_EQ(result.certificate.notes[0],
              "the search for a better state was stopped by the caller at \"walls\"; with more "
              "time another way may end well");
  }
  for (const Status status : {Status::converged, Status::buckled, Status::equilibrium_only}) {
    Result result;
    result.status = status;
    name_stop("the caller", "walls", result);
    EXPECT_TRUE(result.certificate.notes.empty()) << to_string(status);
  }
}

}  // namespace
}  // namespace vasorod
