#include <gtest/gtest.h>
#include <new>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "planner/body.h"
#include "planner/failure.h"
#include "predict/caught.h"

namespace vasorod::planner {
namespace {

const auto of = [](const auto& error) { return testing::caught(error, failure_now); };

TEST(Failure, EveryExceptionIsOneSentence) {
  EXPECT_EQ(of(Refusal(404, "gone")).status, 404);
  EXPECT_EQ(of(Refusal(404, "gone")).sentence, "gone");
  EXPECT_EQ(of(InputError("a\nb")).status, 400);
  EXPECT_EQ(of(InputError("a\nb")).sentence, "a\\nb");
  EXPECT_EQ(of(FileError("disk")).status, 500);
  EXPECT_EQ(of(StoppedEarly("stopped")).sentence, "stopped");
  EXPECT_NE(of(std::bad_alloc()).sentence.find("memory"), std::string::npos);
  EXPECT_NE(of(std::length_error("vector")).sentence.find("memory"), std::string::npos);
  EXPECT_EQ(of(std::logic_error("bug")).sentence, "unexpected: bug");
  EXPECT_EQ(of(3).status, 500);
}

}  // namespace
}  // namespace vasorod::planner
