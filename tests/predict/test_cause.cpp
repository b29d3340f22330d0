#include <gtest/gtest.h>
#include <new>
#include <stdexcept>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "predict/caught.h"
#include "predict/cause.h"
#include "predict/memory_need.h"

namespace vasorod {
namespace {

const auto of = [](const auto& error) { return testing::caught(error, cause_now); };

TEST(Cause, EveryExceptionHasAKindAndASentence) {
  EXPECT_EQ(of(StoppedEarly("early")).kind, Cause::Kind::stopped);
  EXPECT_EQ(of(InputError("input")).kind, Cause::Kind::input);
  EXPECT_EQ(of(FileError("file")).kind, Cause::Kind::system);
  EXPECT_EQ(of(TooLarge("large")).kind, Cause::Kind::system);
  EXPECT_EQ(of(TooLarge("large")).sentence, "large");
  EXPECT_EQ(of(std::runtime_error("bug")).sentence, "unexpected: bug");
  EXPECT_EQ(of(3).kind, Cause::Kind::system);
  EXPECT_EQ(of(3).sentence, "unexpected: an exception without words");
}

TEST(Cause, EveryWayOfHavingNoMemoryIsTheSameSentence) {
  const std::string none = of(std::bad_alloc()).sentence;
  EXPECT_NE(none.find("found no memory left"), std::string::npos);
  EXPECT_EQ(of(std::length_error("vector")).sentence, none);
  const auto error = [](std::errc code) {
    return of(std::system_error(std::make_error_code(code))).sentence;
  };
  EXPECT_EQ(error(std::errc::resource_unavailable_try_again), none);
  EXPECT_NE(error(std::errc::permission_denied), none);
}

}  // namespace
}  // namespace vasorod
