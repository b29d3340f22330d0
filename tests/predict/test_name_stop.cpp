#include <gtest/gtest.h>

#include "predict/name_stop.h"

namespace vasorod {
namespace {

TEST(NameStop, SaysByWhatAndWhere) {
  Result result;
  result.certificate.notes = {"of something else"};
  name_stop(time_limit_of(5), "walls, iteration 30", result);
  ASSERT_EQ(result.certificate.notes.size(), 2U);
  EXPECT_EQ(result.certificate.notes[1],
            "stopped by the time limit of 5 s at \"walls, iteration 30\", before there was an "
            "equilibrium; this is the best state so far, expected more time or a cheaper fidelity");
}

}  // namespace
}  // namespace vasorod
